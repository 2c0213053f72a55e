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
#include <CGAL/number_utils.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <optional>
#include <span>
#include <type_traits>
#include <vector>

#include "core/base/assert.h"
#include "core/base/box2.h"
#include "core/base/disk.h"
#include "core/base/job_control.h"
#include "core/base/parallel.h"
#include "core/base/sum.h"
#include "core/kernel/ball_signs.h"
#include "core/kernel/circumcircle.h"
#include "core/kernel/kernels.h"
#include "core/kernel/rounding.h"
#include "core/structures/balls/internal/union_runs.h"
#include "core/structures/balls/internal/union_tables.h"
#include "core/structures/triangulation/point_triangulation.h"
#include "core/structures/triangulation/regular_triangulation.h"

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

/// A coordinate of the frame in the document, rounded once; `local` is the same rounded in the frame.
template <class Number>
double coordinate_in_document(const Number& exact, double local, double origin, int exponent) {
  if constexpr (!std::is_same_v<Number, double>) {
    if (origin != 0.0) return rounded(Number(exact * Number(std::ldexp(1.0, exponent)) + Number(origin)));
  }
  return origin + std::ldexp(local, exponent);
}

/// A point in both systems of coordinates.
struct PlacedPoint {
  Vec2 local;
  Vec2 document;
};
template <class Number>
PlacedPoint placed(const Number& x, const Number& y, const LocalFrame& frame) {
  const Vec2 local{rounded(x), rounded(y)};
  return {local,
          {coordinate_in_document(x, local.x, frame.origin.x, frame.exponent),
           coordinate_in_document(y, local.y, frame.origin.y, frame.exponent)}};
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
      : input_(input.balls), frame_(input.frame), use_samples_(use_samples), job_(job) {
    t_.balls.assign(input.rows, BallState::none);
  }

  UnionTables run() {
    triangulate();
    classify();
    make_v_points();
    triangulate_v_points();
    gather_events();
    cut_edges();
    spread_labels();
    place_faces();
    make_axis();
    measure();
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
  using Point = typename Points::Point_2;
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
  std::int8_t dual_triangles_at(const RegularTables::Edge& edge) const;
  void group_zero_faces();
  void make_v_points();
  struct Crossing {
    Point point;
    Slot site = kNoSlot;
  };
  std::optional<Crossing> crossing_of(Slot a, Slot b, bool left);
  std::optional<Crossing> crossing_by_sample(Slot a, Slot b, bool left);
  Crossing crossing_by_root(Slot a, Slot b, bool left, const PointNumber& radicand);
  /// A v-point as one dual edge gives it.
  struct Raw {
    Slot edge;          // of the regular triangulation
    std::uint8_t side;  // 0 = left
    Slot site;
  };
  void cross(Slot edge, bool left);
  Slot add_v_point(std::size_t raw, Slot& row_of_place);
  void triangulate_v_points();
  void count_near_duplicates();
  void list_edges_at_points();
  Slot v_edge_between(Slot from, Slot to) const;
  void gather_events();
  struct Spoke {
    Slot edge;
    Slot left;  // face
  };
  /// A free part of a circle, counter-clockwise, and the balls that cover what is before and after it.
  struct Gap {
    Slot from = kNoSlot, to = kNoSlot;  // v-points; kNoSlot = lost
    Slot before = kNoSlot, after = kNoSlot;
  };
  /// What a range of balls says, in their order, and work space of one ball.
  struct Findings {
    std::vector<Event> events;
    std::vector<BoundaryArc> arcs;               // of positions in the input, not rows
    std::vector<std::array<Slot, 2>> on_circle;  // face of the v-points, ball
    std::int64_t lost_crossings = 0;
    std::vector<Spoke> star;
    std::vector<Place> places;
    std::vector<Gap> gaps;
    std::vector<Slot> stack;
    std::vector<std::uint32_t> point_stamp, face_stamp;  // of the circle at hand
    std::uint32_t now = 0;
  };
  template <class Look>
  void ask_balls(Look look);
  void look_at(Slot ball, bool has_edge, bool is_covered, Findings& found);
  void walk_around(Slot ball, Findings& found) const;
  void add_arc(Slot ball, const Gap& gap, Findings& found) const;
  bool is_gap_all_around(Slot ball, const Gap& gap) const;
  Vec2 seen_from_center(Slot ball, Slot other, bool left, Slot v) const;
  void take_places(Slot ball, Findings& found) const;
  void add_event(Slot ball, Slot from, Slot to, Arc arc, Findings& found) const;
  void mark_polygon(Slot ball, Findings& found) const;
  bool comes_before(Slot a, Slot b) const {
    return lexicographically_less(input_[a].disk.center, input_[b].disk.center);
  }
  bool is_center_here(Slot edge, Slot inner_face) const;
  std::vector<Slot> sort_by_edge(std::vector<Event>& events) const;
  Point point_of(Slot v) const {
    if constexpr (kIsDouble) {
      return {v_local_[v].x, v_local_[v].y};
    } else {
      return v_at_[v];
    }
  }
  static constexpr double kTurn = 2.0 * std::numbers::pi;
  /// Numbers other than doubles belong to one thread.
  static constexpr bool kIsDouble = std::is_same_v<BallNumber, double> && std::is_same_v<PointNumber, double>;
  static std::size_t part_count(std::size_t count) {
    return kIsDouble ? std::clamp<std::size_t>(count >> 12U, 1, 8) : 1;
  }
  /// Calls `body(begin, end, part)` for the parts of [0, count), side by side. The split depends on `count` alone.
  template <class Body>
  static void in_parts(std::size_t count, Body body) {
    const std::size_t parts = part_count(count);
    run_tasks(parts, [&](std::size_t part) { body(count * part / parts, count * (part + 1) / parts, part); });
  }
  // With doubles the two ends of a piece may contradict each other; then the greater counts.
  enum class Label : std::uint8_t { unknown, out, singular, in };
  struct Cut {
    Slot edge;
    Slot end[2];  // balls (positions in the input), or kNoSlot: the end of the Voronoi edge
    Label label;
  };
  /// Work space of a range of edges.
  struct Cutter {
    std::vector<Slot> on_edge;  // balls
    std::int64_t contradictions = 0;
  };
  static void list_balls(std::span<const Event> events, std::vector<Slot>& balls);
  void cut_edge(Slot e, std::span<const Event> events, Cutter& cutter);
  void cut_edges();
  /// An end of a cut at a face: the face, unless its circumcentre is a ball's centre.
  Slot face_at(const Cut& cut, std::size_t i) const {
    return cut.end[i] == kNoSlot ? t_.v_edges[cut.edge].f[i] : kNoSlot;
  }
  bool is_plain(Slot face) const { return face != kNoSlot && t_.v_faces[face].ball == kNoSlot; }
  void spread_labels();
  void place_faces();
  /// Of the axis: rows of balls, then those of faces; kNoSlot = none, the cut goes on for ever.
  Slot node_at(const Cut& cut, std::size_t i) const;
  /// Seen from the ends of a piece of the axis: where it lies in the frame.
  struct LocalPiece {
    Vec2 a, b;
    double length() const { return distance(a, b); }
  };
  LocalPiece local_piece_of(const Cut& cut) const;
  AxisPiece piece_of(const Cut& cut) const;
  bool is_axis(const Cut& cut) const;
  void make_axis();
  struct PlacedCircle {
    Circle local;
    Vec2 center;  // in the document
  };
  PlacedCircle circle_of(Slot face) const;
  struct Totals {
    Sum area, perimeter, axis_length;
    void add(const Totals& other) {
      area.add(other.area);
      perimeter.add(other.perimeter);
      axis_length.add(other.axis_length);
    }
  };
  void measure();

  std::span<const PipelineBall> input_;
  LocalFrame frame_;
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
  std::vector<Point> raw_point_;
  PointTriangulation crossings_;
  std::vector<Slot> row_of_point_;                // in v_points, for the points that stand for others
  std::vector<Point> v_at_;                       // by row of v_points
  std::vector<Vec2> v_local_;                     // rounded, by row of v_points
  std::vector<Vec2> face_center_;                 // in the frame, rounded, by row of v_faces
  std::vector<std::array<Slot, 3>> v_face_edge_;  // by row of v_faces
  struct EdgeTo {
    Slot to, edge;
  };
  std::vector<EdgeTo> edges_at_;   // those at v-point v begin at edges_begin_[v]
  std::vector<Slot> edges_begin_;  // by row of v_points, and one more
  std::vector<Event> events_;
  std::vector<Cut> cuts_;         // by edge, from its left face to its right one
  std::vector<Slot> cuts_begin_;  // by row of v_edges, and one more
};

template <class Balls, class Points>
void UnionPipeline<Balls, Points>::triangulate() {
  ball_.resize(input_.size());
  ball_in_points_.resize(input_.size());
  in_parts(input_.size(), [&](std::size_t begin, std::size_t end, std::size_t) {
    for (std::size_t i = begin; i < end; ++i) {
      ball_[i] = ball_in<BallNumber>(input_[i]);
      ball_in_points_[i] = ball_in<PointNumber>(input_[i]);
    }
  });
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
  std::vector<std::uint8_t> has_sample(rt_.faces.size(), 0);
  const auto judge = [&](Slot f) {
    if (is_infinite(f)) return;
    const auto& v = rt_.faces[f].v;
    face_sign_[f] = static_cast<std::int8_t>(sign_of_orthogonal_radius<Balls>(ball_[v[0]], ball_[v[1]], ball_[v[2]]));
    has_sample[f] = common_sample(input_[v[0]], input_[v[1]], input_[v[2]]) != nullptr ? 1 : 0;
  };
  in_parts(rt_.faces.size(), [&](std::size_t begin, std::size_t end, std::size_t) {
    for (std::size_t f = begin; f < end; ++f) {
      if ((f & 0xffU) == 0) job_.checkpoint(f, 4 * rt_.faces.size());
      judge(static_cast<Slot>(f));
    }
  });
  job_.checkpoint();
  t_.dual_faces.reserve(
      static_cast<std::size_t>(std::ranges::count_if(face_sign_, [](int sign) { return sign <= 0; })));
  for (Slot f = 0; f < rt_.faces.size(); ++f) {
    if (is_infinite(f)) continue;
    const auto& v = rt_.faces[f].v;
    const int sign = face_sign_[f];
    const bool touches_sample = has_sample[f] != 0;
    if (touches_sample && sign != 0) ++t_.counts.sign_flips;
    if (sign < 0 && !touches_sample) ++t_.counts.negative_faces;
    if (sign > 0) continue;
    t_.dual_faces.push_back(
        {{input_[v[0]].row, input_[v[1]].row, input_[v[2]].row}, static_cast<std::int8_t>(sign), has_sample[f]});
  }
  group_zero_faces();
  dual_of_edge_.assign(rt_.edges.size(), kNoSlot);
  t_.dual_edges.reserve(rt_.edges.size());
  std::vector<std::int8_t> triangles_at(rt_.edges.size());  // -1 = the edge is not in
  in_parts(rt_.edges.size(), [&](std::size_t begin, std::size_t end, std::size_t) {
    for (std::size_t e = begin; e < end; ++e) triangles_at[e] = dual_triangles_at(rt_.edges[e]);
  });
  for (Slot e = 0; e < rt_.edges.size(); ++e) {
    if (triangles_at[e] < 0) continue;
    const auto& ball = rt_.edges[e].v;
    dual_of_edge_[e] = static_cast<Slot>(t_.dual_edges.size());
    t_.dual_edges.push_back({{input_[ball[0]].row, input_[ball[1]].row}, static_cast<DualClass>(triangles_at[e]), 0});
  }
}

// How many of them are in; -1 if the edge itself is not.
template <class Balls, class Points>
std::int8_t UnionPipeline<Balls, Points>::dual_triangles_at(const RegularTables::Edge& edge) const {
  std::int8_t triangles = 0;
  for (const Slot f : edge.f)
    if (f != kNoSlot && face_sign_[f] <= 0) ++triangles;
  if (triangles != 0) return triangles;
  const BallOf<BallNumber>& a = ball_[edge.v[0]];
  const BallOf<BallNumber>& b = ball_[edge.v[1]];
  for (const Slot f : edge.f) {
    if (f == kNoSlot || is_infinite(f)) continue;
    for (const Slot c : rt_.faces[f].v)
      if (c != edge.v[0] && c != edge.v[1] && sign_of_excess_at_foot<Balls>(a, b, ball_[c]) < 0) return -1;
  }
  return sign_of_edge_radius<Balls>(a, b) > 0 ? std::int8_t{-1} : std::int8_t{0};
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
  if (auto crossing = crossing_of(a, b, left != is_turned)) {
    raw_.push_back({edge, static_cast<std::uint8_t>(left ? 0 : 1), crossing->site});
    raw_point_.push_back(std::move(crossing->point));
  }
}

template <class Balls, class Points>
Slot UnionPipeline<Balls, Points>::add_v_point(std::size_t raw, Slot& row_of_place) {
  ++t_.counts.raw_v_points;
  if (row_of_place == kNoSlot) {
    row_of_place = static_cast<Slot>(t_.v_points.size());
    const Point& p = raw_point_[raw];
    const PlacedPoint place = placed(p.x(), p.y(), frame_);
    t_.v_points.push_back({place.document, kNoSlot, 0});
    v_local_.push_back(place.local);
    if constexpr (!kIsDouble) v_at_.push_back(p);
  }
  VPoint& point = t_.v_points[row_of_place];
  if (raw_[raw].site != kNoSlot) point.site = raw_[raw].site;
  ++point.multiplicity;
  t_.v_origins.push_back({row_of_place, dual_of_edge_[raw_[raw].edge]});
  return row_of_place;
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
  crossings_ = point_triangulation<Points>(raw_point_, job_);
  row_of_point_.assign(raw_.size(), kNoSlot);
  t_.v_points.reserve(raw_.size());
  t_.v_origins.reserve(raw_.size());
  for (std::size_t i = 0; i < raw_.size(); ++i) {
    const Raw& raw = raw_[i];
    const Slot row = dual_of_edge_[raw.edge];
    const Slot v = add_v_point(i, row_of_point_[crossings_.same_as[i]]);
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
  const auto& faces = crossings_.faces;
  t_.v_faces.resize(faces.size());
  v_face_edge_.resize(faces.size());
  t_.v_edges.reserve(3 * t_.v_points.size());
  for (const auto& [from, to] : crossings_.line) t_.v_edges.push_back({{row_of_point_[from], row_of_point_[to]}});
  for (Slot f = 0; f < faces.size(); ++f) {
    auto& v = t_.v_faces[f].v;
    for (std::size_t i = 0; i < 3; ++i) v[i] = row_of_point_[faces[f].v[i]];
    for (std::size_t i = 0; i < 3; ++i) {
      const Slot g = faces[f].n[i];
      if (g < f) continue;
      const auto edge = static_cast<Slot>(t_.v_edges.size());
      t_.v_edges.push_back({{v[(i + 1) % 3], v[(i + 2) % 3]}, {f, g}});
      v_face_edge_[f][i] = edge;
      if (g == kNoSlot) continue;
      const auto& n = faces[g].n;
      v_face_edge_[g][n[0] == f ? 0 : (n[1] == f ? 1 : 2)] = edge;
    }
  }
  count_near_duplicates();
  list_edges_at_points();
}

template <class Balls, class Points>
void UnionPipeline<Balls, Points>::count_near_duplicates() {
  const auto square_of = [this](const VEdge& edge) {
    const Vec2 d = v_local_[edge.v[1]] - v_local_[edge.v[0]];
    return dot(d, d);
  };
  // No edge is longer than the diagonal, so these hold all edges that are short against the longest.
  Box2 box;
  for (const Vec2 v : v_local_) box.add(v);
  const double diagonal = dot(box.high - box.low, box.high - box.low);
  std::vector<double> short_squares;
  double longest = 0.0;
  for (const VEdge& edge : t_.v_edges) {
    const double square = square_of(edge);
    longest = std::max(longest, square);
    if (square < 1e-14 * diagonal) short_squares.push_back(square);
  }
  for (const double square : short_squares)
    if (square < 1e-14 * longest) ++t_.counts.near_duplicates;
}

template <class Balls, class Points>
void UnionPipeline<Balls, Points>::list_edges_at_points() {
  edges_begin_.assign(t_.v_points.size() + 1, 0);
  for (const VEdge& edge : t_.v_edges)
    for (const Slot v : edge.v) ++edges_begin_[v];
  Slot end = 0;
  for (Slot& begin : edges_begin_) begin = end += begin;
  edges_at_.resize(end);
  for (Slot e = static_cast<Slot>(t_.v_edges.size()); e-- > 0;) {
    const auto& v = t_.v_edges[e].v;
    edges_at_[--edges_begin_[v[0]]] = {v[1], e};
    edges_at_[--edges_begin_[v[1]]] = {v[0], e};
  }
}

template <class Balls, class Points>
Slot UnionPipeline<Balls, Points>::v_edge_between(Slot from, Slot to) const {
  const auto degree = [this](Slot v) { return edges_begin_[v + 1] - edges_begin_[v]; };
  if (degree(to) < degree(from)) std::swap(from, to);
  for (Slot i = edges_begin_[from]; i < edges_begin_[from + 1]; ++i)
    if (edges_at_[i].to == to) return edges_at_[i].edge;
  return kNoSlot;
}

// Fills `places` with the v-points on the circle of the ball, counter-clockwise. The triangles around the ball come
// in the same order as the corners of its power cell, and those corners that lie on the circle are v-points.
template <class Balls, class Points>
void UnionPipeline<Balls, Points>::walk_around(Slot ball, Findings& found) const {
  std::vector<Place>& places = found.places;
  std::vector<Gap>& gaps = found.gaps;
  std::vector<Spoke>& star = found.star;
  places.clear();
  gaps.clear();
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
    if (places.empty() || places.back().v != v) places.push_back({v, before});
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
      const Slot neighbour = rt_.edges[star[at].edge].v[outward ? 1 : 0];
      const Slot left_v = crossing_[row][outward ? 0 : 1];
      const Slot right_v = crossing_[row][outward ? 1 : 0];
      if (!right_in) {
        push(right_v, Arc::free);
        // The first gap begins where the last cover ends.
        if (gaps.empty()) gaps.emplace_back();
        gaps.back().to = right_v;
        gaps.back().after = neighbour;
      }
      if (!left_in) {
        push(left_v, right_in ? Arc::covered : Arc::singular);
        gaps.push_back({left_v, kNoSlot, neighbour, kNoSlot});
      }
    }
    push_group(star[at].left);
  }
  if (gaps.size() > 1) {
    gaps.front().from = gaps.back().from;
    gaps.front().before = gaps.back().before;
    gaps.pop_back();
  }
  if (places.size() > 1 && places.front().v == places.back().v) {
    places.front().before = places.back().before;
    places.pop_back();
  }
}

