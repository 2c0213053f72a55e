// SPDX-License-Identifier: GPL-3.0-or-later
// First stage of the union pipeline: balls -> regular triangulation.
#pragma once

#include <algorithm>
#include <array>
#include <optional>
#include <utility>
#include <vector>

#include "core/base/jobs/job_control.h"
#include "core/structures/balls/internal/numbers/union_balls.h"
#include "core/structures/triangulation/regular_triangulation.h"

namespace mes {

/// The tables of the regular triangulation, with links from triangles and balls to their edges.
struct UnionTriangulation {
  RegularTables tables;
  Table<TriangleSlot, std::array<RegularEdgeSlot, 3>> face_edge;  ///< edge i lies opposite corner i
  Table<InputSlot, TriangleSlot> some_face;                       ///< one of the faces at a ball
  Table<InputSlot, std::vector<RegularEdgeSlot>> line_edges;      ///< edges of a ball; only if centres are collinear

  bool is_infinite(TriangleSlot face) const { return tables.is_infinite(face); }
};

/// Checks a triangulation of rounded balls against the balls as they are.
template <class Balls, class Points>
class TriangulationCheck {
 public:
  TriangulationCheck(const UnionBalls<Balls, Points>& balls, const RegularTables& tables)
      : balls_(balls), ball_(balls.in_balls), tables_(tables) {}

  /// True if the triangulation is one of the exact balls: its triangles run counter-clockwise within a convex boundary,
  /// and over them the surface of the lifted balls is locally convex, hence convex; every ball that it leaves out lies
  /// above that surface. A ball on the surface is visible in exact triangulations.
  bool passes(JobControl& job) {
    if (tables_.dimension != 2) return false;
    for (const TriangleSlot f : tables_.faces.rows()) {
      if ((f.index() & 0xffU) == 0) job.checkpoint();
      if (!is_infinite(f) && !is_good(f)) return false;
    }
    return is_hull_convex() && are_others_above();
  }

 private:
  bool is_infinite(TriangleSlot f) const { return tables_.is_infinite(f); }
  int turn(InputSlot a, InputSlot b, InputSlot c) const { return sign_of_turn<Balls>(ball_[a], ball_[b], ball_[c]); }
  int excess(TriangleSlot f, InputSlot other) const {
    const auto& v = tables_.faces[f].v;
    if (balls_.have_common_sample(v, other)) return 0;
    return sign_of_excess_at_center<Balls>(ball_[v[0]], ball_[v[1]], ball_[v[2]], ball_[other]);
  }

  bool is_good(TriangleSlot f) const {
    const auto& v = tables_.faces[f].v;
    if (turn(v[0], v[1], v[2]) <= 0) return false;
    return std::ranges::none_of(tables_.faces[f].n, [&](TriangleSlot g) {
      if (g < f || is_infinite(g)) return false;
      const auto& beyond = tables_.faces[g];
      return excess(f, beyond.v[beyond.n[0] == f ? 0 : (beyond.n[1] == f ? 1 : 2)]) < 0;
    });
  }

  // The boundary may have flat corners, and goes around once.
  bool is_hull_convex() const {
    Table<InputSlot, InputSlot> next(balls_.size());  // counter-clockwise
    for (const TriangleSlot f : tables_.faces.rows()) {
      if (is_infinite(f)) continue;
      const auto& face = tables_.faces[f];
      for (std::size_t i = 0; i < 3; ++i)
        if (is_infinite(face.n[i])) next[face.v[(i + 1) % 3]] = face.v[(i + 2) % 3];
    }
    const auto comes_first = [this](InputSlot a, InputSlot b) {
      const auto order = CGAL::compare(ball_[a].x, ball_[b].x);
      return order == CGAL::SMALLER || (order == CGAL::EQUAL && ball_[a].y < ball_[b].y);
    };
    int first_balls = 0;
    for (const InputSlot from : next.rows()) {
      const InputSlot at = next[from];
      if (at == kNoSlot) continue;
      const InputSlot to = next[at];
      if (turn(from, at, to) < 0) return false;
      if (comes_first(at, from) && comes_first(at, to)) ++first_balls;
    }
    return first_balls == 1;
  }

  bool are_others_above() {
    TriangleSlot near;
    Table<InputSlot, TriangleSlot> some_face(balls_.size());
    for (const TriangleSlot f : tables_.faces.rows()) {
      if (is_infinite(f)) continue;
      near = f;
      for (const InputSlot v : tables_.faces[f].v) some_face[v] = f;
    }
    for (const InputSlot i : tables_.state.rows()) {
      if (some_face[i] != kNoSlot) {
        near = some_face[i];
        continue;
      }
      const InputSlot same = tables_.same_as[i];
      if (same != i) {
        if (ball_[same].x != ball_[i].x || ball_[same].y != ball_[i].y || ball_[same].w != ball_[i].w) return false;
        continue;
      }
      near = face_with(i, near);
      if (near == kNoSlot || excess(near, i) <= 0) return false;
    }
    return true;
  }
  // Walks towards the centre; kNoSlot if it lies outside, or the walk is long. Consecutive inputs are close.
  TriangleSlot face_with(InputSlot ball, TriangleSlot at) const {
    for (std::size_t steps = 0; steps < tables_.faces.size(); ++steps) {
      const auto& face = tables_.faces[at];
      TriangleSlot next;
      for (std::size_t k = 0; k < 3 && next == kNoSlot; ++k) {
        const std::size_t i = (steps + k) % 3;  // not always the same first, or the walk might go around forever
        if (turn(face.v[(i + 1) % 3], face.v[(i + 2) % 3], ball) < 0) next = face.n[i];
      }
      if (next == kNoSlot) return at;
      if (is_infinite(next)) return kNoSlot;
      at = next;
    }
    return kNoSlot;
  }

  const UnionBalls<Balls, Points>& balls_;
  const Table<InputSlot, BallOf<typename Balls::FT>>& ball_;
  const RegularTables& tables_;
};

/// The triangulation of the rounded balls if it is also one of the balls as they are; nothing otherwise.
template <class Balls, class Points>
std::optional<RegularTables> confirmed_triangulation(const UnionBalls<Balls, Points>& balls, JobControl& job) {
  Table<InputSlot, BallOf<double>> rounded;
  rounded.reserve(balls.size());
  for (const PipelineBall& ball : balls.input) rounded.push_back(ball_in<double>(ball));
  RegularTables out = regular_triangulation<FastKernel>(rounded, job);
  if (!TriangulationCheck(balls, out).passes(job)) return std::nullopt;
  return out;
}

template <class Balls, class Points>
RegularTables first_triangulation(const UnionBalls<Balls, Points>& balls, JobControl& job) {
  if constexpr (UnionBalls<Balls, Points>::kKnowsSamples) {
    if (auto confirmed = confirmed_triangulation(balls, job)) return std::move(*confirmed);
  }
  return regular_triangulation<Balls>(balls.in_balls, job);
}

/// A ball inside another one that it touches has a power cell and a dual edge, but adds nothing to the union. If it is
/// left out, the tables are those of a set without such balls. Circumdisks of Delaunay triangles never hold each other
/// before they are scaled.
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
  tables = first_triangulation(balls, job);
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
