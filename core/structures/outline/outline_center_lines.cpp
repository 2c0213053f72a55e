// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/structures/outline/outline_center_lines.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

#include "core/base/sum.h"
#include "core/structures/filters/paths/branch_pruning.h"

namespace mes {
namespace {

Bank bank_of(const OutlineFeature& feature) {
  return {.sample = feature.from, .neighbours = {feature.to, feature.to}, .is_side = true, .center = feature.center};
}

/// The edges of the axis, those between junctions as one branch. Each edge that leads to the outline has an end of its own
/// there, since shapes may meet at a vertex.
class OutlineNetwork final : public AxisNetwork {
 public:
  explicit OutlineNetwork(const OutlineAxis& axis) : axis_(axis), first_piece_(axis.graph().edges.size() + 1) {
    const OutlineGraph& graph = axis.graph();
    for (const OutlinePiece& piece : axis.pieces()) ++first_piece_[piece.edge.index() + 1];
    for (std::size_t i = 1; i < first_piece_.size(); ++i) first_piece_[i] += first_piece_[i - 1];
    for (const OutlineNode& node : graph.nodes) add_node(node.center, node.radius);
    std::vector<PathEdge> edges;
    for (const OutlineEdgeSlot slot : graph.edges.rows()) {
      const auto& [from, to] = graph.edges[slot].nodes;
      edges.push_back({end_at(from), end_at(to), length_of_edge(slot)});
    }
    const PathGraph whole(nodes_.size(), std::move(edges));
    MergedBranches merged = merge_branches(whole, std::vector<std::uint8_t>(whole.edges().size(), 1));
    branches_ = std::move(merged.edges);
    chains_ = std::move(merged.chains);
  }

  void append(std::size_t branch, bool is_backwards, CenterLine& line) const override {
    const std::vector<PathStep>& chain = chains_[branch];
    for (std::size_t i = 0; i < chain.size(); ++i)
      append_edge(is_backwards ? chain[chain.size() - 1 - i].reversed() : chain[i], line);
  }

 private:
  std::uint32_t end_at(OutlineNodeSlot slot) {
    const OutlineNode& node = axis_.graph().nodes[slot];
    return node.radius > 0.0 ? slot.index() : add_node(node.center, 0.0);
  }

  double length_of_edge(OutlineEdgeSlot edge) const {
    Sum out;
    for (std::size_t i = first_piece_[edge.index()]; i < first_piece_[edge.index() + 1]; ++i) {
      const OutlinePiece& piece = axis_.pieces()[OutlinePieceSlot(i)];
      out.add(distance(piece.from, piece.to));
    }
    // Rounding may leave nothing of an edge, which still joins its ends.
    return std::max(out.value(), std::numeric_limits<double>::denorm_min());
  }

  void append_edge(PathStep step, CenterLine& line) const {
    const OutlineEdgeSlot slot(step.edge);
    const OutlineEdge& edge = axis_.graph().edges[slot];
    const std::array banks{bank_of(axis_.graph().features[edge.features[0]]),
                           bank_of(axis_.graph().features[edge.features[1]])};
    const std::size_t begin = first_piece_[slot.index()];
    const std::size_t count = first_piece_[slot.index() + 1] - begin;
    for (std::size_t i = 0; i < count; ++i) {
      OutlinePiece piece = axis_.pieces()[OutlinePieceSlot(begin + (step.is_backwards ? count - 1 - i : i))];
      if (step.is_backwards) std::swap(piece.from, piece.to);
      const Vec2 here = line.axis.back();
      if (piece.to == here) continue;
      const Vec2 middle = 0.5 * here + 0.5 * piece.to;
      const Vec2 across = foot_on(banks[0], middle) - foot_on(banks[1], middle);
      const bool is_first_left = cross(piece.to - here, across) >= 0.0;
      line.axis.push_back(piece.to);
      line.banks.push_back({banks[is_first_left ? 0 : 1], banks[is_first_left ? 1 : 0]});
    }
  }

  const OutlineAxis& axis_;
  std::vector<std::size_t> first_piece_;       // of each edge, and their number
  std::vector<std::vector<PathStep>> chains_;  // of each branch
};

}  // namespace

CenterLines center_lines_of(const OutlineAxis& axis, const CenterLineRequest& request, JobControl& job) {
  return center_lines_of(OutlineNetwork(axis), request, job);
}

void extend_to_outline(CenterLines& set, const OutlineAxis& axis, double most) {
  std::vector<Wall> walls;
  for (const OutlineFeature& feature : axis.graph().features)
    if (!feature.is_point()) walls.push_back({feature.from, feature.to});
  extend(set, walls, most);
}

}  // namespace mes
