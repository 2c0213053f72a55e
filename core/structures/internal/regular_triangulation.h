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
#include <vector>

#include "core/base/box2.h"
#include "core/base/job_control.h"
#include "core/base/rng.h"
#include "core/kernel/ball_signs.h"
#include "core/structures/internal/hilbert.h"
#include "core/structures/internal/union_tables.h"

namespace mes {

/// Stands for the vertex at infinity in `RegularTables`.
inline constexpr Slot kInfiniteBall = 0xfffffffeU;

/// Balls are named by their position in the input. Corners run counter-clockwise; neighbour i lies opposite corner i;
/// triangles outside hull edges have one corner `kInfiniteBall`.
struct RegularTables {
  struct Face {
    Slot v[3] = {kNoSlot, kNoSlot, kNoSlot};
    Slot n[3] = {kNoSlot, kNoSlot, kNoSlot};
  };
  /// Finite; `f[0]` lies to the left of v[0] -> v[1], `f[1]` to the right; kNoSlot when all centres are collinear.
  struct Edge {
    Slot v[2] = {kNoSlot, kNoSlot};
    Slot f[2] = {kNoSlot, kNoSlot};
  };
  int dimension = -1;
  std::vector<Face> faces;
  std::vector<Edge> edges;
  std::vector<BallState> state;  ///< by ball: visible, hidden, or duplicate of a visible one
  std::vector<Slot> same_as;     ///< by ball: itself, or for a duplicate the ball that stands for it
};

/// O(n log n) typical. Decisions are those of the kernel: exact for `FastKernel` (on the doubles it is given) and for
/// the exact kernels. Balls that are left out count as hidden.
template <class Kernel>
RegularTables regular_triangulation(const std::vector<BallOf<typename Kernel::FT>>& balls, JobControl& job,
                                    const std::vector<bool>& left_out = {}) {
  struct Info {
    Slot slot = kNoSlot;
  };
  using VertexBase =
      CGAL::Triangulation_vertex_base_with_info_2<Info, Kernel, CGAL::Regular_triangulation_vertex_base_2<Kernel>>;
  using FaceBase =
      CGAL::Triangulation_face_base_with_info_2<Info, Kernel, CGAL::Regular_triangulation_face_base_2<Kernel>>;
  using Rt = CGAL::Regular_triangulation_2<Kernel, CGAL::Triangulation_data_structure_2<VertexBase, FaceBase>>;

  std::vector<KeyedSlot> order(balls.size());
  {
    // In rounds, each of about twice as many balls as all before, chosen at random: else the triangulation on the way
    // has vertices of huge degree. In a round neighbours in the plane come one after the other, so that each is found
    // from the one before. Source: Amenta, Choi and Rote, "Incremental constructions con BRIO", 2003.
    std::vector<Vec2> centers(balls.size());
    Box2 box;
    for (std::size_t i = 0; i < balls.size(); ++i) {
      centers[i] = {CGAL::to_double(balls[i].x), CGAL::to_double(balls[i].y)};
      box.add(centers[i]);
    }
    const HilbertGrid grid(box);
    constexpr unsigned kRounds = 31;
    Rng coins(1);
    for (std::size_t i = 0; i < balls.size(); ++i) {
      const auto heads = static_cast<unsigned>(std::countl_zero(coins.next() | 1U));
      const std::uint64_t round = kRounds - std::min(heads, kRounds);
      order[i] = {(round << 32U) | grid.key(centers[i]), static_cast<Slot>(i)};
    }
    std::vector<KeyedSlot> scratch;
    radix_sort(order, scratch, 37);
  }
  RegularTables out;
  out.state.assign(balls.size(), BallState::visible);
  out.same_as.resize(balls.size());
  Rt rt;
  typename Rt::Face_handle hint{};
  std::size_t done = 0;
  for (const KeyedSlot& item : order) {
    if ((++done & 0x3fU) == 0) job.checkpoint(done, 4 * balls.size());
    if (!left_out.empty() && left_out[item.slot]) {
      out.state[item.slot] = BallState::hidden;
      out.same_as[item.slot] = item.slot;
      continue;
    }
    const BallOf<typename Kernel::FT>& ball = balls[item.slot];
    const auto vertex =
        rt.insert(typename Kernel::Weighted_point_2(typename Kernel::Point_2(ball.x, ball.y), ball.w), hint);
    out.same_as[item.slot] = item.slot;
    if (vertex == typename Rt::Vertex_handle()) {
      out.state[item.slot] = BallState::hidden;
      continue;
    }
    if (vertex->info().slot == kNoSlot) {
      vertex->info().slot = item.slot;
    } else {
      out.state[item.slot] = BallState::duplicate;
      out.same_as[item.slot] = vertex->info().slot;
    }
    hint = vertex->face();
  }
  for (auto v = rt.hidden_vertices_begin(); v != rt.hidden_vertices_end(); ++v)
    out.state[v->info().slot] = BallState::hidden;
  out.dimension = rt.dimension();
  const auto ball_of = [&rt](typename Rt::Vertex_handle v) {
    return rt.is_infinite(v) ? kInfiniteBall : v->info().slot;
  };
  if (rt.dimension() == 2) {
    out.faces.reserve(2 * balls.size() + 2);
    for (auto f = rt.all_faces_begin(); f != rt.all_faces_end(); ++f) {
      f->info().slot = static_cast<Slot>(out.faces.size());
      out.faces.emplace_back();
      for (int i = 0; i < 3; ++i) out.faces.back().v[i] = ball_of(f->vertex(i));
    }
    for (auto f = rt.all_faces_begin(); f != rt.all_faces_end(); ++f)
      for (int i = 0; i < 3; ++i) out.faces[f->info().slot].n[i] = f->neighbor(i)->info().slot;
  }
  if (rt.dimension() < 1) return out;
  out.edges.reserve(3 * balls.size());
  for (auto e = rt.finite_edges_begin(); e != rt.finite_edges_end(); ++e) {
    const auto f = e->first;
    const int i = e->second;
    RegularTables::Edge edge;
    if (rt.dimension() == 1) {
      edge.v[0] = f->vertex(0)->info().slot;
      edge.v[1] = f->vertex(1)->info().slot;
    } else {
      edge.v[0] = f->vertex(Rt::ccw(i))->info().slot;
      edge.v[1] = f->vertex(Rt::cw(i))->info().slot;
      edge.f[0] = f->info().slot;
      edge.f[1] = f->neighbor(i)->info().slot;
    }
    out.edges.push_back(edge);
  }
  return out;
}

}  // namespace mes
