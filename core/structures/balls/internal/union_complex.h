// SPDX-License-Identifier: GPL-3.0-or-later
// Second stage of the union pipeline: regular triangulation -> dual complex.
#pragma once

#include <algorithm>
#include <cstdint>
#include <vector>

#include "core/base/job_control.h"
#include "core/structures/balls/internal/union_balls.h"
#include "core/structures/balls/internal/union_tables.h"
#include "core/structures/balls/internal/union_triangulation.h"

namespace mes {

/// Triangles by the sign of their orthogonal radius, edges by their triangles or by themselves.
struct DualComplex {
  static constexpr std::int8_t kInfinite = 2;

  std::vector<DualEdge> edges;
  std::vector<DualFace> faces;
  std::vector<Slot> row_of_edge;          ///< in `edges`, by edge of the triangulation; kNoSlot = not in the complex
  std::vector<std::int8_t> face_sign;     ///< of the orthogonal radius, by face of the triangulation; or `kInfinite`
  std::vector<Slot> zero_group;           ///< by face: triangles of radius zero about one centre; kNoSlot = none
  Slot zero_groups = 0;                   ///< how many groups there are
  std::int64_t finite_faces = 0;          ///< of the triangulation
  std::int64_t sign_flips = 0;            ///< see `UnionCounts`
  std::int64_t negative_faces = 0;        ///< see `UnionCounts`
  std::int64_t edges_without_sample = 0;  ///< see `UnionCounts`

  /// The complex has this triangle.
  bool has(Slot face) const { return face != kNoSlot && face_sign[face] <= 0; }
};

/// Fills in `face_sign`, `faces` and what is counted of them.
template <class Balls, class Points>
void classify_faces(const UnionBalls<Balls, Points>& balls, const UnionTriangulation& triangulation, JobControl& job,
                    DualComplex& out) {
  const auto& faces = triangulation.tables.faces;
  out.face_sign.assign(faces.size(), DualComplex::kInfinite);
  std::vector<std::uint8_t> has_sample(faces.size(), 0);
  const auto judge = [&](Slot f) {
    if (triangulation.is_infinite(f)) return;
    const auto& v = faces[f].v;
    out.face_sign[f] = static_cast<std::int8_t>(
        sign_of_orthogonal_radius<Balls>(balls.in_balls[v[0]], balls.in_balls[v[1]], balls.in_balls[v[2]]));
    has_sample[f] = common_sample(balls.input[v[0]], balls.input[v[1]], balls.input[v[2]]) != nullptr ? 1 : 0;
  };
  balls.in_parts(faces.size(), [&](std::size_t begin, std::size_t end, std::size_t) {
    for (std::size_t f = begin; f < end; ++f) {
      if ((f & 0xffU) == 0) job.checkpoint(f, 4 * faces.size());
      judge(static_cast<Slot>(f));
    }
  });
  job.checkpoint();
  out.faces.reserve(
      static_cast<std::size_t>(std::ranges::count_if(out.face_sign, [](int sign) { return sign <= 0; })));
  for (Slot f = 0; f < faces.size(); ++f) {
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

/// Groups triangles of radius zero that have their centre in common: around a sample, for Voronoi balls.
template <class Balls, class Points>
void group_zero_faces(const UnionBalls<Balls, Points>& balls, const RegularTables& tables, DualComplex& out) {
  out.zero_group.assign(tables.faces.size(), kNoSlot);
  const auto& ball = balls.in_balls;
  std::vector<Slot> stack;
  for (Slot seed = 0; seed < tables.faces.size(); ++seed) {
    if (out.face_sign[seed] != 0 || out.zero_group[seed] != kNoSlot) continue;
    out.zero_group[seed] = out.zero_groups;
    stack.assign(1, seed);
    while (!stack.empty()) {
      const Slot f = stack.back();
      stack.pop_back();
      const auto& v = tables.faces[f].v;
      for (const Slot g : tables.faces[f].n) {
        if (g == kNoSlot || out.face_sign[g] != 0 || out.zero_group[g] != kNoSlot) continue;
        Slot other = kNoSlot;
        for (const Slot c : tables.faces[g].v)
          if (c != v[0] && c != v[1] && c != v[2]) other = c;
        if (other == kNoSlot || !have_common_center<Balls>(ball[v[0]], ball[v[1]], ball[v[2]], ball[other])) continue;
        out.zero_group[g] = out.zero_groups;
        stack.push_back(g);
      }
    }
    ++out.zero_groups;
  }
}

/// The number of triangles of the complex at an edge of the triangulation; -1 if the edge itself is not in it.
template <class Balls, class Points>
std::int8_t dual_triangles_at(const UnionBalls<Balls, Points>& balls, const UnionTriangulation& triangulation,
                              const DualComplex& complex, const RegularTables::Edge& edge) {
  std::int8_t triangles = 0;
  for (const Slot f : edge.f)
    if (complex.has(f)) ++triangles;
  if (triangles != 0) return triangles;
  const auto& a = balls.in_balls[edge.v[0]];
  const auto& b = balls.in_balls[edge.v[1]];
  for (const Slot f : edge.f) {
    if (f == kNoSlot || triangulation.is_infinite(f)) continue;
    for (const Slot c : triangulation.tables.faces[f].v)
      if (c != edge.v[0] && c != edge.v[1] && sign_of_excess_at_foot<Balls>(a, b, balls.in_balls[c]) < 0) return -1;
  }
  return sign_of_edge_radius<Balls>(a, b) > 0 ? std::int8_t{-1} : std::int8_t{0};
}

/// Fills in `edges`, `row_of_edge` and what is counted of them.
template <class Balls, class Points>
void classify_edges(const UnionBalls<Balls, Points>& balls, const UnionTriangulation& triangulation,
                    DualComplex& out) {
  const auto& edges = triangulation.tables.edges;
  out.row_of_edge.assign(edges.size(), kNoSlot);
  out.edges.reserve(edges.size());
  std::vector<std::int8_t> triangles_at(edges.size());
  balls.in_parts(edges.size(), [&](std::size_t begin, std::size_t end, std::size_t) {
    for (std::size_t e = begin; e < end; ++e)
      triangles_at[e] = dual_triangles_at(balls, triangulation, out, edges[e]);
  });
  for (Slot e = 0; e < edges.size(); ++e) {
    if (triangles_at[e] < 0) continue;
    const PipelineBall& a = balls.input[edges[e].v[0]];
    const PipelineBall& b = balls.input[edges[e].v[1]];
    const bool shares_sample = common_sample(a, b) != nullptr;
    if (!shares_sample) ++out.edges_without_sample;
    out.row_of_edge[e] = static_cast<Slot>(out.edges.size());
    out.edges.push_back(
        {{a.row, b.row}, static_cast<DualClass>(triangles_at[e]), static_cast<std::uint8_t>(shares_sample ? 1 : 0)});
  }
}

/// Progress of the job: the first quarter.
template <class Balls, class Points>
DualComplex dual_complex(const UnionBalls<Balls, Points>& balls, const UnionTriangulation& triangulation,
                         JobControl& job) {
  DualComplex out;
  classify_faces(balls, triangulation, job, out);
  group_zero_faces(balls, triangulation.tables, out);
  classify_edges(balls, triangulation, out);
  return out;
}

}  // namespace mes