template <class Balls, class Points>
void UnionPipeline<Balls, Points>::add_event(Slot ball, Slot from, Slot to, Arc arc, Findings& found) const {
  const Slot edge = v_edge_between(from, to);
  if (edge == kNoSlot) {
    ++found.lost_crossings;
    return;
  }
  // The arc runs from `from` to `to` to the right of the straight way.
  const std::uint8_t side = t_.v_edges[edge].v[0] == from ? 1 : 0;
  found.events.push_back({edge, ball, side, arc});
}

// All triangles between the v-points of one circle have its centre as circumcentre.
template <class Balls, class Points>
void UnionPipeline<Balls, Points>::mark_polygon(Slot ball, Findings& found) const {
  found.point_stamp.resize(t_.v_points.size(), 0);
  found.face_stamp.resize(t_.v_faces.size(), 0);
  const std::uint32_t now = ++found.now;
  for (const Place& place : found.places) found.point_stamp[place.v] = now;
  std::vector<Slot>& stack = found.stack;
  stack.clear();
  const auto visit = [&](Slot face) {
    if (face == kNoSlot || found.face_stamp[face] == now) return;
    for (const Slot v : t_.v_faces[face].v)
      if (found.point_stamp[v] != now) return;
    found.face_stamp[face] = now;
    found.on_circle.push_back({face, ball});
    stack.push_back(face);
  };
  for (std::size_t k = 0; k < found.places.size(); ++k) {
    const Slot edge = v_edge_between(found.places[k].v, found.places[(k + 1) % found.places.size()].v);
    if (edge == kNoSlot) continue;
    for (const Slot face : t_.v_edges[edge].f) visit(face);
  }
  while (!stack.empty()) {
    const Slot at = stack.back();
    stack.pop_back();
    for (const Slot edge : v_face_edge_[at])
      for (const Slot face : t_.v_edges[edge].f) visit(face);
  }
}

