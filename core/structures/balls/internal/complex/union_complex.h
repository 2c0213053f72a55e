// SPDX-License-Identifier: GPL-3.0-or-later
// Second stage of the union pipeline: regular triangulation -> dual complex.
#pragma once

#include <algorithm>
#include <cstdint>
#include <vector>

#include "core/base/jobs/job_control.h"
#include "core/structures/balls/internal/complex/union_triangulation.h"
#include "core/structures/balls/internal/numbers/union_balls.h"
#include "core/structures/balls/internal/union_tables.h"

namespace mes {

/// Triangles of radius zero about one centre.
using ZeroGroupSlot = Slot<struct ZeroGroupTag>;

/// Contains triangles by the sign of their orthogonal radius, edges by their triangles or by themselves.
struct DualComplex {
  static constexpr std::int8_t kInfinite = 2;

  Table<DualEdgeSlot, DualEdge> edges;
  Table<DualFaceSlot, DualFace> faces;
  Table<RegularEdgeSlot, DualEdgeSlot> row_of_edge;  ///< kNoSlot = not in the complex
  Table<TriangleSlot, std::int8_t> face_sign;        ///< sign of the orthogonal radius, or `kInfinite`
  Table<TriangleSlot, ZeroGroupSlot> zero_group;     ///< triangles of radius zero about one centre; kNoSlot = none
  std::size_t zero_groups = 0;                       ///< how many groups there are
  std::int64_t finite_faces = 0;                     ///< finite faces of the triangulation
  std::int64_t sign_flips = 0;                       ///< see `UnionCounts`
  std::int64_t negative_faces = 0;                   ///< see `UnionCounts`
  std::int64_t edges_without_sample = 0;             ///< see `UnionCounts`

