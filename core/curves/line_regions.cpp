// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/curves/line_regions.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <utility>

#include "core/base/disjoint_sets.h"
#include "core/curves/internal/network.h"
#include "core/curves/joined_ends.h"

namespace mes {
namespace {

/// The arcs of a network and the faces between them. Half edge 2 a runs along arc a, and 2 a + 1 runs back.
class Faces {
 public:
  explicit Faces(const CurveNetwork& network) : network_(network) {
    for (const auto& ends : network.nodes)
      for (const std::uint32_t node : ends)
        if (node != CurveNetwork::kNoNode) node_count_ = std::max<std::size_t>(node_count_, node + std::size_t{1});
    count_uses();
    find_enclosing_arcs();
    find_meshes();
    trace_faces();
    find_parities();
  }

  bool is_empty() const {
    return std::ranges::none_of(is_in_mesh_, [](bool in) { return in; });
  }
  bool is_in_mesh(std::uint32_t arc) const { return is_in_mesh_[arc]; }
  /// For each face inside, its half edges in order, with the face on the left.
  std::vector<std::vector<std::uint32_t>> inside() const {
    std::vector<std::vector<std::uint32_t>> out;
    for (const Face& face : faces_)
      if (is_inside(face)) out.push_back(face.edges);
    return out;
  }
  /// True if neither side is inside and the arc is on no closed curve.
  bool is_left_open(std::uint32_t arc) const {
    if (closed_uses_[arc] != 0) return false;
    if (!is_in_mesh_[arc]) return true;
    return !is_inside(faces_[face_of_[2 * arc]]) && !is_inside(faces_[face_of_[2 * arc + 1]]);
  }

 private:
  struct Face {
    std::vector<std::uint32_t> edges{};
    double area = 0.0;  ///< doubled; negative for the outer face
    std::uint32_t mesh = 0;
    bool is_odd = false;
    bool is_reached = false;
  };

  std::uint32_t from(std::uint32_t edge) const { return network_.nodes[edge / 2][edge % 2]; }
  std::uint32_t to(std::uint32_t edge) const { return from(edge ^ 1U); }
  bool is_inside(const Face& face) const { return face.area > 0.0 && (face.is_odd || !has_closed_[face.mesh]); }

  void count_uses() {
    closed_uses_.assign(network_.arcs.size(), 0);
    for (const CurveNetwork::Walk& walk : network_.walks)
      if (walk.is_closed)
        for (const CurveNetwork::Step& step : walk.steps) ++closed_uses_[step.arc];
  }

  /// Arcs that lead to a dead end enclose nothing.
  void find_enclosing_arcs() {
    const std::size_t count = network_.arcs.size();
    is_in_mesh_.assign(count, false);
    std::vector<std::vector<std::uint32_t>> at(node_count_);
    std::vector<std::size_t> degree(node_count_, 0);
    for (std::uint32_t arc = 0; arc < count; ++arc) {
      if (network_.nodes[arc][0] == CurveNetwork::kNoNode) continue;
      is_in_mesh_[arc] = true;
      for (const std::uint32_t node : network_.nodes[arc]) {
        at[node].push_back(arc);
        ++degree[node];
      }
    }
    std::vector<std::uint32_t> ends;
    for (std::uint32_t node = 0; node < node_count_; ++node)
      if (degree[node] == 1) ends.push_back(node);
    while (!ends.empty()) {
      const std::uint32_t node = ends.back();
      ends.pop_back();
      for (const std::uint32_t arc : at[node]) {
        if (!is_in_mesh_[arc]) continue;
        is_in_mesh_[arc] = false;
        for (const std::uint32_t end : network_.nodes[arc])
          if (--degree[end] == 1) ends.push_back(end);
      }
    }
  }

  /// Finds connected components of arcs; components without open curves do not change.
  void find_meshes() {
    DisjointSets<std::uint32_t> sets(node_count_);
    const auto root = [&](std::uint32_t arc) { return sets.root(network_.nodes[arc][0]); };
    for (std::uint32_t arc = 0; arc < is_in_mesh_.size(); ++arc)
      if (is_in_mesh_[arc]) sets.join(root(arc), sets.root(network_.nodes[arc][1]));
    std::vector<bool> has_open(node_count_, false);
    has_closed_.assign(node_count_, false);
    mesh_of_.assign(is_in_mesh_.size(), 0);
    for (std::uint32_t arc = 0; arc < is_in_mesh_.size(); ++arc) {
      if (!is_in_mesh_[arc]) continue;
      mesh_of_[arc] = root(arc);
      (closed_uses_[arc] == 0 ? has_open : has_closed_)[mesh_of_[arc]] = true;
    }
    for (std::uint32_t arc = 0; arc < is_in_mesh_.size(); ++arc)
      if (is_in_mesh_[arc] && !has_open[mesh_of_[arc]]) is_in_mesh_[arc] = false;
  }

  /// Direction of a half edge: its tangent, then a point a little farther on to break ties.
  std::pair<double, double> direction(std::uint32_t edge) const {
    const PlaneCurve& arc = network_.arcs[edge / 2];
    Piece end;
    bool is_first = true;
    arc.for_each_piece([&](const Piece& piece) {
      if (is_first || edge % 2 == 1) end = piece;
      is_first = false;
    });
    constexpr double kFarther = 0.1;
    const Vec2 tangent = edge % 2 == 0 ? end.first_direction() : -end.last_direction();
    const Vec2 chord = edge % 2 == 0 ? end.at(kFarther) - end.from() : end.at(1.0 - kFarther) - end.to();
    return {std::atan2(tangent.y, tangent.x), std::atan2(cross(tangent, chord), dot(tangent, chord))};
  }