// Calls `look(ball, findings)` for every ball, and takes what they found in the order of the balls.
template <class Balls, class Points>
template <class Look>
void UnionPipeline<Balls, Points>::ask_balls(Look look) {
  std::vector<Findings> parts(part_count(input_.size()));
  in_parts(input_.size(), [&](std::size_t begin, std::size_t end, std::size_t part) {
    for (std::size_t ball = begin; ball < end; ++ball) {
      if ((ball & 0x3fU) == 0) job_.checkpoint(2 * input_.size() + ball, 4 * input_.size());
      look(static_cast<Slot>(ball), parts[part]);
    }
  });
  std::size_t events = 0;
  std::size_t arcs = 0;
  for (const Findings& found : parts) {
    events += found.events.size();
    arcs += found.arcs.size();
  }
  events_.reserve(events);
  t_.arcs.reserve(arcs);
  for (const Findings& found : parts) {
    events_.insert(events_.end(), found.events.begin(), found.events.end());
    t_.arcs.insert(t_.arcs.end(), found.arcs.begin(), found.arcs.end());
    t_.counts.lost_crossings += found.lost_crossings;
    for (const auto& [face, ball] : found.on_circle) {
      // With rounded points a triangle may seem to be on two circles; which takes it must not depend on the order.
      Slot& owner = t_.v_faces[face].ball;
      if (owner == kNoSlot || comes_before(ball, owner)) owner = ball;
      t_.v_faces[face].is_inside = 1;
    }
  }
}

