// SPDX-License-Identifier: GPL-3.0-or-later
// The elements that balls of a family and v-points follow, for shapes of explanations.
#pragma once

#include <array>
#include <utility>
#include <vector>

#include "core/graph/explain.h"
#include "core/structures/balls/ball_family.h"
#include "core/structures/balls/internal/union_tables.h"
#include "core/structures/delaunay/explain_parts.h"

namespace mes {

/// Balls of the document follow themselves, circumdisks the samples on their circle; others follow nothing, nor does
/// anything while the triangulation is not up to date. For one union. Threads: none.
class BallPlaces {
 public:
  BallPlaces(const BallFamily& family, Explanation& out)
      : family_(family), out_(out), delaunay_(out.current<Delaunay>()) {}

  Followed follows(FamilySlot ball) const {
    if (const BallSlot own = family_.ball_of_document(ball); own != kNoSlot)
      return {.balls = {own}, .scale = family_.scale()};
    if (delaunay_ == nullptr || !family_.is_from_samples() || family_.origin(ball) != BallOrigin::circumdisk)
      return {};
    std::vector<TouchedSample> touched;
    family_.touched_samples(ball, touched);
    if (touched.size() < 3) return {};
    Followed out;
    for (std::size_t i = 0; i < out.samples.size(); ++i) out.samples[i] = delaunay_->site_sample(touched[i].site);
    return out;
  }
  /// True if the balls are those of the document; either all are or none.
  bool follow_balls() const { return family_.ball_of_document(FamilySlot(0)) != kNoSlot; }
  ShapePlace center(FamilySlot ball) const { return {family_.disk(ball).center, follows(ball)}; }
  void add_circle(ProvenanceShapes& shapes, FamilySlot ball) const {
    shapes.circle(family_.disk(ball), follows(ball));
  }
  /// Follows two balls of the document; for others it follows nothing.
  Followed both(FamilySlot a, FamilySlot b) const {
    if (!follow_balls()) return {};
    return {.balls = {family_.ball_of_document(a), family_.ball_of_document(b)}, .scale = family_.scale()};
  }
  /// A crossing of the circles of two balls of the document follows them.
  ShapePlace crossing(Vec2 at, FamilySlot a, FamilySlot b) const {
    BallSlot first = family_.ball_of_document(a);
    BallSlot second = family_.ball_of_document(b);
    if (first == kNoSlot || second == kNoSlot) return at;
    const Vec2 from = family_.disk(a).center;
    // Where rounding could choose the wrong crossing, both are on the line of the centres and the same.
    if (cross(family_.disk(b).center - from, at - from) < 0.0) std::swap(first, second);
    return {at, {.balls = {first, second}, .scale = family_.scale()}};
  }
  /// A v-point that is a sample follows it; one of balls of the document follows two of those that cross there.
  /// O(v-points) the first time, then O(1).
  ShapePlace at(const UnionTables& t, VPointSlot row) const {
    const VPoint& v = t.v_points[row];
    if (v.site != kNoSlot && delaunay_ != nullptr && delaunay_->is_site(v.site))
      return {v.position, {.samples = {delaunay_->site_sample(v.site)}}};
    if (!follow_balls()) return v.position;
    const VOriginSlot first = first_origin(t, row);
    if (first == kNoSlot) return v.position;
    const DualEdge& edge = t.dual_edges[t.v_origins[first].edge];
    return crossing(v.position, edge.ball[0], edge.ball[1]);
  }
  /// A point at equal distance from two v-points follows the balls that cross there. Costs as much as `at`.
  ShapePlace between(const UnionTables& t, Vec2 place, VPointSlot first, VPointSlot second) const {
    if (!follow_balls()) return place;
    for (const VPointSlot v : {first, second})
      if (!t.v_points.has(v) || !t.v_points[v].is_alive()) return place;
    const ShapePlace a = at(t, first);
    const ShapePlace b = at(t, second);
    const Vec2 way = b.at - a.at;
    const double squared = dot(way, way);
    if (a.follows.balls[1] == kNoSlot || b.follows.balls[1] == kNoSlot || squared == 0.0) return place;
    const double along = dot(perpendicular(way), place - (0.5 * a.at + 0.5 * b.at)) / squared;
    return {place,
            {.balls = {a.follows.balls[0], a.follows.balls[1], b.follows.balls[0], b.follows.balls[1]},
             .along = along,
             .scale = family_.scale()}};
  }
  /// The power centre of three balls.
  ShapePlace power_center(Vec2 at, const std::array<FamilySlot, 3>& balls) const {
    Followed out{.scale = family_.scale()};
    for (std::size_t i = 0; i < balls.size(); ++i) {
      out.balls[i] = family_.ball_of_document(balls[i]);
      if (out.balls[i] == kNoSlot) return at;
    }
    return {at, out};
  }

 private:
  VOriginSlot first_origin(const UnionTables& t, VPointSlot row) const {
    if (first_origin_.empty()) {
      first_origin_.assign(t.v_points.size(), VOriginSlot(kNoSlot));
      for (const VOriginSlot origin : t.v_origins.rows()) {
        out_.look();
        if (!t.v_origins[origin].is_alive()) continue;
        VOriginSlot& first = first_origin_[t.v_origins[origin].v];
        if (first == kNoSlot) first = origin;
      }
    }
    return first_origin_[row];
  }

  const BallFamily& family_;
  Explanation& out_;
  const Delaunay* delaunay_;
  mutable Table<VPointSlot, VOriginSlot> first_origin_;  // for each v-point; made on demand
};

}  // namespace mes
