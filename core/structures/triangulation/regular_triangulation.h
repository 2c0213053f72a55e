// SPDX-License-Identifier: GPL-3.0-or-later
// Regular triangulation of weighted points (the dual of their power diagram), as plain tables.
#pragma once

#include <CGAL/Regular_triangulation_2.h>
#include <CGAL/Regular_triangulation_face_base_2.h>
#include <CGAL/Regular_triangulation_vertex_base_2.h>
#include <CGAL/Triangulation_face_base_with_info_2.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>
#include <CGAL/number_utils.h>

#include <algorithm>
#include <bit>
#include <iterator>
#include <vector>

#include "core/base/geometry/box2.h"
#include "core/base/jobs/job_control.h"
#include "core/base/jobs/parallel.h"
#include "core/kernel/ball_signs.h"
#include "core/kernel/filtered_kernel.h"
#include "core/structures/triangulation/ball_state.h"
#include "core/structures/triangulation/hilbert.h"
#include "core/structures/triangulation/point_triangulation.h"

namespace mes {

/// Stands for the vertex at infinity in `RegularTables`.
inline constexpr InputSlot kInfiniteBall{0xfffffffeU};

using RegularEdgeSlot = Slot<struct RegularEdgeTag>;

/// Corners run counter-clockwise; neighbour i lies opposite corner i; triangles outside hull edges have one corner
/// `kInfiniteBall`.
struct RegularTables {
  struct Face {
    InputSlot v[3]{};
    TriangleSlot n[3]{};
  };
  /// A finite edge; `f[0]` lies to the left of v[0] -> v[1], `f[1]` to the right; kNoSlot if all centres are collinear.
  struct Edge {
    InputSlot v[2]{};
    TriangleSlot f[2]{};
  };
  int dimension = -1;
  Table<TriangleSlot, Face> faces;
  Table<RegularEdgeSlot, Edge> edges;
  Table<InputSlot, BallState> state;    ///< visible, hidden, or duplicate of a visible one
  Table<InputSlot, InputSlot> same_as;  ///< itself, or for a duplicate the ball that stands for it