template <class Balls, class Points>
void UnionPipeline<Balls, Points>::gather_events() {
  line_edges_.assign(rt_.dimension == 1 ? input_.size() : 0, {});
  if (rt_.dimension == 1)
    for (Slot e = 0; e < rt_.edges.size(); ++e)
      for (const Slot ball : rt_.edges[e].v) line_edges_[ball].push_back(e);
  std::vector<bool> has_edge(input_.size(), false);
  for (Slot e = 0; e < rt_.edges.size(); ++e)
    if (dual_of_edge_[e] != kNoSlot) has_edge[rt_.edges[e].v[0]] = has_edge[rt_.edges[e].v[1]] = true;
  std::vector<bool> is_covered(input_.size(), false);
  for (const auto& edge : rt_.edges)
    for (std::size_t i = 0; i < 2; ++i)
      if (!has_edge[edge.v[i]] && loses_center_to<Balls>(ball_[edge.v[i]], ball_[edge.v[1 - i]]))
        is_covered[edge.v[i]] = true;
  ask_balls([&](Slot ball, Findings& found) { look_at(ball, has_edge[ball], is_covered[ball], found); });
}

template <class Balls, class Points>
void UnionPipeline<Balls, Points>::look_at(Slot ball, bool has_edge, bool is_covered, Findings& found) {
  if (rt_.state[ball] != BallState::visible) return;
  const Slot row = input_[ball].row;
  if (!has_edge) {
    // Its cell may lie outside of the ball, which is then part of another one.
    t_.balls[row] = is_covered ? BallState::hidden : BallState::isolated;
    if (!is_covered) found.arcs.push_back({ball, 1, {}, {}, kTurn});
    return;
  }
  walk_around(ball, found);
  for (const Gap& gap : found.gaps) add_arc(ball, gap, found);
  take_places(ball, found);
}

