// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/store/texts/internal/segment_chains.h"

#include <array>
#include <map>
#include <utility>

#include "core/draw/primitive_values.h"

namespace mes {
namespace {

/// Points numbered by first appearance, and the edges between them.
struct PointGraph {
  std::vector<Vec2> points;
  std::vector<std::array<std::uint32_t, 2>> edges;
  std::vector<std::uint32_t> segment;  // by edge
};

PointGraph graph_of(std::span<const double> segments) {
  struct Less {
    bool operator()(Vec2 a, Vec2 b) const { return lexicographically_less(a, b); }
  };
  PointGraph graph;
  std::map<Vec2, std::uint32_t, Less> number;
  const auto number_of = [&](Vec2 p) {
    const auto [found, is_new] = number.try_emplace(p, static_cast<std::uint32_t>(graph.points.size()));
    if (is_new) graph.points.push_back(p);
    return found->second;
  };
  for (std::size_t at = 0; at < segments.size(); at += stride_of(PrimitiveKind::segment)) {
    const double* const v = segments.data() + at;
    const std::uint32_t a = number_of({v[0], v[1]});
    const std::uint32_t b = number_of({v[2], v[3]});
    if (a == b) continue;
    graph.edges.push_back({a, b});
    graph.segment.push_back(static_cast<std::uint32_t>(at / stride_of(PrimitiveKind::segment)));
  }
  return graph;
}

/// Finds maximal chains between points that do not have exactly two edges, then the remaining closed ones.
class ChainFinder {
 public:
  explicit ChainFinder(const PointGraph& graph) : graph_(graph), at_(graph.points.size()), used_(graph.edges.size()) {
    for (std::uint32_t edge = 0; edge < graph.edges.size(); ++edge)
      for (const std::uint32_t point : graph.edges[edge]) at_[point].push_back(edge);
  }

  std::vector<SegmentChain> find() {
    std::vector<SegmentChain> chains;
    for (const bool only_ends : {true, false}) {
      for (std::uint32_t point = 0; point < at_.size(); ++point) {
        if (only_ends && at_[point].size() == 2) continue;
        for (const std::uint32_t edge : at_[point])
          if (!used_[edge]) chains.push_back(follow(point, edge));
      }
    }
    return chains;
  }

 private:
  SegmentChain follow(std::uint32_t start, std::uint32_t edge) {
    SegmentChain chain{false, {start}, {}};
    for (std::uint32_t point = start;;) {
      used_[edge] = true;
      chain.segments.push_back(graph_.segment[edge]);
      const auto& ends = graph_.edges[edge];
      point = ends[0] == point ? ends[1] : ends[0];
      if (point == start) {
        chain.closed = true;
        return chain;
      }
      chain.points.push_back(point);
      if (at_[point].size() != 2) return chain;
      edge = at_[point][0] == edge ? at_[point][1] : at_[point][0];
      if (used_[edge]) return chain;
    }
  }

  const PointGraph& graph_;
  std::vector<std::vector<std::uint32_t>> at_;
  std::vector<bool> used_;
};

}  // namespace

std::vector<double> segments_of(const LayerMirror& mirror, LayerIndex layer, ParabolasAs parabolas) {
  constexpr std::size_t kStride = stride_of(PrimitiveKind::parabola);
  const std::span<const double> segments = mirror.instances(layer, PrimitiveKind::segment);
  std::vector<double> out(segments.begin(), segments.end());
  const std::span<const double> curved = mirror.instances(layer, PrimitiveKind::parabola);
  for (std::size_t at = 0; at < curved.size(); at += kStride) {
    const ParabolaArc arc = parabola_of(curved.data() + at);
    const std::vector<Vec2> corners =
        parabolas == ParabolasAs::chains ? corners_of(arc) : std::vector<Vec2>{arc.from, arc.to};
    for (std::size_t i = 1; i < corners.size(); ++i)
      out.insert(out.end(),
                 {corners[i - 1].x, corners[i - 1].y, corners[i].x, corners[i].y, curved[at + kStride - 1]});
  }
  return out;
}

SegmentChains chains_of(std::span<const double> segments) {
  PointGraph graph = graph_of(segments);
  std::vector<SegmentChain> chains = ChainFinder(graph).find();
  return {std::move(graph.points), std::move(chains)};
}

}  // namespace mes
