// SPDX-License-Identifier: GPL-3.0-or-later
// Fifth stage of the union pipeline: dual complex and v-points -> the v-points on the circle of each ball, and from
// these the arcs of the boundary of the union and the Voronoi edges through the centre.
#pragma once

#include <cmath>
#include <cstdint>
#include <numbers>
#include <utility>
#include <vector>

#include "core/base/error.h"
#include "core/base/geometry/arc.h"
#include "core/base/jobs/job_control.h"
#include "core/structures/balls/internal/axis/union_centers.h"
#include "core/structures/balls/internal/complex/union_complex.h"
#include "core/structures/balls/internal/complex/union_triangulation.h"
#include "core/structures/balls/internal/crossings/union_crossings.h"
#include "core/structures/balls/internal/numbers/union_balls.h"

namespace mes {

/// A free part of a circle, counter-clockwise, and the balls that cover the parts before and after it.
struct CircleGap {
  VPointSlot from, to;  ///< kNoSlot = lost
  InputSlot before, after;
};

/// The v-points on the circle of one ball, counter-clockwise, and the free parts of the circle.
struct CircleTour {
  std::vector<CirclePlace> places;
  std::vector<CircleGap> gaps;
};

/// Walks around balls. The triangles around a ball are in the order of the corners of its power cell, and those corners
/// that lie on the circle are v-points.
template <class Points>
class CircleWalker {
 public:
  CircleWalker(const UnionTriangulation& triangulation, const DualComplex& complex, const VPoints<Points>& points)
      : rt_(triangulation), complex_(complex), points_(points) {}

  /// The result is valid until the next call.
  const CircleTour& walk_around(InputSlot ball) {
    tour_.places.clear();
    tour_.gaps.clear();
    list_spokes(ball);
    if (star_.empty()) return tour_;
    std::size_t first = 0;
    while (first < star_.size() && complex_.has(spoke_before(first).left)) ++first;
    if (first == star_.size()) first = 0;
    for (std::size_t k = 0; k < star_.size(); ++k) pass((first + k) % star_.size(), ball);
    close();
    return tour_;
  }

 private:
  struct Spoke {
    RegularEdgeSlot edge;
    TriangleSlot left;
  };
  const Spoke& spoke_before(std::size_t at) const { return star_[(at + star_.size() - 1) % star_.size()]; }

  void list_spokes(InputSlot ball) {
    star_.clear();
    const RegularTables& tables = rt_.tables;
    if (tables.dimension != 2) {
      for (const RegularEdgeSlot e : rt_.line_edges[ball]) star_.push_back({e, TriangleSlot()});
      return;
    }
    const TriangleSlot start = rt_.some_face[ball];
    TriangleSlot at = start;
    do {
      const auto& face = tables.faces[at];
      const std::size_t i = face.v[0] == ball ? 0 : (face.v[1] == ball ? 1 : 2);
      star_.push_back({rt_.face_edge[at][(i + 2) % 3], at});
      at = face.n[(i + 1) % 3];
      if (at == kNoSlot || star_.size() > tables.faces.size())
        throw GeometryError("the triangulation of the balls is torn");
    } while (at != start);
  }

  void push(VPointSlot v, CircleArc before) {
    if (v == kNoSlot) return;
    if (tour_.places.empty() || tour_.places.back().v != v) tour_.places.push_back({v, before});
  }

  void pass(std::size_t at, InputSlot ball) {
    const Spoke& spoke = star_[at];
    const bool right_in = complex_.has(spoke_before(at).left);
    const bool left_in = complex_.has(spoke.left);
    const DualEdgeSlot row = spoke.edge == kNoSlot ? DualEdgeSlot() : complex_.row_of_edge[spoke.edge];
    if (row != kNoSlot && !(right_in && left_in)) {
      const auto& ends = rt_.tables.edges[spoke.edge].v;
      const bool outward = ends[0] == ball;
      const InputSlot neighbour = ends[outward ? 1 : 0];
      const VPointSlot left_v = points_.of_dual_edge[row][outward ? 0 : 1];
      const VPointSlot right_v = points_.of_dual_edge[row][outward ? 1 : 0];
      std::vector<CircleGap>& gaps = tour_.gaps;
      if (!right_in) {
        push(right_v, CircleArc::free);
        // The first gap begins where the last cover ends.
        if (gaps.empty()) gaps.emplace_back();
        gaps.back().to = right_v;
        gaps.back().after = neighbour;
      }
      if (!left_in) {
        push(left_v, right_in ? CircleArc::covered : CircleArc::singular);
        gaps.push_back({left_v, VPointSlot(), neighbour, InputSlot()});
      }
    }
    if (left_in && complex_.zero_group[spoke.left] != kNoSlot)
      push(points_.of_zero_group[complex_.zero_group[spoke.left]], CircleArc::covered);
  }