// Whether a gap between covers that end close to each other is nearly all of the circle or nearly nothing of it. In
// the first case both covers are short; then the one that ends where the gap begins does not come before the other,
// counter-clockwise. So this is exact, and for one v-point at both ends, too.
template <class Balls, class Points>
bool UnionPipeline<Balls, Points>::is_gap_all_around(Slot ball, const Gap& gap) const {
  constexpr double kShort = 0.9;  // cosine of half of the angle covered; any value well between 0 and 1 will do
  const Vec2 center = input_[ball].disk.center;
  const double r = input_[ball].radius();
  const auto is_cover_short = [&](Slot other) {
    const Vec2 way = input_[other].disk.center - center;
    const double d = length(way);
    const double other_r = input_[other].radius();
    return (d - other_r) * (d + other_r) + r * r > kShort * 2.0 * d * r;
  };
  if (!is_cover_short(gap.before) || !is_cover_short(gap.after)) return false;
  return gap.before == gap.after || sign_of_turn<Balls>(ball_[ball], ball_[gap.before], ball_[gap.after]) <= 0;
}

// A crossing of the circles of two balls, from the centre of the first. Of a ball that is small beside the distance
// from the origin of the frame, rounded positions know little.
template <class Balls, class Points>
Vec2 UnionPipeline<Balls, Points>::seen_from_center(Slot ball, Slot other, bool left, Slot v) const {
  constexpr double kSmall = 0x1p-10;
  const Vec2 center = input_[ball].disk.center;
  const double r = input_[ball].radius();
  if (r > kSmall * std::max(std::abs(center.x), std::abs(center.y))) return v_local_[v] - center;
  if constexpr (std::is_same_v<PointNumber, double>) {
    const Vec2 way = input_[other].disk.center - center;
    const double dd = dot(way, way);
    const double w = ball_in_points_[ball].w;
    const double s = dd - ball_in_points_[other].w + w;
    const double root = std::sqrt(std::max(4.0 * dd * w - s * s, 0.0));
    return (0.5 / dd) * (s * way + (left ? root : -root) * perpendicular(way));
  } else {
    const BallOf<PointNumber>& own = ball_in_points_[ball];
    return {rounded(PointNumber(v_at_[v].x() - own.x)), rounded(PointNumber(v_at_[v].y() - own.y))};
  }
}

template <class Balls, class Points>
void UnionPipeline<Balls, Points>::add_arc(Slot ball, const Gap& gap, Findings& found) const {
  if (gap.from == kNoSlot || gap.to == kNoSlot) return;
  // Between ends as close as that rounding may have changed their order.
  constexpr double kClose = 0x1p-16;
  const double r = input_[ball].radius();
  const bool is_one_point = gap.from == gap.to;
  double turn = 0.0;
  if (is_one_point) {
    turn = is_gap_all_around(ball, gap) ? kTurn : 0.0;
    if (turn == 0.0) return;
  } else {
    const Vec2 from = seen_from_center(ball, gap.before, true, gap.from);
    const Vec2 to = seen_from_center(ball, gap.after, false, gap.to);
    const double chord = distance(from, to);
    if (chord > kClose * r) {
      turn = sweep_of({{}, r, from, to});
    } else {
      const double small = 2.0 * std::asin(0.5 * chord / r);
      turn = is_gap_all_around(ball, gap) ? kTurn - small : small;
    }
  }
  found.arcs.push_back({ball, static_cast<std::uint8_t>(is_one_point ? 1 : 0), t_.v_points[gap.from].position,
                        t_.v_points[gap.to].position, turn});
}