  /// True if the complex has this triangle.
  bool has(TriangleSlot face) const { return face != kNoSlot && face_sign[face] <= 0; }
};

/// Fills in `face_sign`, `faces` and their counters.
template <class Balls, class Points>
void classify_faces(const UnionBalls<Balls, Points>& balls, const UnionTriangulation& triangulation, JobControl& job,
                    DualComplex& out) {
  const auto& faces = triangulation.tables.faces;
  out.face_sign.assign(faces.size(), DualComplex::kInfinite);
  Table<TriangleSlot, std::uint8_t> has_sample(faces.size(), 0);
  const auto judge = [&](TriangleSlot f) {
    if (triangulation.is_infinite(f)) return;
    const auto& v = faces[f].v;
    has_sample[f] = common_sample(balls.input[v[0]], balls.input[v[1]], balls.input[v[2]]) != nullptr ? 1 : 0;
    out.face_sign[f] = 0;
    if (balls.kKnowsSamples && has_sample[f] != 0) return;
    out.face_sign[f] = static_cast<std::int8_t>(
        sign_of_orthogonal_radius<Balls>(balls.in_balls[v[0]], balls.in_balls[v[1]], balls.in_balls[v[2]]));
  };
  balls.in_parts(faces.size(), [&](std::size_t begin, std::size_t end, std::size_t) {
    for (const TriangleSlot f : slots_between<TriangleSlot>(begin, end)) {
      if ((f.index() & 0xffU) == 0) job.checkpoint(f.index() - begin, end - begin);
      judge(f);
    }
  });
  job.checkpoint();
  out.faces.reserve(
      static_cast<std::size_t>(std::ranges::count_if(out.face_sign, [](int sign) { return sign <= 0; })));
  for (const TriangleSlot f : faces.rows()) {
    if (triangulation.is_infinite(f)) continue;
    ++out.finite_faces;
    const auto& v = faces[f].v;
    const int sign = out.face_sign[f];
    const bool touches_sample = has_sample[f] != 0;
    if (touches_sample && sign != 0) ++out.sign_flips;
    if (sign < 0 && !touches_sample) ++out.negative_faces;
    if (sign > 0) continue;
    out.faces.push_back({{balls.input[v[0]].row, balls.input[v[1]].row, balls.input[v[2]].row},
                         static_cast<std::int8_t>(sign),
                         has_sample[f]});
  }
}

/// Groups triangles of radius zero that share their centre: for Voronoi balls, those around a sample.
template <class Balls, class Points>
void group_zero_faces(const UnionBalls<Balls, Points>& balls, const RegularTables& tables, DualComplex& out) {
  out.zero_group.assign(tables.faces.size(), kNoSlot);
  const auto& ball = balls.in_balls;
  std::vector<TriangleSlot> stack;
  for (const TriangleSlot seed : tables.faces.rows()) {
    if (out.face_sign[seed] != 0 || out.zero_group[seed] != kNoSlot) continue;
    const ZeroGroupSlot group(out.zero_groups++);
    out.zero_group[seed] = group;
    stack.assign(1, seed);
    while (!stack.empty()) {
      const TriangleSlot f = stack.back();
      stack.pop_back();
      const auto& v = tables.faces[f].v;
      for (const TriangleSlot g : tables.faces[f].n) {
        if (g == kNoSlot || out.face_sign[g] != 0 || out.zero_group[g] != kNoSlot) continue;
        InputSlot other;
        for (const InputSlot c : tables.faces[g].v)
          if (c != v[0] && c != v[1] && c != v[2]) other = c;
        if (other == kNoSlot) continue;
        if (!(balls.kKnowsSamples && balls.have_common_sample(v, other)) &&
            !have_common_center<Balls>(ball[v[0]], ball[v[1]], ball[v[2]], ball[other]))
          continue;
        out.zero_group[g] = group;
        stack.push_back(g);
      }
    }
  }
}

/// The number of triangles of the complex at an edge of the triangulation; -1 if the edge itself is not in it.
template <class Balls, class Points>
std::int8_t dual_triangles_at(const UnionBalls<Balls, Points>& balls, const UnionTriangulation& triangulation,
                              const DualComplex& complex, const RegularTables::Edge& edge) {
  std::int8_t triangles = 0;
  for (const TriangleSlot f : edge.f)
    if (complex.has(f)) ++triangles;
  if (triangles != 0) return triangles;
  const auto& a = balls.in_balls[edge.v[0]];
  const auto& b = balls.in_balls[edge.v[1]];
  for (const TriangleSlot f : edge.f) {
    if (f == kNoSlot || triangulation.is_infinite(f)) continue;
    for (const InputSlot c : triangulation.tables.faces[f].v)
      if (c != edge.v[0] && c != edge.v[1] && sign_of_excess_at_foot<Balls>(a, b, balls.in_balls[c]) < 0) return -1;
  }
  return sign_of_edge_radius<Balls>(a, b) > 0 ? std::int8_t{-1} : std::int8_t{0};
}

/// Fills in `edges`, `row_of_edge` and their counters.
template <class Balls, class Points>
void classify_edges(const UnionBalls<Balls, Points>& balls, const UnionTriangulation& triangulation,
                    DualComplex& out) {
  const auto& edges = triangulation.tables.edges;
  out.row_of_edge.assign(edges.size(), kNoSlot);
  out.edges.reserve(edges.size());
  Table<RegularEdgeSlot, std::int8_t> triangles_at(edges.size());
  balls.in_parts(edges.size(), [&](std::size_t begin, std::size_t end, std::size_t) {
    for (const RegularEdgeSlot e : slots_between<RegularEdgeSlot>(begin, end))
      triangles_at[e] = dual_triangles_at(balls, triangulation, out, edges[e]);
  });
  for (const RegularEdgeSlot e : edges.rows()) {
    if (triangles_at[e] < 0) continue;
    const PipelineBall& a = balls.input[edges[e].v[0]];
    const PipelineBall& b = balls.input[edges[e].v[1]];
    const bool shares_sample = common_sample(a, b) != nullptr;
    if (!shares_sample) ++out.edges_without_sample;
    out.row_of_edge[e] = out.edges.next();
    out.edges.push_back(
        {{a.row, b.row}, static_cast<DualClass>(triangles_at[e]), static_cast<std::uint8_t>(shares_sample ? 1 : 0)});
  }
}

template <class Balls, class Points>
DualComplex dual_complex(const UnionBalls<Balls, Points>& balls, const UnionTriangulation& triangulation,
                         JobControl& job) {
  DualComplex out;
  classify_faces(balls, triangulation, job, out);
  balls.both(
      triangulation.tables.faces.size(), [&] { group_zero_faces(balls, triangulation.tables, out); },
      [&] { classify_edges(balls, triangulation, out); });
  return out;
}

}  // namespace mes