  void trace_faces() {
    const std::size_t edges = 2 * network_.arcs.size();
    std::vector<std::pair<double, double>> directions(edges);
    std::vector<std::vector<std::uint32_t>> around(node_count_);
    for (std::uint32_t edge = 0; edge < edges; ++edge) {
      if (!is_in_mesh_[edge / 2]) continue;
      directions[edge] = direction(edge);
      around[from(edge)].push_back(edge);
    }
    std::vector<std::uint32_t> next(edges, CurveNetwork::kNoNode);
    for (std::vector<std::uint32_t>& leaving : around) {
      std::ranges::sort(leaving, {}, [&](std::uint32_t edge) { return std::pair(directions[edge], edge); });
      // An incoming half edge is followed by the next one clockwise from its twin, so that faces lie on the left.
      for (std::size_t i = 0; i < leaving.size(); ++i)
        next[leaving[i] ^ 1U] = leaving[(i + leaving.size() - 1) % leaving.size()];
    }
    face_of_.assign(edges, CurveNetwork::kNoNode);
    for (std::uint32_t first = 0; first < edges; ++first) {
      if (!is_in_mesh_[first / 2] || face_of_[first] != CurveNetwork::kNoNode) continue;
      Face& face = faces_.emplace_back();
      face.mesh = mesh_of_[first / 2];
      for (std::uint32_t edge = first; face_of_[edge] == CurveNetwork::kNoNode; edge = next[edge]) {
        face_of_[edge] = static_cast<std::uint32_t>(faces_.size() - 1);
        face.edges.push_back(edge);
        face.area += edge % 2 == 0 ? area_under(edge / 2) : -area_under(edge / 2);
      }
    }
  }

  /// Twice the signed area between the arc and a common origin.
  double area_under(std::uint32_t arc) const {
    const Vec2 origin = network_.arcs.front().start();
    double sum = 0.0;
    network_.arcs[arc].for_each_piece([&](const Piece& piece) {
      const int parts = piece.kind == PieceKind::line ? 1 : 32;
      Vec2 before = piece.from() - origin;
      for (int i = 1; i <= parts; ++i) {
        const Vec2 here = piece.at(static_cast<double>(i) / parts) - origin;
        sum += cross(before, here);
        before = here;
      }
    });
    return sum;
  }

  /// Propagates from the outer face of each mesh; the parity flips at arcs that an odd number of closed curves use.
  void find_parities() {
    std::vector<std::uint32_t> queue;
    for (std::uint32_t i = 0; i < faces_.size(); ++i) {
      if (faces_[i].area > 0.0) continue;
      faces_[i].is_reached = true;
      queue.push_back(i);
    }
    while (!queue.empty()) {
      const std::uint32_t at = queue.back();
      queue.pop_back();
      for (const std::uint32_t edge : faces_[at].edges) {
        Face& other = faces_[face_of_[edge ^ 1U]];
        if (std::exchange(other.is_reached, true)) continue;
        other.is_odd = faces_[at].is_odd != (closed_uses_[edge / 2] % 2 == 1);
        queue.push_back(face_of_[edge ^ 1U]);
      }
    }
  }

  const CurveNetwork& network_;
  std::size_t node_count_ = 0;
  std::vector<std::size_t> closed_uses_;  // for each arc
  std::vector<bool> is_in_mesh_;          // for each arc
  std::vector<std::uint32_t> mesh_of_;    // for each arc in a mesh
  std::vector<bool> has_closed_;          // indexed by mesh
  std::vector<std::uint32_t> face_of_;    // for each half edge
  std::vector<Face> faces_;
};

PlaneCurve curve_along(const CurveNetwork& network, const std::vector<std::uint32_t>& edges) {
  const auto along = [&](std::uint32_t edge) {
    return edge % 2 == 0 ? network.arcs[edge / 2] : reversed(network.arcs[edge / 2]);
  };
  PlaneCurve out = along(edges.front());
  for (std::size_t i = 1; i < edges.size(); ++i)
    along(edges[i]).for_each_piece([&out](const Piece& piece) { out.add(piece); });
  out.close();
  return out;
}

}  // namespace

std::vector<PlaneCurve> with_line_regions(std::vector<PlaneCurve> curves, double resolution, JobControl* job) {
  if (curves.size() < 2 || std::ranges::all_of(curves, &PlaneCurve::is_closed)) return curves;
  const auto network = network_of(curves, resolution, job);
  if (!network) return curves;
  const Faces faces(*network);
  if (faces.is_empty()) return curves;
  std::vector<PlaneCurve> out;
  std::vector<bool> is_done(network->arcs.size(), false);
  std::vector<std::uint32_t> open;
  for (const CurveNetwork::Walk& walk : network->walks) {
    const auto in_mesh = [&](const CurveNetwork::Step& step) { return faces.is_in_mesh(step.arc); };
    if (std::ranges::none_of(walk.steps, in_mesh)) {
      out.push_back(curve_of(*network, walk));
      continue;
    }
    for (const CurveNetwork::Step& step : walk.steps)
      if (!is_done[step.arc] && faces.is_left_open(step.arc)) {
        is_done[step.arc] = true;
        open.push_back(step.arc);
      }
  }
  for (const std::vector<std::uint32_t>& face : faces.inside()) out.push_back(curve_along(*network, face));
  for (const std::uint32_t arc : open) out.push_back(network->arcs[arc]);
  return out;
}

}  // namespace mes