// What the v-points on the circle of a ball say of the Voronoi edges through its centre.
template <class Balls, class Points>
void UnionPipeline<Balls, Points>::take_places(Slot ball, Findings& found) const {
  const std::vector<Place>& places = found.places;
  if (places.size() < 2) return;
  for (std::size_t k = 0; k < places.size(); ++k)
    add_event(ball, places[(k + places.size() - 1) % places.size()].v, places[k].v, places[k].before, found);
  if (crossings_.dimension == 2 && places.size() >= 3) mark_polygon(ball, found);
}

template <class Balls, class Points>
UnionTables UnionPipeline<Balls, Points>::run_v_diagram(const KnownVPoints& known) {
  for (const PipelineBall& ball : input_) ball_in_points_.push_back(ball_in<PointNumber>(ball));
  for (std::size_t i = 0; i < known.points.size(); ++i) {
    const Vec2 p = frame_.to_local(known.points[i]);
    raw_point_.emplace_back(PointNumber(p.x), PointNumber(p.y));
    row_of_point_.push_back(static_cast<Slot>(i));
    t_.v_points.push_back({known.points[i], known.sites[i], 1});
    v_local_.push_back(p);
    if constexpr (!kIsDouble) v_at_.push_back(raw_point_.back());
  }
  crossings_ = point_triangulation<Points>(raw_point_, job_);
  for (Slot i = 0; i < raw_point_.size(); ++i) MES_ASSERT(crossings_.same_as[i] == i);
  triangulate_v_points();
  ask_balls([&](Slot ball, Findings& found) {
    found.places = known.places[ball];
    take_places(ball, found);
  });
  cut_edges();
  spread_labels();
  place_faces();
  return std::move(t_);
}

template <class Balls, class Points>
auto UnionPipeline<Balls, Points>::circle_of(Slot face) const -> PlacedCircle {
  const auto& v = t_.v_faces[face].v;
  if constexpr (std::is_same_v<PointNumber, double>) {
    Vec2 corner[3];
    for (std::size_t i = 0; i < 3; ++i) corner[i] = v_local_[v[i]];
    std::ranges::rotate(corner, std::ranges::min_element(corner, lexicographically_less));
    const Circle circle = circumcircle(corner[0], corner[1], corner[2]);
    return {circle, frame_.to_document(circle.center)};
  } else {
    const auto center = CGAL::circumcenter(v_at_[v[0]], v_at_[v[1]], v_at_[v[2]]);
    const PlacedPoint at = placed(center.x(), center.y(), frame_);
    return {{at.local, distance(at.local, v_local_[v[0]])}, at.document};
  }
}

// Stable; O(events + edges). Gives where the events of each edge begin.
template <class Balls, class Points>
std::vector<Slot> UnionPipeline<Balls, Points>::sort_by_edge(std::vector<Event>& events) const {
  std::vector<Slot> begin(t_.v_edges.size() + 1, 0);
  for (const Event& event : events) ++begin[event.edge];
  Slot end = 0;
  for (Slot& place : begin) place = end += place;
  std::vector<Event> sorted(events.size());
  for (std::size_t i = events.size(); i-- > 0;) sorted[--begin[events[i].edge]] = events[i];
  events.swap(sorted);
  return begin;
}

template <class Balls, class Points>
void UnionPipeline<Balls, Points>::list_balls(std::span<const Event> events, std::vector<Slot>& balls) {
  balls.clear();
  for (const Event& event : events)
    if (std::ranges::find(balls, event.ball) == balls.end()) balls.push_back(event.ball);
}

// Cuts a Voronoi edge of the v-points at the centres on it; labels say what lies between.
template <class Balls, class Points>
void UnionPipeline<Balls, Points>::cut_edge(Slot e, std::span<const Event> events, Cutter& cutter) {
  VEdge& edge = t_.v_edges[e];
  for (const Event& event : events) {
    if (event.arc == Arc::singular) {
      edge.kind = VEdgeKind::alpha;
    } else if (edge.kind == VEdgeKind::plain) {
      edge.kind = VEdgeKind::crossing;
    }
  }
  std::vector<Slot>& on_edge = cutter.on_edge;
  list_balls(events, on_edge);
  if (on_edge.size() > 1) {
    const auto center_of = [&](Slot ball) { return Point(ball_in_points_[ball].x, ball_in_points_[ball].y); };
    const Point p = point_of(edge.v[0]);
    const Point q = point_of(edge.v[1]);
    std::ranges::sort(on_edge, [&](Slot a, Slot b) {
      const auto order = typename Points::Compare_signed_distance_to_line_2()(p, q, center_of(a), center_of(b));
      return order == CGAL::LARGER || (order == CGAL::EQUAL && comes_before(a, b));
    });
  }
  const auto label_towards = [&](Slot ball, std::uint8_t side) {
    Label label = Label::unknown;
    for (const Event& event : events) {
      if (event.ball != ball || event.side != side) continue;
      label = std::max(
          label, event.arc == Arc::covered ? Label::in : (event.arc == Arc::free ? Label::out : Label::singular));
    }
    return label;
  };
  for (std::size_t k = 0; k <= on_edge.size(); ++k) {
    const Slot a = k == 0 ? kNoSlot : on_edge[k - 1];
    const Slot b = k == on_edge.size() ? kNoSlot : on_edge[k];
    const Label from_a = a == kNoSlot ? Label::unknown : label_towards(a, 1);
    const Label from_b = b == kNoSlot ? Label::unknown : label_towards(b, 0);
    if (from_a != Label::unknown && from_b != Label::unknown && from_a != from_b) ++cutter.contradictions;
    cuts_[cuts_begin_[e] + k] = {e, {a, b}, std::max(from_a, from_b)};
  }
}