  // Joins the end of the tour with its beginning.
  void close() {
    std::vector<CirclePlace>& places = tour_.places;
    std::vector<CircleGap>& gaps = tour_.gaps;
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

  const UnionTriangulation& rt_;
  const DualComplex& complex_;
  const VPoints<Points>& points_;
  std::vector<Spoke> star_;
  CircleTour tour_;
};

/// Decides whether a gap between covers that end close to each other is nearly all of the circle or nearly none of it.
/// In the first case both covers are short, and the one that ends where the gap begins does not come before the other,
/// counter-clockwise. So this is exact, even if both ends are one v-point.
template <class Balls, class Points>
bool is_gap_all_around(const UnionBalls<Balls, Points>& balls, InputSlot ball, const CircleGap& gap) {
  constexpr double kShort = 0.9;  // cosine of half of the angle covered; any value well between 0 and 1 will do
  const Vec2 center = balls.center(ball);
  const double r = balls.input[ball].radius();
  const auto is_cover_short = [&](InputSlot other) {
    const Vec2 way = balls.center(other) - center;
    const double d = length(way);
    const double other_r = balls.input[other].radius();
    return (d - other_r) * (d + other_r) + r * r > kShort * 2.0 * d * r;
  };
  if (!is_cover_short(gap.before) || !is_cover_short(gap.after)) return false;
  return gap.before == gap.after ||
         sign_of_turn<Balls>(balls.in_balls[ball], balls.in_balls[gap.before], balls.in_balls[gap.after]) <= 0;
}

inline constexpr double kFullTurn = 2.0 * std::numbers::pi;

/// Appends the arc of a gap to `arcs`, unless an end is lost or the arc has no length.
template <class Balls, class Points>
void add_arc(const UnionBalls<Balls, Points>& balls, const VPoints<Points>& points, InputSlot ball,
             const CircleGap& gap, std::vector<InputArc>& arcs) {
  if (gap.from == kNoSlot || gap.to == kNoSlot) return;
  // Ends this close may have been exchanged by rounding.
  constexpr double kClose = 0x1p-16;
  const double r = balls.input[ball].radius();
  const bool is_one_point = gap.from == gap.to;
  double turn = 0.0;
  if (is_one_point) {
    turn = is_gap_all_around(balls, ball, gap) ? kFullTurn : 0.0;
    if (turn == 0.0) return;
  } else {
    const Vec2 from = seen_from_center(balls, points, ball, gap.before, true, gap.from);
    const Vec2 to = seen_from_center(balls, points, ball, gap.after, false, gap.to);
    const double chord = distance(from, to);
    if (chord > kClose * r) {
      turn = sweep_of({{}, r, from, to});
    } else {
      const double small = 2.0 * std::asin(0.5 * chord / r);
      turn = is_gap_all_around(balls, ball, gap) ? kFullTurn - small : small;
    }
  }
  arcs.push_back({ball, static_cast<std::uint8_t>(is_one_point ? 1 : 0), points.rows[gap.from].position,
                  points.rows[gap.to].position, turn});
}

struct UnionCircles {
  CenterTables centers;
  Table<InputSlot, BallState> state;
};

/// Splits the visible balls without a dual edge: one with its cell outside of it is part of another ball, hence hidden.
template <class Balls, class Points>
Table<InputSlot, BallState> ball_states(const UnionBalls<Balls, Points>& balls, const RegularTables& tables,
                                        const DualComplex& complex) {
  Table<InputSlot, bool> has_edge(balls.size(), false);
  for (const RegularEdgeSlot e : tables.edges.rows())
    if (complex.row_of_edge[e] != kNoSlot) has_edge[tables.edges[e].v[0]] = has_edge[tables.edges[e].v[1]] = true;
  Table<InputSlot, bool> is_covered(balls.size(), false);
  for (const auto& edge : tables.edges)
    for (std::size_t i = 0; i < 2; ++i)
      if (!has_edge[edge.v[i]] && loses_center_to<Balls>(balls.in_balls[edge.v[i]], balls.in_balls[edge.v[1 - i]]))
        is_covered[edge.v[i]] = true;
  Table<InputSlot, BallState> out = tables.state;
  for (const InputSlot ball : out.rows())
    if (out[ball] == BallState::visible && !has_edge[ball])
      out[ball] = is_covered[ball] ? BallState::hidden : BallState::isolated;
  return out;
}

template <class Balls, class Points>
UnionCircles union_circles(const UnionBalls<Balls, Points>& balls, const UnionTriangulation& triangulation,
                           const DualComplex& complex, const VPoints<Points>& points, const VTriangulation& v,
                           JobControl& job) {
  UnionCircles out;
  out.state = ball_states(balls, triangulation.tables, complex);
  out.centers = find_centers(balls, v, job, [&] {
    return [&, walker = CircleWalker<Points>(triangulation, complex, points)](InputSlot ball,
                                                                              CenterFinder& found) mutable {
      if (out.state[ball] == BallState::isolated) found.arcs.push_back({ball, 1, {}, {}, kFullTurn});
      if (out.state[ball] != BallState::visible) return;
      const CircleTour& tour = walker.walk_around(ball);
      for (const CircleGap& gap : tour.gaps) add_arc(balls, points, ball, gap, found.arcs);
      found.take(ball, tour.places);
    };
  });
  return out;
}

}  // namespace mes
