// SPDX-License-Identifier: GPL-3.0-or-later
// Fourth stage of the union pipeline: v-points -> their Delaunay triangulation.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <utility>
#include <vector>

#include "core/base/geometry/box2.h"
#include "core/structures/balls/internal/crossings/union_crossings.h"
#include "core/structures/balls/internal/numbers/number_parts.h"
#include "core/structures/balls/internal/union_tables.h"

namespace mes {

/// Edges of the triangulation stand for their duals, the Voronoi edges.
struct VTriangulation {
  struct EdgeTo {
    VPointSlot to;
    VEdgeSlot edge;
  };
  bool is_flat = false;                                  ///< all v-points are collinear
  Table<VFaceSlot, std::array<VPointSlot, 3>> faces;     ///< corners, counter-clockwise
  Table<VFaceSlot, std::array<VEdgeSlot, 3>> face_edge;  ///< edge i lies opposite corner i
  Table<VEdgeSlot, VEdge> edges;
  std::vector<EdgeTo> edges_at;            ///< the edges at a v-point start at its `begin_at`
  std::vector<std::uint32_t> edges_begin;  ///< start of each v-point, and the end of all
  std::int64_t near_duplicates = 0;        ///< see `UnionCounts`

  /// O(smaller degree); kNoSlot if the two are not joined.
  VEdgeSlot edge_between(VPointSlot from, VPointSlot to) const {
    const auto degree = [this](VPointSlot v) { return end_at(v) - begin_at(v); };
    if (degree(to) < degree(from)) std::swap(from, to);
    for (std::uint32_t i = begin_at(from); i < end_at(from); ++i)
      if (edges_at[i].to == to) return edges_at[i].edge;
    return kNoSlot;
  }
  std::uint32_t begin_at(VPointSlot v) const { return edges_begin[v.index()]; }
  std::uint32_t end_at(VPointSlot v) const { return edges_begin[v.index() + std::size_t{1}]; }
};

inline std::int64_t count_near_duplicates(const Table<VEdgeSlot, VEdge>& edges,
                                          const Table<VPointSlot, Vec2>& position) {
  const auto square_of = [&position](const VEdge& edge) {
    const Vec2 d = position[edge.v[1]] - position[edge.v[0]];
    return dot(d, d);
  };
  // No edge is longer than the diagonal, so these hold all edges that are short against the longest.
  Box2 box;
  for (const Vec2 v : position) box.add(v);
  const double diagonal = dot(box.high - box.low, box.high - box.low);
  std::vector<double> short_squares;
  double longest = 0.0;
  for (const VEdge& edge : edges) {
    const double square = square_of(edge);
    longest = std::max(longest, square);
    if (square < 1e-14 * diagonal) short_squares.push_back(square);
  }
  return std::ranges::count_if(short_squares, [longest](double square) { return square < 1e-14 * longest; });
}

/// Fills in `edges_at` and `edges_begin`.
inline void list_edges_at_points(std::size_t points, VTriangulation& out) {
  out.edges_begin.assign(points + 1, 0);
  for (const VEdge& edge : out.edges)
    for (const VPointSlot v : edge.v) ++out.edges_begin[v.index()];
  std::uint32_t end = 0;
  for (std::uint32_t& begin : out.edges_begin) begin = end += begin;
  out.edges_at.resize(end);
  for (std::size_t i = out.edges.size(); i-- > 0;) {
    const VEdgeSlot e(i);
    const auto& v = out.edges[e].v;
    out.edges_at[--out.edges_begin[v[0].index()]] = {v[1], e};
    out.edges_at[--out.edges_begin[v[1].index()]] = {v[0], e};
  }
}

template <class Points>
VTriangulation v_triangulation(const VPoints<Points>& points) {
  VTriangulation out;
  const auto& faces = points.triangulation.faces;
  const auto& row = points.row_of_crossing;
  out.is_flat = points.triangulation.dimension != 2;
  out.faces.resize(faces.size());
  out.face_edge.resize(faces.size());
  out.edges.reserve(3 * points.rows.size());
  for (const auto& [from, to] : points.triangulation.line) out.edges.push_back({{row[from], row[to]}});
  for (const TriangleSlot triangle : faces.rows()) {
    const auto f = same_row<VFaceSlot>(triangle);
    auto& v = out.faces[f];
    for (std::size_t i = 0; i < 3; ++i) v[i] = row[faces[triangle].v[i]];
    for (std::size_t i = 0; i < 3; ++i) {
      const TriangleSlot beyond = faces[triangle].n[i];
      if (beyond < triangle) continue;
      const auto g = same_row<VFaceSlot>(beyond);
      const VEdgeSlot edge = out.edges.next();
      out.edges.push_back({{v[(i + 1) % 3], v[(i + 2) % 3]}, {f, g}});
      out.face_edge[f][i] = edge;
      if (g == kNoSlot) continue;
      const auto& n = faces[beyond].n;
      out.face_edge[g][n[0] == triangle ? 0 : (n[1] == triangle ? 1 : 2)] = edge;
    }
  }
  NumberParts<typename Points::FT>::both(
      out.edges.size(), [&] { out.near_duplicates = count_near_duplicates(out.edges, points.local); },
      [&] { list_edges_at_points(points.rows.size(), out); });
  return out;
}

}  // namespace mes
