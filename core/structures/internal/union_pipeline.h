// SPDX-License-Identifier: GPL-3.0-or-later
// The general way from balls to the medial axis of their union, in any number type:
// regular triangulation -> dual complex -> v-points -> Delaunay triangulation of these -> axis.
//
// The axis consists of the singular dual edges and of the part of the Voronoi diagram of the v-points that lies in
// the union |R| of the dual triangles (Attali and Montanvert 1997). No point is located for that. The circle of a
// ball c holds v-points; none lies inside it, so c lies on the Voronoi edge of each two that are neighbours on the
// circle, and this edge leaves c towards the arc between them. The boundary of |R| is met at such centres only. The
// edge goes into |R| if the arc is covered by dual triangles at c, runs along a singular dual edge if that covers the
// arc, and leaves |R| if the arc is free. What lies between is labelled from its ends: every part of the axis reaches
// a centre.
//
// `Balls` is the kernel of triangulation and dual complex, `Points` that of the v-points. For doubles (`fast`) each
// decision is exact for the doubles at hand, and the v-points are rounded; for `naive` nothing is exact.
#pragma once

#include <CGAL/CORE_BigRat.h>
#include <CGAL/Delaunay_triangulation_2.h>
#include <CGAL/Triangulation_face_base_with_info_2.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>
#include <CGAL/number_utils.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <span>
#include <type_traits>
#include <unordered_map>
#include <vector>

#include "core/base/assert.h"
#include "core/base/circumcircle.h"
#include "core/base/disk.h"
#include "core/base/job_control.h"
#include "core/base/parallel.h"
#include "core/kernel/ball_signs.h"
#include "core/kernel/kernels.h"
#include "core/structures/internal/regular_triangulation.h"
#include "core/structures/internal/union_runs.h"
#include "core/structures/internal/union_tables.h"

namespace mes {

template <class Number>
BallOf<Number> plain_ball_in(const PipelineBall& ball) {
  if constexpr (std::is_same_v<Number, double>) {
    const Vec2 c = ball.disk.center;
    if (ball.origin == BallOrigin::disk) return {c.x, c.y, ball.disk.radius * ball.disk.radius};
    // The same corner however the triangle came about.
    const bool is_circumdisk = ball.origin == BallOrigin::circumdisk;
    const Vec2 d =
        (is_circumdisk ? *std::ranges::min_element(ball.corner, lexicographically_less) : ball.corner[0]) - c;
    return {c.x, c.y, dot(d, d)};
  } else {
    if (ball.origin != BallOrigin::circumdisk) {
      const Number x(ball.disk.center.x), y(ball.disk.center.y);
      if (ball.origin == BallOrigin::disk) {
        const Number r(ball.disk.radius);
        return {x, y, r * r};
      }
      const Number dx = Number(ball.corner[0].x) - x, dy = Number(ball.corner[0].y) - y;
      return {x, y, dx * dx + dy * dy};
    }
    const Number ax(ball.corner[0].x), ay(ball.corner[0].y);
    const Number ux = Number(ball.corner[1].x) - ax, uy = Number(ball.corner[1].y) - ay;
    const Number vx = Number(ball.corner[2].x) - ax, vy = Number(ball.corner[2].y) - ay;
    const Number uu = ux * ux + uy * uy;
    const Number vv = vx * vx + vy * vy;
    const Number twice = Number(2) * (ux * vy - uy * vx);
    const Number dx = (vy * uu - uy * vv) / twice;
    const Number dy = (ux * vv - vx * uu) / twice;
    return {ax + dx, ay + dy, dx * dx + dy * dy};
  }
}

/// Squared radius, and centre, in the field of the kernel: from samples exactly when the field is exact.
template <class Number>
BallOf<Number> ball_in(const PipelineBall& ball) {
  if constexpr (std::is_same_v<Number, RootsKernel::FT>) {
    // Signs cost by the depth of an expression, so those of roots begin at numbers, not at how these came about.
    const BallOf<CORE::BigRat> exact = ball_in<CORE::BigRat>(ball);
    const auto number = [](const CORE::BigRat& x) { return Number(CORE::Expr(x)); };
    return {number(exact.x), number(exact.y), number(exact.w)};
  } else {
    BallOf<Number> out = plain_ball_in<Number>(ball);
    if (ball.scale == 1.0) return out;
    if constexpr (std::is_same_v<Number, double>) {
      // The square of the radius that is drawn: a disk of that radius is the same ball.
      out.w = ball.origin == BallOrigin::disk ? ball.radius() * ball.radius() : out.w * (ball.scale * ball.scale);
    } else {
      const Number scale(ball.scale);
      out.w = out.w * (scale * scale);
    }
    return out;
  }
}

template <class Number>
double rounded(const Number& x) {
  // Of a lazy number the value counts, not how it came about.
  if constexpr (std::is_same_v<Number, typename ExactKernel::FT>) {
    return CGAL::to_double(CGAL::exact(x));
  } else {
    return CGAL::to_double(x);
  }
}

template <class Number>
inline constexpr bool kHasRoots =
    std::is_same_v<typename CGAL::Algebraic_structure_traits<Number>::Sqrt, CGAL::Null_functor> == false;

template <class Balls, class Points>
class UnionPipeline {
 public:
  /// `use_samples`: where two circles share a sample, this is their crossing
  /// and the other one its mirror image, both rational; without it, and where they share none, a root is taken.
  UnionPipeline(const PipelineInput& input, bool use_samples, JobControl& job)
      : input_(input.balls), use_samples_(use_samples), job_(job) {
    t_.balls.assign(input.rows, BallState::none);
  }

