// SPDX-License-Identifier: GPL-3.0-or-later
// Object angles along a Voronoi edge.
//
// Seen from a point of the Voronoi edge of samples q and r, at height t over the middle of qr, half the angle between
// the two is atan2(|qr| / 2, |t|). It is 90 degrees where the Voronoi edge crosses qr. At an end of the Voronoi edge it
// is the angle of the triangle opposite qr, or its supplement where that is obtuse, by the inscribed angle theorem. So
// nothing is computed from centres.
#pragma once

#include "core/base/vec2.h"
#include "core/kernel/corner_angle.h"
#include "core/kernel/edge_predicates.h"

namespace mes {

/// An angle of a corner (core/kernel/corner_angle.h) or its supplement, whichever is smaller.
constexpr double folded(double degrees) {
  return degrees > 90.0 ? 180.0 - degrees : degrees;
}

/// A limit of folded angles, as one decides by. `is_reached_at(p, q, r)` is `folded(angle_at(p, q, r)) >= degrees`,
/// mostly without the arc tangent.
class AngleLimit {
 public:
  explicit AngleLimit(double degrees);
  bool is_reached_at(Vec2 p, Vec2 q, Vec2 r) const;

 private:
  double degrees_;
  double cosine_;
  double sine_;
};

/// Of the Voronoi edge between two triangles.
struct EdgeAngles {
  double at_p = 0.0;  ///< of the triangle with the apex p, in [0, 180]
  double at_s = 0.0;

  /// Half angles in degrees, in [0, 90].
  double end(bool is_p) const { return folded(is_p ? at_p : at_s); }
  double largest() const {
    if (at_p <= 90.0 && at_s <= 90.0) return 90.0;
    return end(true) > end(false) ? end(true) : end(false);
  }
  double mean() const { return 0.5 * (end(true) + end(false)); }
};
/// `corners.s` is there.
EdgeAngles edge_angles(const EdgeCorners& corners);

/// The place on the bisector of q and r, on the side of their left, where the half angle is that many degrees; more
/// than 0.
Vec2 place_of_angle(Vec2 q, Vec2 r, double degrees);

}  // namespace mes