template <class Balls, class Points>
void UnionPipeline<Balls, Points>::cut_edges() {
  const std::size_t edges = t_.v_edges.size();
  const std::vector<Slot> events_begin = sort_by_edge(events_);
  const auto events_of = [&](std::size_t e) {
    return std::span<const Event>(events_).subspan(events_begin[e], events_begin[e + 1] - events_begin[e]);
  };
  std::vector<Cutter> parts(part_count(edges));
  cuts_begin_.assign(edges + 1, 0);
  in_parts(edges, [&](std::size_t begin, std::size_t end, std::size_t part) {
    for (std::size_t e = begin; e < end; ++e) {
      list_balls(events_of(e), parts[part].on_edge);
      cuts_begin_[e + 1] = static_cast<Slot>(parts[part].on_edge.size() + 1);
    }
  });
  for (std::size_t e = 0; e < edges; ++e) cuts_begin_[e + 1] += cuts_begin_[e];
  cuts_.resize(cuts_begin_[edges]);
  in_parts(edges, [&](std::size_t begin, std::size_t end, std::size_t part) {
    for (std::size_t e = begin; e < end; ++e) cut_edge(static_cast<Slot>(e), events_of(e), parts[part]);
  });
  for (const Cutter& part : parts) t_.counts.contradictions += part.contradictions;
}

// What lies in |R| at one end does so up to the next centre, through all faces on the way.
template <class Balls, class Points>
void UnionPipeline<Balls, Points>::spread_labels() {
  std::vector<Slot> stack;
  const auto settle = [&](const Cut& cut) {
    for (std::size_t i = 0; i < 2; ++i) {
      const Slot face = face_at(cut, i);
      if (!is_plain(face) || t_.v_faces[face].is_inside != 0) continue;
      t_.v_faces[face].is_inside = 1;
      stack.push_back(face);
    }
  };
  for (const Cut& seed : cuts_) {
    if (seed.label != Label::in) continue;
    settle(seed);
    while (!stack.empty()) {
      const Slot face = stack.back();
      stack.pop_back();
      for (const Slot e : v_face_edge_[face]) {
        Cut& cut = cuts_[t_.v_edges[e].f[0] == face ? cuts_begin_[e] : cuts_begin_[e + 1] - 1];
        if (cut.label == Label::out) ++t_.counts.contradictions;
        if (cut.label == Label::unknown) cut.label = Label::in;
        settle(cut);
      }
    }
  }
}

// Circumcentres where something is drawn.
template <class Balls, class Points>
void UnionPipeline<Balls, Points>::place_faces() {
  face_center_.resize(t_.v_faces.size());
  in_parts(t_.v_faces.size(), [&](std::size_t begin, std::size_t end, std::size_t) {
    for (std::size_t slot = begin; slot < end; ++slot) {
      VFace& face = t_.v_faces[slot];
      if (face.ball != kNoSlot) {
        const PipelineBall& ball = input_[face.ball];
        face_center_[slot] = ball.disk.center;
        face.center = ball.drawn.center;
        face.radius = ball.drawn.radius;
        face.ball = ball.row;
      } else {
        const PlacedCircle circle = circle_of(static_cast<Slot>(slot));
        face_center_[slot] = circle.local.center;
        face.center = circle.center;
        face.radius = frame_.to_document_length(circle.local.radius);
      }
    }
  });
}

template <class Balls, class Points>
Slot UnionPipeline<Balls, Points>::node_at(const Cut& cut, std::size_t i) const {
  if (cut.end[i] != kNoSlot) return input_[cut.end[i]].row;
  const Slot face = t_.v_edges[cut.edge].f[i];
  if (face == kNoSlot) return kNoSlot;
  const Slot ball = t_.v_faces[face].ball;
  return ball != kNoSlot ? ball : static_cast<Slot>(t_.balls.size()) + face;
}

template <class Balls, class Points>
auto UnionPipeline<Balls, Points>::local_piece_of(const Cut& cut) const -> LocalPiece {
  const auto center_at = [&](std::size_t i) {
    return cut.end[i] != kNoSlot ? input_[cut.end[i]].disk.center : face_center_[t_.v_edges[cut.edge].f[i]];
  };
  return {center_at(0), center_at(1)};
}

template <class Balls, class Points>
AxisPiece UnionPipeline<Balls, Points>::piece_of(const Cut& cut) const {
  const VEdge& edge = t_.v_edges[cut.edge];
  const auto disk_at = [&](std::size_t i) {
    if (cut.end[i] != kNoSlot) return input_[cut.end[i]].drawn;
    const VFace& face = t_.v_faces[edge.f[i]];
    return Disk{face.center, face.radius};
  };
  const Disk a = disk_at(0);
  const Disk b = disk_at(1);
  AxisPiece piece{a.center, b.center, a.radius, b.radius, {node_at(cut, 0), node_at(cut, 1)}, {edge.v[0], edge.v[1]}};
  if (is_plain(face_at(cut, 0)) && is_plain(face_at(cut, 1)))
    piece.is_zero = local_piece_of(cut).a == local_piece_of(cut).b ? 1 : 0;
  return piece;
}