  bool is_infinite(TriangleSlot face) const {
    return std::ranges::find(faces[face].v, kInfiniteBall) != std::end(faces[face].v);
  }
};

inline constexpr std::size_t kRowsPerLook = 4096;  // rows between two checkpoints of the job

/// Makes the same tables from a triangulation of dimension 2.
inline RegularTables tables_of(const PointTriangulation& triangulation, const Table<InputSlot, BallOf<double>>& balls,
                               JobControl& job) {
  std::size_t rows = 0;
  const auto look = [&] {
    if (++rows % kRowsPerLook == 0) job.checkpoint();
  };
  RegularTables out;
  out.dimension = 2;
  out.state.assign(balls.size(), BallState::hidden);
  out.same_as.resize(balls.size());
  const std::size_t finite = triangulation.faces.size();
  out.faces.reserve(finite + finite / 8);
  Table<InputSlot, TriangleSlot> outside_from(
      balls.size());  // the triangle outside the hull edge that begins at a ball
  for (const auto& face : triangulation.faces) {
    look();
    RegularTables::Face& row = out.faces.emplace_back();
    std::ranges::copy(face.v, row.v);
    std::ranges::copy(face.n, row.n);
    for (const InputSlot v : face.v) out.state[v] = BallState::visible;
  }
  for (const TriangleSlot f : slots_below<TriangleSlot>(finite)) {
    look();
    for (std::size_t i = 0; i < 3; ++i) {
      if (out.faces[f].n[i] != kNoSlot) continue;
      const InputSlot from = out.faces[f].v[(i + 1) % 3];
      const InputSlot to = out.faces[f].v[(i + 2) % 3];
      outside_from[from] = out.faces[f].n[i] = out.faces.next();
      out.faces.push_back({{to, from, kInfiniteBall}, {TriangleSlot(), TriangleSlot(), f}});
    }
  }
  for (const TriangleSlot f : slots_between<TriangleSlot>(finite, out.faces.size())) {
    // The next outside triangle begins where this one ends.
    const TriangleSlot next = outside_from[out.faces[f].v[0]];
    out.faces[f].n[1] = next;
    out.faces[next].n[0] = f;
  }
  out.edges.reserve(3 * balls.size());
  for (const TriangleSlot f : slots_below<TriangleSlot>(finite)) {
    look();
    const RegularTables::Face& face = out.faces[f];
    for (std::size_t i = 0; i < 3; ++i)
      if (f < face.n[i]) out.edges.push_back({{face.v[(i + 1) % 3], face.v[(i + 2) % 3]}, {f, face.n[i]}});
  }
  for (const InputSlot i : balls.rows()) {
    look();
    const InputSlot same = triangulation.same_as[i];
    const bool is_equal =
        same != kNoSlot && same != i && balls[same].w == balls[i].w && out.state[same] == BallState::visible;
    out.same_as[i] = is_equal ? same : i;
    if (is_equal) out.state[i] = BallState::duplicate;
  }
  return out;
}

/// O(n log n) typically, if consecutive balls are close (as `scaled_balls` gives them). Decisions are those of the
/// kernel: exact for `FastKernel` (on the doubles it is given) and for the exact kernels. Balls left out count as
/// hidden.
template <class Kernel>
RegularTables regular_triangulation(const Table<InputSlot, BallOf<typename Kernel::FT>>& balls, JobControl& job,
                                    const Table<InputSlot, bool>& left_out = {}) {
  using Traits = TriangulationTraits<Kernel>;
  using VertexBase = CGAL::Triangulation_vertex_base_with_info_2<InputSlot, Traits,
                                                                 CGAL::Regular_triangulation_vertex_base_2<Traits>>;
  using FaceBase = CGAL::Triangulation_face_base_with_info_2<TriangleSlot, Traits,
                                                             CGAL::Regular_triangulation_face_base_2<Traits>>;
  using Rt = CGAL::Regular_triangulation_2<Traits, CGAL::Triangulation_data_structure_2<VertexBase, FaceBase>>;

  if constexpr (std::is_same_v<Kernel, FastKernel>) {
    if (const auto triangulation = ball_triangulation(balls, left_out, job))
      return tables_of(*triangulation, balls, job);
  }
  RegularTables out;
  out.state.assign(balls.size(), BallState::visible);
  out.same_as.resize(balls.size());
  Rt rt;
  typename Rt::Face_handle hint{};
  std::size_t done = 0;
  std::vector<InputSlot> order_of_insertion = in_rounds<InputSlot>(balls.size());
  using Point = typename Kernel::Point_2;
  leave_line_early(
      order_of_insertion, [&](InputSlot i) { return Point(balls[i].x, balls[i].y); },
      [](const Point& a, const Point& b, const Point& c) { return CGAL::orientation(a, b, c); },
      [](const Point& a, const Point& b) { return CGAL::compare_xy(a, b) == CGAL::SMALLER; });
  for (const InputSlot ball_slot : order_of_insertion) {
    if ((++done & 0x3fU) == 0) job.checkpoint(done, balls.size());
    if (!left_out.empty() && left_out[ball_slot]) {
      out.state[ball_slot] = BallState::hidden;
      out.same_as[ball_slot] = ball_slot;
      continue;
    }
    const BallOf<typename Kernel::FT>& ball = balls[ball_slot];
    const auto vertex =
        rt.insert(typename Kernel::Weighted_point_2(typename Kernel::Point_2(ball.x, ball.y), ball.w), hint);
    out.same_as[ball_slot] = ball_slot;
    if (vertex == typename Rt::Vertex_handle()) {
      out.state[ball_slot] = BallState::hidden;
      continue;
    }
    if (vertex->info() == kNoSlot) {
      vertex->info() = ball_slot;
    } else {
      out.state[ball_slot] = BallState::duplicate;
      out.same_as[ball_slot] = vertex->info();
    }
    hint = vertex->face();
  }
  for (auto v = rt.hidden_vertices_begin(); v != rt.hidden_vertices_end(); ++v)
    out.state[v->info()] = BallState::hidden;
  out.dimension = rt.dimension();
  const auto ball_of = [&rt](typename Rt::Vertex_handle v) { return rt.is_infinite(v) ? kInfiniteBall : v->info(); };
  if (rt.dimension() == 1) {
    for (auto e = rt.finite_edges_begin(); e != rt.finite_edges_end(); ++e)
      out.edges.push_back({{ball_of(e->first->vertex(0)), ball_of(e->first->vertex(1))}});
  }
  if (rt.dimension() < 2) return out;
  // Rows follow the order of the balls: these are close to their neighbours, and so are faces and edges then.
  using HandleSlot = Slot<struct HandleTag>;
  Table<HandleSlot, typename Rt::Face_handle> handles;
  handles.reserve(2 * balls.size() + 2);
  Table<TriangleSlot, Keyed<HandleSlot>> order;
  order.reserve(2 * balls.size() + 2);
  for (auto f = rt.all_faces_begin(); f != rt.all_faces_end(); ++f) {
    if (handles.size() % kRowsPerLook == 0) job.checkpoint();
    const InputSlot first = std::min({ball_of(f->vertex(0)), ball_of(f->vertex(1)), ball_of(f->vertex(2))});
    order.push_back({first.index(), handles.next()});
    handles.push_back(f);
  }
  std::vector<Keyed<HandleSlot>> scratch;
  radix_sort(order.values(), scratch, static_cast<unsigned>(std::bit_width(balls.size())));
  job.checkpoint();
  out.faces.resize(order.size());
  for (const TriangleSlot slot : order.rows()) handles[order[slot].slot]->info() = slot;
  out.edges.reserve(3 * balls.size());
  parallel_for(order.size(), [&](std::size_t begin, std::size_t end, std::size_t) {
    job.checkpoint();
    for (const TriangleSlot slot : slots_between<TriangleSlot>(begin, end)) {
      const auto f = handles[order[slot].slot];
      for (int i = 0; i < 3; ++i) {
        out.faces[slot].v[i] = ball_of(f->vertex(i));
        out.faces[slot].n[i] = f->neighbor(i)->info();
      }
    }
  });
  for (const TriangleSlot slot : order.rows()) {
    if (slot.index() % kRowsPerLook == 0) job.checkpoint();
    const RegularTables::Face& face = out.faces[slot];
    for (int i = 0; i < 3; ++i) {
      const InputSlot from = face.v[Rt::ccw(i)];
      const InputSlot to = face.v[Rt::cw(i)];
      if (slot < face.n[i] && from != kInfiniteBall && to != kInfiniteBall)
        out.edges.push_back({{from, to}, {slot, face.n[i]}});
    }
  }
  return out;
}

}  // namespace mes