  UnionTables run() {
    triangulate();
    classify();
    make_v_points();
    triangulate_v_points();
    gather_events();
    cut_edges();
    return std::move(t_);
  }
  UnionTables run_dual_complex() {
    triangulate();
    classify();
    return std::move(t_);
  }
  /// Only the Voronoi diagram of v-points that are known.
  UnionTables run_v_diagram(const KnownVPoints& known);

 private:
  using BallNumber = typename Balls::FT;
  using PointNumber = typename Points::FT;
  struct FaceInfo {
    Slot slot = kNoSlot;
    Slot edge[3] = {kNoSlot, kNoSlot, kNoSlot};
  };
  struct VertexInfo {
    Slot slot = kNoSlot;
  };
  using VertexBase = CGAL::Triangulation_vertex_base_with_info_2<VertexInfo, Points>;
  using FaceBase = CGAL::Triangulation_face_base_with_info_2<FaceInfo, Points>;
  using Dt = CGAL::Delaunay_triangulation_2<Points, CGAL::Triangulation_data_structure_2<VertexBase, FaceBase>>;

  using Arc = CircleArc;
  using Place = CirclePlace;
  /// A ball's centre lies on the Voronoi edge; the arc lies to the left (towards face 0) or right of it.
  struct Event {
    Slot edge = kNoSlot;
    Slot ball = kNoSlot;  // position in the input
    std::uint8_t side = 0;
    Arc arc = Arc::free;
  };

  bool is_infinite(Slot face) const {
    for (const Slot v : rt_.faces[face].v)
      if (v == kInfiniteBall) return true;
    return false;
  }

  void triangulate();
  void leave_out_covered();
  void classify();
  void group_zero_faces();
  void make_v_points();
  struct Crossing {
    typename Points::Point_2 point;
    Slot site = kNoSlot;
  };
  std::optional<Crossing> crossing_of(Slot a, Slot b, bool left);
  std::optional<Crossing> crossing_by_sample(Slot a, Slot b, bool left);
  Crossing crossing_by_root(Slot a, Slot b, bool left, const PointNumber& radicand);
  /// A v-point as one dual edge gives it.
  struct Raw {
    Slot edge;          // of the regular triangulation
    std::uint8_t side;  // 0 = left
    Crossing crossing;
    typename Dt::Vertex_handle vertex;
  };
  void cross(Slot edge, bool left);
  void insert_crossings();
  Slot add_v_point(const Raw& raw);
  void triangulate_v_points();
  void walk_around(Slot ball);
  void gather_events();
  void take_places(Slot ball);
  void add_event(Slot ball, Slot from, Slot to, Arc arc);
  bool comes_before(Slot a, Slot b) const {
    return lexicographically_less(input_[a].disk.center, input_[b].disk.center);
  }
  void mark_polygon(Slot ball, const std::vector<Slot>& points);
  bool is_center_here(Slot edge, Slot inner_face) const;
  void sort_by_edge(std::vector<Event>& events) const;
  void cut_edges();
  Slot node_of(Slot face) const;
  static Circle circle_of(typename Dt::Face_handle face);