// Cuts between two triangles of one circle have no length.
template <class Balls, class Points>
bool UnionPipeline<Balls, Points>::is_axis(const Cut& cut) const {
  if (cut.label != Label::in) return false;
  const Slot a = node_at(cut, 0);
  const Slot b = node_at(cut, 1);
  return a != kNoSlot && b != kNoSlot && a != b;
}

// The cuts that lie in |R|, and the singular dual edges.
template <class Balls, class Points>
void UnionPipeline<Balls, Points>::make_axis() {
  std::vector<std::size_t> place(part_count(cuts_.size()) + 1, 0);
  std::vector<std::int64_t> unbounded(place.size(), 0);
  in_parts(cuts_.size(), [&](std::size_t begin, std::size_t end, std::size_t part) {
    std::size_t kept = 0;
    for (std::size_t c = begin; c < end; ++c) {
      if (is_axis(cuts_[c])) ++kept;
      if (cuts_[c].label == Label::in && (node_at(cuts_[c], 0) == kNoSlot || node_at(cuts_[c], 1) == kNoSlot))
        ++unbounded[part];
    }
    place[part + 1] = kept;
  });
  for (std::size_t part = 1; part < place.size(); ++part) place[part] += place[part - 1];
  for (const std::int64_t count : unbounded) t_.counts.contradictions += count;
  const auto singular = std::ranges::count(t_.dual_edges, DualClass::singular, &DualEdge::kind);
  t_.axis.reserve(place.back() + static_cast<std::size_t>(singular));
  t_.axis.resize(place.back());
  in_parts(cuts_.size(), [&](std::size_t begin, std::size_t end, std::size_t part) {
    std::size_t at = place[part];
    for (std::size_t c = begin; c < end; ++c)
      if (is_axis(cuts_[c])) t_.axis[at++] = piece_of(cuts_[c]);
  });
  for (Slot e = 0; e < rt_.edges.size(); ++e) {
    const Slot row = dual_of_edge_[e];
    if (row == kNoSlot || t_.dual_edges[row].kind != DualClass::singular) continue;
    const PipelineBall& a = input_[rt_.edges[e].v[0]];
    const PipelineBall& b = input_[rt_.edges[e].v[1]];
    t_.axis.push_back({a.drawn.center,
                       b.drawn.center,
                       a.drawn.radius,
                       b.drawn.radius,
                       {a.row, b.row},
                       {crossing_[row][0], crossing_[row][1]},
                       1});
  }
}

// The union consists of the dual triangles, of the triangle between each dual edge and each v-point that it made, and
// of the sectors of the free arcs; which follows from Green's formula by cutting off the sectors and then these
// triangles. All of them are small and where they are: sums about one origin would lose what is small beside the
// distance from it.
template <class Balls, class Points>
void UnionPipeline<Balls, Points>::measure() {
  const auto center_of = [this](Slot ball) { return input_[ball].disk.center; };
  Totals totals;
  // Calls `look(row, totals)` for the rows below `count`, side by side, and adds up in their order.
  const auto add_all = [&](std::size_t count, const auto& look) {
    std::vector<Totals> parts(part_count(count));
    in_parts(count, [&](std::size_t begin, std::size_t end, std::size_t part) {
      for (std::size_t row = begin; row < end; ++row) look(static_cast<Slot>(row), parts[part]);
    });
    for (const Totals& part : parts) totals.add(part);
  };
  add_all(t_.arcs.size(), [&](Slot row, Totals& out) {
    BoundaryArc& arc = t_.arcs[row];
    const double r = input_[arc.ball].radius();
    out.perimeter.add(r * arc.turn);
    out.area.add(0.5 * r * r * arc.turn);
    arc.ball = input_[arc.ball].row;
  });
  add_all(rt_.edges.size(), [&](Slot e, Totals& out) {
    const Slot row = dual_of_edge_[e];
    if (row == kNoSlot || t_.dual_edges[row].kind == DualClass::interior) return;
    const auto& [a, b] = rt_.edges[e].v;
    const Vec2 way = center_of(b) - center_of(a);
    for (const bool left : {true, false}) {
      const Slot v = crossing_[row][left ? 0 : 1];
      if (v == kNoSlot) continue;
      const double twice = mes::cross(way, seen_from_center(a, b, left, v));
      out.area.add(left ? 0.5 * twice : -0.5 * twice);
    }
    if (t_.dual_edges[row].kind == DualClass::singular) out.axis_length.add(length(way));
  });
  add_all(rt_.faces.size(), [&](Slot f, Totals& out) {
    if (face_sign_[f] > 0) return;
    const auto& v = rt_.faces[f].v;
    out.area.add(0.5 * mes::cross(center_of(v[1]) - center_of(v[0]), center_of(v[2]) - center_of(v[0])));
  });
  add_all(cuts_.size(), [&](Slot cut, Totals& out) {
    if (is_axis(cuts_[cut])) out.axis_length.add(local_piece_of(cuts_[cut]).length());
  });
  t_.measures.area = frame_.to_document_length(frame_.to_document_length(totals.area.value()));
  t_.measures.perimeter = frame_.to_document_length(totals.perimeter.value());
  t_.measures.axis_length = frame_.to_document_length(totals.axis_length.value());
  t_.measures.left_out = totals.area.left_out() + totals.perimeter.left_out() + totals.axis_length.left_out();
}

}  // namespace mes
