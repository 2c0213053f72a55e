// SPDX-License-Identifier: GPL-3.0-or-later
// First stage of the union pipeline: balls -> regular triangulation.
#pragma once

#include <array>
#include <vector>

#include "core/base/job_control.h"
#include "core/structures/balls/internal/union_balls.h"
#include "core/structures/triangulation/regular_triangulation.h"

namespace mes {

/// The tables of the regular triangulation, and the ways from a triangle and from a ball to the edges there.
struct UnionTriangulation {
  RegularTables tables;
  Table<TriangleSlot, std::array<RegularEdgeSlot, 3>> face_edge;  ///< edge i lies opposite corner i
  Table<InputSlot, TriangleSlot> some_face;                       ///< one of the faces there
  Table<InputSlot, std::vector<RegularEdgeSlot>> line_edges;      ///< its edges; only when all centres are collinear

  bool is_infinite(TriangleSlot face) const {
    for (const InputSlot v : tables.faces[face].v)
      if (v == kInfiniteBall) return true;
    return false;
  }
};

/// A ball in another one that it touches from inside has a power cell and a dual edge, but no part in the union:
/// without it the tables are those of a set in which no such thing happens. Circumdisks of Delaunay triangles never
/// hold each other before they are scaled.
template <class Balls, class Points>
void leave_out_covered(const UnionBalls<Balls, Points>& balls, RegularTables& tables, JobControl& job) {
  Table<InputSlot, bool> left_out;
  for (bool found = true; found;) {
    found = false;
    for (const auto& edge : tables.edges) {
      const InputSlot a = edge.v[0];
      const InputSlot b = edge.v[1];
      const bool may_hold = balls.input[a].origin == BallOrigin::disk || balls.input[a].scale != 1.0;
      if (!may_hold || sign_of_edge_radius<Balls>(balls.in_balls[a], balls.in_balls[b]) != 0) continue;
      if (!touch_from_inside<Balls>(balls.in_balls[a], balls.in_balls[b])) continue;
      left_out.resize(balls.size(), false);
      left_out[balls.in_balls[a].w < balls.in_balls[b].w ? a : b] = true;
      found = true;
    }
    if (found) tables = regular_triangulation<Balls>(balls.in_balls, job, left_out);
  }
}

template <class Balls, class Points>
UnionTriangulation union_triangulation(const UnionBalls<Balls, Points>& balls, JobControl& job) {
  UnionTriangulation out;
  RegularTables& tables = out.tables;
  tables = regular_triangulation<Balls>(balls.in_balls, job);
  leave_out_covered(balls, tables, job);
  const auto find_faces = [&] {
    out.some_face.assign(balls.size(), kNoSlot);
    for (const TriangleSlot f : tables.faces.rows())
      for (const InputSlot v : tables.faces[f].v)
        if (v != kInfiniteBall) out.some_face[v] = f;
  };
  const auto find_edges = [&] {
    out.face_edge.assign(tables.faces.size(), {});
    for (const RegularEdgeSlot e : tables.edges.rows()) {
      const auto& edge = tables.edges[e];
      for (const TriangleSlot f : edge.f) {
        if (f == kNoSlot) continue;
        const auto& v = tables.faces[f].v;
        for (std::size_t i = 0; i < 3; ++i)
          if (v[i] != edge.v[0] && v[i] != edge.v[1]) out.face_edge[f][i] = e;
      }
    }
  };
  balls.both(tables.faces.size(), find_faces, find_edges);
  if (tables.dimension == 1) {
    out.line_edges.resize(balls.size());
    for (const RegularEdgeSlot e : tables.edges.rows())
      for (const InputSlot ball : tables.edges[e].v) out.line_edges[ball].push_back(e);
  }
  return out;
}

}  // namespace mes