  std::span<const PipelineBall> input_;
  bool use_samples_;
  JobControl& job_;
  UnionTables t_;
  RegularTables rt_;
  std::vector<BallOf<BallNumber>> ball_;
  std::vector<BallOf<PointNumber>> ball_in_points_;
  std::vector<std::array<Slot, 3>> face_edge_;  // of the regular triangulation
  std::vector<Slot> some_face_;                 // at a ball
  std::vector<std::vector<Slot>> line_edges_;   // at a ball; when all centres are collinear
  std::vector<std::int8_t> face_sign_;          // of the orthogonal radius; 2 = infinite
  std::vector<Slot> dual_of_edge_;              // row in t_.dual_edges, by edge of the regular triangulation
  std::vector<std::array<Slot, 2>> crossing_;   // left and right v-point, by row in t_.dual_edges
  std::vector<Slot> zero_group_;                // by face; kNoSlot = none
  std::vector<Slot> group_v_;                   // the v-point of a group, if any
  std::vector<Raw> raw_;
  Dt dt_;
  typename Dt::Face_handle hint_{};
  std::vector<typename Dt::Vertex_handle> v_vertex_;  // by row of v_points
  std::vector<typename Dt::Face_handle> v_handle_;    // by row of v_faces
  std::vector<Event> events_;
  struct Spoke {
    Slot edge;
    Slot left;  // face
  };
  // Work space of one ball.
  std::vector<Spoke> star_;
  std::vector<Place> places_;
  std::vector<Slot> points_;
  std::vector<typename Dt::Face_handle> stack_;
  std::vector<std::uint32_t> stamp_;  // v-points on the circle at hand
  std::uint32_t now_ = 0;
};

template <class Balls, class Points>
void UnionPipeline<Balls, Points>::triangulate() {
  ball_.reserve(input_.size());
  ball_in_points_.reserve(input_.size());
  for (const PipelineBall& ball : input_) {
    ball_.push_back(ball_in<BallNumber>(ball));
    ball_in_points_.push_back(ball_in<PointNumber>(ball));
  }
  rt_ = regular_triangulation<Balls>(ball_, job_);
  leave_out_covered();
  for (Slot i = 0; i < input_.size(); ++i) t_.balls[input_[i].row] = rt_.state[i];
  t_.counts.triangulation_edges = static_cast<std::int64_t>(rt_.edges.size());
  t_.counts.triangulation_faces = 0;
  face_edge_.assign(rt_.faces.size(), {kNoSlot, kNoSlot, kNoSlot});
  some_face_.assign(input_.size(), kNoSlot);
  for (Slot f = 0; f < rt_.faces.size(); ++f) {
    t_.counts.triangulation_faces += is_infinite(f) ? 0 : 1;
    for (const Slot v : rt_.faces[f].v)
      if (v != kInfiniteBall) some_face_[v] = f;
  }
  for (Slot e = 0; e < rt_.edges.size(); ++e) {
    for (const Slot f : rt_.edges[e].f) {
      if (f == kNoSlot) continue;
      for (std::size_t i = 0; i < 3; ++i)
        if (rt_.faces[f].v[i] != rt_.edges[e].v[0] && rt_.faces[f].v[i] != rt_.edges[e].v[1]) face_edge_[f][i] = e;
    }
  }
}

// A ball in another one that it touches from inside has a power cell and a dual edge, but no part in the union:
// without it the tables are those of a set in which no such thing happens. Circumdisks of Delaunay triangles never
// hold each other before they are scaled.
template <class Balls, class Points>
void UnionPipeline<Balls, Points>::leave_out_covered() {
  std::vector<bool> left_out;
  for (bool found = true; found;) {
    found = false;
    for (const auto& edge : rt_.edges) {
      const Slot a = edge.v[0];
      const Slot b = edge.v[1];
      const bool may_hold = input_[a].origin == BallOrigin::disk || input_[a].scale != 1.0;
      if (!may_hold || sign_of_edge_radius<Balls>(ball_[a], ball_[b]) != 0) continue;
      if (!touch_from_inside<Balls>(ball_[a], ball_[b])) continue;
      left_out.resize(input_.size(), false);
      left_out[ball_[a].w < ball_[b].w ? a : b] = true;
      found = true;
    }
    if (found) rt_ = regular_triangulation<Balls>(ball_, job_, left_out);
  }
}

// The dual complex: triangles by the sign of their orthogonal radius, edges by their triangles or by themselves.
template <class Balls, class Points>
void UnionPipeline<Balls, Points>::classify() {
  face_sign_.assign(rt_.faces.size(), 2);
  const auto judge = [this](Slot f) {
    const auto& v = rt_.faces[f].v;
    if (!is_infinite(f))
      face_sign_[f] =
          static_cast<std::int8_t>(sign_of_orthogonal_radius<Balls>(ball_[v[0]], ball_[v[1]], ball_[v[2]]));
  };
  if constexpr (std::is_same_v<BallNumber, double>) {
    parallel_for(rt_.faces.size(), [&](std::size_t begin, std::size_t end, std::size_t) {
      for (std::size_t f = begin; f < end && !job_.stop_requested(); ++f) judge(static_cast<Slot>(f));
    });
  } else {
    for (Slot f = 0; f < rt_.faces.size(); ++f) {
      if ((f & 0xffU) == 0) job_.checkpoint(f, 4 * rt_.faces.size());
      judge(f);
    }
  }
  job_.checkpoint();
  for (Slot f = 0; f < rt_.faces.size(); ++f) {
    if (is_infinite(f)) continue;
    const auto& v = rt_.faces[f].v;
    const int sign = face_sign_[f];
    const bool touches_sample = common_sample(input_[v[0]], input_[v[1]], input_[v[2]]) != nullptr;
    if (touches_sample && sign != 0) ++t_.counts.sign_flips;
    if (sign < 0 && !touches_sample) ++t_.counts.negative_faces;
    if (sign > 0) continue;
    t_.dual_faces.push_back({{input_[v[0]].row, input_[v[1]].row, input_[v[2]].row},
                             static_cast<std::int8_t>(sign),
                             static_cast<std::uint8_t>(touches_sample ? 1 : 0)});
  }
  group_zero_faces();
  dual_of_edge_.assign(rt_.edges.size(), kNoSlot);
  for (Slot e = 0; e < rt_.edges.size(); ++e) {
    const auto& edge = rt_.edges[e];
    int triangles = 0;
    bool attached = false;
    const BallOf<BallNumber>& a = ball_[edge.v[0]];
    const BallOf<BallNumber>& b = ball_[edge.v[1]];
    for (const Slot f : edge.f)
      if (f != kNoSlot && face_sign_[f] <= 0) ++triangles;
    if (triangles == 0) {
      for (const Slot f : edge.f) {
        if (f == kNoSlot || is_infinite(f)) continue;
        for (const Slot c : rt_.faces[f].v)
          if (c != edge.v[0] && c != edge.v[1])
            attached = attached || sign_of_excess_at_foot<Balls>(a, b, ball_[c]) < 0;
      }
      if (attached || sign_of_edge_radius<Balls>(a, b) > 0) continue;
    }
    dual_of_edge_[e] = static_cast<Slot>(t_.dual_edges.size());
    t_.dual_edges.push_back({{input_[edge.v[0]].row, input_[edge.v[1]].row}, static_cast<DualClass>(triangles), 0});
  }
}

// Triangles of radius zero that have their centre in common: around a sample, for Voronoi balls.
template <class Balls, class Points>
void UnionPipeline<Balls, Points>::group_zero_faces() {
  zero_group_.assign(rt_.faces.size(), kNoSlot);
  Slot groups = 0;
  std::vector<Slot> stack;
  for (Slot seed = 0; seed < rt_.faces.size(); ++seed) {
    if (face_sign_[seed] != 0 || zero_group_[seed] != kNoSlot) continue;
    zero_group_[seed] = groups;
    stack.assign(1, seed);
    while (!stack.empty()) {
      const Slot f = stack.back();
      stack.pop_back();
      const auto& v = rt_.faces[f].v;
      for (const Slot g : rt_.faces[f].n) {
        if (g == kNoSlot || face_sign_[g] != 0 || zero_group_[g] != kNoSlot) continue;
        Slot other = kNoSlot;
        for (const Slot c : rt_.faces[g].v)
          if (c != v[0] && c != v[1] && c != v[2]) other = c;
        if (other == kNoSlot || !have_common_center<Balls>(ball_[v[0]], ball_[v[1]], ball_[v[2]], ball_[other]))
          continue;
        zero_group_[g] = groups;
        stack.push_back(g);
      }
    }
    ++groups;
  }
  group_v_.assign(groups, kNoSlot);
}

template <class Balls, class Points>
auto UnionPipeline<Balls, Points>::crossing_by_sample(Slot a, Slot b, bool left) -> std::optional<Crossing> {
  const BallOf<PointNumber>& p = ball_in_points_[a];
  const BallOf<PointNumber>& q = ball_in_points_[b];
  const PointNumber dx = q.x - p.x, dy = q.y - p.y;
  std::optional<Crossing> mirrored;
  for (const TouchedSample& sample : input_[a].samples) {
    if (input_[b].find(sample.site) == nullptr) continue;
    const PointNumber x(sample.position.x), y(sample.position.y);
    const PointNumber side = dx * (y - p.y) - dy * (x - p.x);
    const int sign = static_cast<int>(CGAL::sign(side));
    if (sign == 0 || (sign > 0) == left) return Crossing{typename Points::Point_2(x, y), sample.site};
    const PointNumber twice = PointNumber(2) * side / (dx * dx + dy * dy);
    mirrored = Crossing{typename Points::Point_2(x + twice * dy, y - twice * dx), kNoSlot};
  }
  return mirrored;
}

template <class Balls, class Points>
auto UnionPipeline<Balls, Points>::crossing_by_root(Slot a, Slot b, bool left, const PointNumber& radicand)
    -> Crossing {
  if constexpr (kHasRoots<PointNumber>) {
    const BallOf<PointNumber>& p = ball_in_points_[a];
    const BallOf<PointNumber>& q = ball_in_points_[b];
    const PointNumber dx = q.x - p.x, dy = q.y - p.y;
    const PointNumber dd = dx * dx + dy * dy;
    const PointNumber s = dd - q.w + p.w;
    const PointNumber root = left ? PointNumber(CGAL::sqrt(radicand)) : PointNumber(-CGAL::sqrt(radicand));
    const PointNumber twice = PointNumber(2) * dd;
    Crossing out{typename Points::Point_2(p.x + (s * dx - root * dy) / twice, p.y + (s * dy + root * dx) / twice)};
    for (const TouchedSample& sample : input_[a].samples) {
      if (input_[b].find(sample.site) == nullptr) continue;
      const Vec2 p_of = sample.position;
      if (out.point == typename Points::Point_2(PointNumber(p_of.x), PointNumber(p_of.y))) out.site = sample.site;
    }
    return out;
  } else {
    throw NeedsRoots{};
  }
}

template <class Balls, class Points>
auto UnionPipeline<Balls, Points>::crossing_of(Slot a, Slot b, bool left) -> std::optional<Crossing> {
  if (use_samples_) {
    if (auto found = crossing_by_sample(a, b, left)) return found;
  }
  const BallOf<PointNumber>& p = ball_in_points_[a];
  const BallOf<PointNumber>& q = ball_in_points_[b];
  const PointNumber dx = q.x - p.x, dy = q.y - p.y;
  const PointNumber dd = dx * dx + dy * dy;
  const PointNumber s = dd - q.w + p.w;
  const PointNumber radicand = PointNumber(4) * dd * p.w - s * s;
  if (CGAL::sign(radicand) == CGAL::NEGATIVE) {
    ++t_.counts.negative_radicands;
    return std::nullopt;
  }
  return crossing_by_root(a, b, left, radicand);
}

template <class Balls, class Points>
void UnionPipeline<Balls, Points>::cross(Slot edge, bool left) {
  // Where rounding matters it must not depend on the order in which the balls came.
  Slot a = rt_.edges[edge].v[0];
  Slot b = rt_.edges[edge].v[1];
  const bool is_turned = comes_before(b, a);
  if (is_turned) std::swap(a, b);
  if (auto crossing = crossing_of(a, b, left != is_turned))
    raw_.push_back({edge, static_cast<std::uint8_t>(left ? 0 : 1), std::move(*crossing), {}});
}

// In rounds, as the balls were; the crossings themselves come in the order of neighbours.
template <class Balls, class Points>
void UnionPipeline<Balls, Points>::insert_crossings() {
  const std::vector<Slot> order = in_rounds(raw_.size());
  std::size_t done = 0;
  for (const Slot i : order) {
    if ((++done & 0x3fU) == 0) job_.checkpoint(raw_.size() + done, 4 * raw_.size());
    raw_[i].vertex = dt_.insert(raw_[i].crossing.point, hint_);
    hint_ = raw_[i].vertex->face();
  }
}

template <class Balls, class Points>
Slot UnionPipeline<Balls, Points>::add_v_point(const Raw& raw) {
  ++t_.counts.raw_v_points;
  Slot& v = raw.vertex->info().slot;
  if (v == kNoSlot) {
    v = static_cast<Slot>(t_.v_points.size());
    const auto& p = raw.vertex->point();
    t_.v_points.push_back({{rounded(p.x()), rounded(p.y())}, kNoSlot, 0});
    v_vertex_.push_back(raw.vertex);
  }
  VPoint& point = t_.v_points[v];
  if (raw.crossing.site != kNoSlot) point.site = raw.crossing.site;
  ++point.multiplicity;
  t_.v_origins.push_back({v, dual_of_edge_[raw.edge]});
  return v;
}

// Three circles meet in the centre of a triangle of radius zero: in one of the two crossings of each pair, that away
// from the third ball exactly if the third one has no more power than the two in the middle between the crossings.
template <class Balls, class Points>
bool UnionPipeline<Balls, Points>::is_center_here(Slot edge, Slot inner_face) const {
  const auto& ends = rt_.edges[edge].v;
  for (const Slot c : rt_.faces[inner_face].v)
    if (c != ends[0] && c != ends[1])
      return sign_of_excess_at_foot<Balls>(ball_[ends[0]], ball_[ends[1]], ball_[c]) <= 0;
  return false;
}

template <class Balls, class Points>
void UnionPipeline<Balls, Points>::make_v_points() {
  crossing_.assign(t_.dual_edges.size(), {kNoSlot, kNoSlot});
  for (Slot e = 0; e < rt_.edges.size(); ++e) {
    if ((e & 0x3fU) == 0) job_.checkpoint(rt_.edges.size() + e, 4 * rt_.edges.size());
    const Slot row = dual_of_edge_[e];
    if (row == kNoSlot) continue;
    const auto& edge = rt_.edges[e];
    DualEdge& dual = t_.dual_edges[row];
    dual.shares_sample = common_sample(input_[edge.v[0]], input_[edge.v[1]]) != nullptr ? 1 : 0;
    t_.counts.edges_without_sample += dual.shares_sample != 0 ? 0 : 1;
    for (std::size_t side = 0; side < 2; ++side) {
      const bool is_filled = edge.f[side] != kNoSlot && face_sign_[edge.f[side]] <= 0;
      if (!is_filled) cross(e, side == 0);
    }
  }
  insert_crossings();
  for (const Raw& raw : raw_) {
    const Slot row = dual_of_edge_[raw.edge];
    const Slot v = add_v_point(raw);
    crossing_[row][raw.side] = v;
    // A group of triangles of radius zero ends here: its common centre is this crossing.
    const Slot inner = rt_.edges[raw.edge].f[1 - raw.side];
    if (t_.dual_edges[row].kind == DualClass::regular && zero_group_[inner] != kNoSlot &&
        is_center_here(raw.edge, inner))
      group_v_[zero_group_[inner]] = v;
  }
}

template <class Balls, class Points>
void UnionPipeline<Balls, Points>::triangulate_v_points() {
  const auto square_of = [this](const VEdge& edge) {
    const Vec2 d = t_.v_points[edge.v[1]].position - t_.v_points[edge.v[0]].position;
    return dot(d, d);
  };
  if (dt_.dimension() == 2) {
    // Rows in the order of the v-points, which are close to their neighbours.
    std::vector<typename Dt::Face_handle> handles;
    std::vector<KeyedSlot> order;
    handles.reserve(2 * t_.v_points.size());
    order.reserve(2 * t_.v_points.size());
    for (auto f = dt_.finite_faces_begin(); f != dt_.finite_faces_end(); ++f) {
      if ((handles.size() & 0x3fU) == 0) job_.checkpoint();
      order.push_back({std::min({f->vertex(0)->info().slot, f->vertex(1)->info().slot, f->vertex(2)->info().slot}),
                       static_cast<Slot>(handles.size())});
      handles.push_back(f);
    }
    std::vector<KeyedSlot> scratch;
    radix_sort(order, scratch, static_cast<unsigned>(std::bit_width(t_.v_points.size())));
    t_.v_faces.resize(order.size());
    v_handle_.resize(order.size());
    for (Slot slot = 0; slot < order.size(); ++slot) {
      const auto f = handles[order[slot].slot];
      v_handle_[slot] = f;
      f->info().slot = slot;
      for (int i = 0; i < 3; ++i) t_.v_faces[slot].v[i] = f->vertex(i)->info().slot;
    }
  }
  double longest = 0.0;
  const auto add = [&](const VEdge& row) {
    longest = std::max(longest, square_of(row));
    t_.v_edges.push_back(row);
    return static_cast<Slot>(t_.v_edges.size() - 1);
  };
  t_.v_edges.reserve(3 * t_.v_points.size());
  if (dt_.dimension() == 1) {
    for (auto e = dt_.finite_edges_begin(); e != dt_.finite_edges_end(); ++e) {
      const auto f = e->first;
      f->info().edge[2] = add({{f->vertex(0)->info().slot, f->vertex(1)->info().slot}});
    }
  }
  for (Slot slot = 0; slot < v_handle_.size(); ++slot) {
    const auto f = v_handle_[slot];
    for (int i = 0; i < 3; ++i) {
      const auto g = f->neighbor(i);
      const Slot other = g->info().slot;  // kNoSlot outside
      if (other < slot) continue;
      const Slot own = add({{f->vertex(Dt::ccw(i))->info().slot, f->vertex(Dt::cw(i))->info().slot}, {slot, other}});
      f->info().edge[i] = own;
      g->info().edge[g->index(f)] = own;
    }
  }
  for (const VEdge& edge : t_.v_edges)
    if (square_of(edge) < 1e-14 * longest) ++t_.counts.near_duplicates;
}

// Fills `places_` with the v-points on the circle of the ball, counter-clockwise. The triangles around the ball come
// in the same order as the corners of its power cell, and those corners that lie on the circle are v-points.
template <class Balls, class Points>
void UnionPipeline<Balls, Points>::walk_around(Slot ball) {
  places_.clear();
  std::vector<Spoke>& star = star_;
  star.clear();
  if (rt_.dimension == 2) {
    const Slot start = some_face_[ball];
    Slot at = start;
    do {
      const auto& face = rt_.faces[at];
      const std::size_t i = face.v[0] == ball ? 0 : (face.v[1] == ball ? 1 : 2);
      star.push_back({face_edge_[at][(i + 2) % 3], at});
      at = face.n[(i + 1) % 3];
      if (at == kNoSlot || star.size() > rt_.faces.size())
        throw GeometryError("the triangulation of the balls is torn");
    } while (at != start);
  } else {
    for (const Slot e : line_edges_[ball]) star.push_back({e, kNoSlot});
  }
  if (star.empty()) return;
  const auto is_in = [&](Slot face) { return face != kNoSlot && face_sign_[face] <= 0; };
  const auto push = [&](Slot v, Arc before) {
    if (v == kNoSlot) return;
    if (places_.empty() || places_.back().v != v) places_.push_back({v, before});
  };
  const auto push_group = [&](Slot face) {
    if (is_in(face) && zero_group_[face] != kNoSlot) push(group_v_[zero_group_[face]], Arc::covered);
  };
  std::size_t first = 0;
  while (first < star.size() && is_in(star[(first + star.size() - 1) % star.size()].left)) ++first;
  const bool is_interior = first == star.size();
  for (std::size_t k = 0; k < star.size(); ++k) {
    const std::size_t at = ((is_interior ? 0 : first) + k) % star.size();
    const bool right_in = is_in(star[(at + star.size() - 1) % star.size()].left);
    const bool left_in = is_in(star[at].left);
    const Slot row = star[at].edge == kNoSlot ? kNoSlot : dual_of_edge_[star[at].edge];
    if (row != kNoSlot && !(right_in && left_in)) {
      const bool outward = rt_.edges[star[at].edge].v[0] == ball;
      const Slot left_v = crossing_[row][outward ? 0 : 1];
      const Slot right_v = crossing_[row][outward ? 1 : 0];
      if (!right_in) push(right_v, Arc::free);
      if (!left_in) push(left_v, right_in ? Arc::covered : Arc::singular);
    }
    push_group(star[at].left);
  }
  if (places_.size() > 1 && places_.front().v == places_.back().v) {
    places_.front().before = places_.back().before;
    places_.pop_back();
  }
}

template <class Balls, class Points>
void UnionPipeline<Balls, Points>::add_event(Slot ball, Slot from, Slot to, Arc arc) {
  typename Dt::Face_handle f;
  int i = 0;
  if (!dt_.is_edge(v_vertex_[from], v_vertex_[to], f, i)) {
    ++t_.counts.lost_crossings;
    return;
  }
  const Slot edge = f->info().edge[i];
  // The arc runs from `from` to `to` to the right of the straight way.
  const std::uint8_t side = t_.v_edges[edge].v[0] == from ? 1 : 0;
  events_.push_back({edge, ball, side, arc});
  VEdgeKind& kind = t_.v_edges[edge].kind;
  if (arc == Arc::singular) {
    kind = VEdgeKind::alpha;
  } else if (kind == VEdgeKind::plain) {
    kind = VEdgeKind::crossing;
  }
}

// All triangles between the v-points of one circle have its centre as circumcentre.
template <class Balls, class Points>
void UnionPipeline<Balls, Points>::mark_polygon(Slot ball, const std::vector<Slot>& points) {
  stamp_.resize(t_.v_points.size(), 0);
  ++now_;
  for (const Slot v : points) stamp_[v] = now_;
  const auto is_on_circle = [&](typename Dt::Face_handle f) {
    for (int i = 0; i < 3; ++i)
      if (dt_.is_infinite(f->vertex(i)) || stamp_[f->vertex(i)->info().slot] != now_) return false;
    return true;
  };
  std::vector<typename Dt::Face_handle>& stack = stack_;
  stack.clear();
  const auto visit = [&](typename Dt::Face_handle f) {
    if (!is_on_circle(f)) return;
    // With rounded points a triangle may seem to be on two circles; which takes it must not depend on the order.
    Slot& owner = t_.v_faces[f->info().slot].ball;
    if (owner == ball || (owner != kNoSlot && comes_before(owner, ball))) return;
    owner = ball;
    stack.push_back(f);
  };
  for (std::size_t k = 0; k < points.size(); ++k) {
    typename Dt::Face_handle f;
    int i = 0;
    if (!dt_.is_edge(v_vertex_[points[k]], v_vertex_[points[(k + 1) % points.size()]], f, i)) continue;
    visit(f);
    visit(f->neighbor(i));
  }
  while (!stack.empty()) {
    const auto f = stack.back();
    stack.pop_back();
    for (int i = 0; i < 3; ++i) visit(f->neighbor(i));
  }
}

template <class Balls, class Points>
void UnionPipeline<Balls, Points>::gather_events() {
  line_edges_.assign(rt_.dimension == 1 ? input_.size() : 0, {});
  if (rt_.dimension == 1)
    for (Slot e = 0; e < rt_.edges.size(); ++e)
      for (const Slot ball : rt_.edges[e].v) line_edges_[ball].push_back(e);
  std::vector<bool> has_edge(input_.size(), false);
  for (const auto& edge : rt_.edges)
    if (dual_of_edge_[static_cast<std::size_t>(&edge - rt_.edges.data())] != kNoSlot)
      has_edge[edge.v[0]] = has_edge[edge.v[1]] = true;
  std::vector<bool> is_covered(input_.size(), false);
  for (const auto& edge : rt_.edges)
    for (std::size_t i = 0; i < 2; ++i)
      if (!has_edge[edge.v[i]] && loses_center_to<Balls>(ball_[edge.v[i]], ball_[edge.v[1 - i]]))
        is_covered[edge.v[i]] = true;
  for (Slot ball = 0; ball < input_.size(); ++ball) {
    if ((ball & 0x3fU) == 0) job_.checkpoint(2 * input_.size() + ball, 4 * input_.size());
    if (rt_.state[ball] != BallState::visible) continue;
    const Slot row = input_[ball].row;
    if (!has_edge[ball]) {
      // Its cell may lie outside of the ball, which is then part of another one.
      t_.balls[row] = is_covered[ball] ? BallState::hidden : BallState::isolated;
      if (is_covered[ball]) continue;
      t_.arcs.push_back({row, {}, {}, 1});
      continue;
    }
    walk_around(ball);
    for (std::size_t k = 0; k < places_.size(); ++k) {
      const Place& to = places_[k];
      const Place& from = places_[(k + places_.size() - 1) % places_.size()];
      if (to.before == Arc::free)
        t_.arcs.push_back({row, t_.v_points[from.v].position, t_.v_points[to.v].position,
                           static_cast<std::uint8_t>(places_.size() == 1 ? 1 : 0)});
    }
    take_places(ball);
  }
}

// What the v-points on the circle of a ball say of the Voronoi edges through its centre.
template <class Balls, class Points>
void UnionPipeline<Balls, Points>::take_places(Slot ball) {
  if (places_.size() < 2) return;
  std::vector<Slot>& points = points_;
  points.clear();
  for (std::size_t k = 0; k < places_.size(); ++k) {
    points.push_back(places_[k].v);
    add_event(ball, places_[(k + places_.size() - 1) % places_.size()].v, places_[k].v, places_[k].before);
  }
  if (dt_.dimension() == 2 && points.size() >= 3) mark_polygon(ball, points);
}

template <class Balls, class Points>
UnionTables UnionPipeline<Balls, Points>::run_v_diagram(const KnownVPoints& known) {
  for (const PipelineBall& ball : input_) ball_in_points_.push_back(ball_in<PointNumber>(ball));
  for (std::size_t i = 0; i < known.points.size(); ++i) {
    const Vec2 p = known.points[i];
    const auto vertex = dt_.insert(typename Points::Point_2(PointNumber(p.x), PointNumber(p.y)), hint_);
    hint_ = vertex->face();
    MES_ASSERT(vertex->info().slot == kNoSlot);
    vertex->info().slot = static_cast<Slot>(i);
    v_vertex_.push_back(vertex);
    t_.v_points.push_back({p, known.sites[i], 1});
  }
  triangulate_v_points();
  for (Slot ball = 0; ball < input_.size(); ++ball) {
    places_ = known.places[ball];
    take_places(ball);
  }
  cut_edges();
  t_.axis.clear();
  return std::move(t_);
}

template <class Balls, class Points>
Slot UnionPipeline<Balls, Points>::node_of(Slot face) const {
  const Slot ball = t_.v_faces[face].ball;
  return ball != kNoSlot ? input_[ball].row : static_cast<Slot>(t_.balls.size()) + face;
}

template <class Balls, class Points>
Circle UnionPipeline<Balls, Points>::circle_of(typename Dt::Face_handle face) {
  if constexpr (std::is_same_v<PointNumber, double>) {
    Vec2 corner[3];
    for (int i = 0; i < 3; ++i) corner[i] = {face->vertex(i)->point().x(), face->vertex(i)->point().y()};
    std::ranges::rotate(corner, std::ranges::min_element(corner, lexicographically_less));
    return circumcircle(corner[0], corner[1], corner[2]);
  } else {
    const auto center =
        CGAL::circumcenter(face->vertex(0)->point(), face->vertex(1)->point(), face->vertex(2)->point());
    const Vec2 at{rounded(center.x()), rounded(center.y())};
    const Vec2 corner{rounded(face->vertex(0)->point().x()), rounded(face->vertex(0)->point().y())};
    return {at, distance(at, corner)};
  }
}

// Stable; O(events + edges).
template <class Balls, class Points>
void UnionPipeline<Balls, Points>::sort_by_edge(std::vector<Event>& events) const {
  std::vector<Slot> start(t_.v_edges.size() + 1, 0);
  for (const Event& event : events) ++start[event.edge + 1];
  for (std::size_t e = 1; e < start.size(); ++e) start[e] += start[e - 1];
  std::vector<Event> sorted(events.size());
  for (const Event& event : events) sorted[start[event.edge]++] = event;
  events.swap(sorted);
}

// Cuts the Voronoi edges of the v-points at the centres on them and keeps what lies in |R|.
template <class Balls, class Points>
void UnionPipeline<Balls, Points>::cut_edges() {
  // With doubles the two ends of a piece may contradict each other; then the greater counts.
  enum class Label : std::uint8_t { unknown, out, singular, in };
  struct Cut {
    Slot edge;
    Slot end[2];  // balls (positions in the input), or kNoSlot: the end of the Voronoi edge
    Label label;
  };
  std::vector<Cut> cuts;
  cuts.reserve(t_.v_edges.size() + events_.size());
  sort_by_edge(events_);
  std::vector<Slot> on_edge;
  for (std::size_t begin = 0, e = 0; e < t_.v_edges.size(); ++e) {
    std::size_t end = begin;
    while (end < events_.size() && events_[end].edge == e) ++end;
    on_edge.clear();
    for (std::size_t k = begin; k < end; ++k)
      if (std::ranges::find(on_edge, events_[k].ball) == on_edge.end()) on_edge.push_back(events_[k].ball);
    if (on_edge.size() > 1) {
      const auto point_of = [&](Slot ball) {
        return typename Points::Point_2(ball_in_points_[ball].x, ball_in_points_[ball].y);
      };
      const auto& p = v_vertex_[t_.v_edges[e].v[0]]->point();
      const auto& q = v_vertex_[t_.v_edges[e].v[1]]->point();
      std::ranges::sort(on_edge, [&](Slot a, Slot b) {
        const auto order = typename Points::Compare_signed_distance_to_line_2()(p, q, point_of(a), point_of(b));
        return order == CGAL::LARGER || (order == CGAL::EQUAL && comes_before(a, b));
      });
    }
    const auto label_towards = [&](Slot ball, std::uint8_t side) {
      Label label = Label::unknown;
      for (std::size_t k = begin; k < end; ++k) {
        if (events_[k].ball != ball || events_[k].side != side) continue;
        const Arc arc = events_[k].arc;
        label = std::max(label, arc == Arc::covered ? Label::in : (arc == Arc::free ? Label::out : Label::singular));
      }
      return label;
    };
    for (std::size_t k = 0; k <= on_edge.size(); ++k) {
      const Slot a = k == 0 ? kNoSlot : on_edge[k - 1];
      const Slot b = k == on_edge.size() ? kNoSlot : on_edge[k];
      const Label from_a = a == kNoSlot ? Label::unknown : label_towards(a, 1);
      const Label from_b = b == kNoSlot ? Label::unknown : label_towards(b, 0);
      if (from_a != Label::unknown && from_b != Label::unknown && from_a != from_b) ++t_.counts.contradictions;
      cuts.push_back({static_cast<Slot>(e), {a, b}, std::max(from_a, from_b)});
    }
    begin = end;
  }
  // An end of a piece at a face: the face, unless its circumcentre is a ball's centre.
  const auto face_at = [&](const Cut& cut, std::size_t i) {
    return cut.end[i] == kNoSlot ? t_.v_edges[cut.edge].f[i] : kNoSlot;
  };
  const auto is_plain = [&](Slot face) { return face != kNoSlot && t_.v_faces[face].ball == kNoSlot; };
  std::vector<std::array<Slot, 3>> cuts_at(t_.v_faces.size(), {kNoSlot, kNoSlot, kNoSlot});
  std::vector<Slot> queue;
  const auto settle = [&](Slot face) {
    if (!is_plain(face) || t_.v_faces[face].is_inside != 0) return;
    t_.v_faces[face].is_inside = 1;
    queue.push_back(face);
  };
  for (Slot c = 0; c < cuts.size(); ++c) {
    for (std::size_t i = 0; i < 2; ++i) {
      const Slot face = face_at(cuts[c], i);
      if (!is_plain(face)) continue;
      for (Slot& place : cuts_at[face]) {
        if (place != kNoSlot) continue;
        place = c;
        break;
      }
    }
  }
  for (VFace& face : t_.v_faces)
    if (face.ball != kNoSlot) face.is_inside = 1;
  for (const Cut& cut : cuts)
    if (cut.label == Label::in)
      for (std::size_t i = 0; i < 2; ++i) settle(face_at(cut, i));
  for (std::size_t next = 0; next < queue.size(); ++next) {
    for (const Slot c : cuts_at[queue[next]]) {
      if (c == kNoSlot) continue;
      if (cuts[c].label == Label::out) ++t_.counts.contradictions;
      if (cuts[c].label == Label::unknown) cuts[c].label = Label::in;
      for (std::size_t i = 0; i < 2; ++i) settle(face_at(cuts[c], i));
    }
  }
  // Circumcentres where something is drawn.
  for (Slot slot = 0; slot < v_handle_.size(); ++slot) {
    VFace& face = t_.v_faces[slot];
    if (face.ball != kNoSlot) {
      face.center = input_[face.ball].disk.center;
      face.radius = input_[face.ball].radius();
    } else {
      const Circle circle = circle_of(v_handle_[slot]);
      face.center = circle.center;
      face.radius = circle.radius;
    }
  }
  struct End {
    Slot node;
    Vec2 at;
    double radius;
  };
  const auto end_of = [&](const Cut& cut, std::size_t i) -> std::optional<End> {
    if (cut.end[i] != kNoSlot) {
      const PipelineBall& ball = input_[cut.end[i]];
      return End{ball.row, ball.disk.center, ball.radius()};
    }
    const Slot face = t_.v_edges[cut.edge].f[i];
    if (face == kNoSlot) return std::nullopt;
    return End{node_of(face), t_.v_faces[face].center, t_.v_faces[face].radius};
  };
  for (const Cut& cut : cuts) {
    const VEdge& edge = t_.v_edges[cut.edge];
    if (cut.label != Label::in) {
      // Between two triangles of one circle nothing is left to be labelled.
      continue;
    }
    const auto a = end_of(cut, 0);
    const auto b = end_of(cut, 1);
    if (!a || !b) {
      ++t_.counts.contradictions;
      continue;
    }
    if (a->node == b->node) continue;
    AxisPiece piece{a->at, b->at, a->radius, b->radius, {a->node, b->node}, {edge.v[0], edge.v[1]}};
    if (is_plain(face_at(cut, 0)) && is_plain(face_at(cut, 1))) piece.is_zero = a->at == b->at ? 1 : 0;
    t_.axis.push_back(piece);
  }
  for (Slot e = 0; e < rt_.edges.size(); ++e) {
    const Slot row = dual_of_edge_[e];
    if (row == kNoSlot || t_.dual_edges[row].kind != DualClass::singular) continue;
    const PipelineBall& a = input_[rt_.edges[e].v[0]];
    const PipelineBall& b = input_[rt_.edges[e].v[1]];
    t_.axis.push_back({a.disk.center,
                       b.disk.center,
                       a.radius(),
                       b.radius(),
                       {a.row, b.row},
                       {crossing_[row][0], crossing_[row][1]},
                       1});
  }
  for (VFace& face : t_.v_faces)
    if (face.ball != kNoSlot) face.ball = input_[face.ball].row;
}

}  // namespace mes
