// SPDX-License-Identifier: GPL-3.0-or-later
// Object angles along a Voronoi edge.
//
// Seen from a point of the Voronoi edge of samples q and r, at height t over the middle of qr, half the angle between
// the two is atan2(|qr| / 2, |t|). It is 90 degrees where the Voronoi edge crosses qr. At an end of the Voronoi edge it
// is the angle of the triangle opposite qr, or its supplement where that is obtuse, by the inscribed angle theorem. So
// nothing is computed from centres.
#pragma once

#include <array>
#include <cmath>
#include <cstdint>

#include "core/base/geometry/vec2.h"
#include "core/kernel/corner_angle.h"
#include "core/kernel/edge_predicates.h"

namespace mes {

/// An angle of a corner (core/kernel/corner_angle.h) or its supplement, whichever is smaller.
constexpr double folded(double degrees) {
  return degrees > 90.0 ? 180.0 - degrees : degrees;
}

/// Facts about the corner of a triangle, as bits.
using CornerBits = std::uint8_t;
inline constexpr CornerBits kAngleReaches = 1;  ///< its folded angle reaches the limit
inline constexpr CornerBits kNotObtuse = 2;     ///< it has at most 90 degrees

/// A limit of folded angles: a corner reaches it if `folded(angle_at(p, q, r)) >= degrees`. The arc tangent is computed
/// only where rounding may decide.
class AngleLimit {
 public:
  explicit AngleLimit(double degrees);

  /// Facts about the corner at p.
  CornerBits corner(Vec2 p, Vec2 q, Vec2 r) const {
    const Vec2 u = q - p;
    const Vec2 v = r - p;
    CornerBits out{};
    return decide(dot(u, v), cross(u, v), dot(u, u) * dot(v, v), out) ? out : corner_by_angle(p, q, r);
  }
  /// Facts about all three corners, with their differences and lengths computed once.
  std::array<CornerBits, 3> corners(Vec2 a, Vec2 b, Vec2 c) const {
    const Vec2 ab = b - a;
    const Vec2 bc = c - b;
    const Vec2 ca = a - c;
    const double ab2 = dot(ab, ab);
    const double bc2 = dot(bc, bc);
    const double ca2 = dot(ca, ca);
    std::array<CornerBits, 3> out{};
    if (!decide(-dot(ab, ca), cross(ab, ca), ab2 * ca2, out[0])) out[0] = corner_by_angle(a, b, c);
    if (!decide(-dot(bc, ab), cross(bc, ab), bc2 * ab2, out[1])) out[1] = corner_by_angle(b, c, a);
    if (!decide(-dot(ca, bc), cross(ca, bc), ca2 * bc2, out[2])) out[2] = corner_by_angle(c, a, b);
    return out;
  }

 private:
  /// Decides by the scalar product of the two sides, their determinant and the product of their squared lengths.
  /// Returns false where rounding may decide, or products leave the range of doubles.
  bool decide(double product, double det, double size, CornerBits& out) const {
    // The tangent of the folded angle is |det| / |product|.
    const double more = std::abs(det) * cosine_ - std::abs(product) * sine_;
    // Products nearer to 0 than this give an angle that rounds to 90 degrees.
    constexpr double kLeast = 1e-280;
    out = static_cast<CornerBits>((more > 0.0 ? kAngleReaches : 0U) | (product >= -kLeast ? kNotObtuse : 0U));
    return size > 0x1p-900 && size < 0x1p900 && more * more > 1e-24 * size;
  }
  CornerBits corner_by_angle(Vec2 p, Vec2 q, Vec2 r) const;

  double degrees_;
  double cosine_;
  double sine_;
};

/// Angles of the Voronoi edge between two triangles.
struct EdgeAngles {
  double at_p = 0.0;  ///< angle of the triangle with the apex p, in [0, 180]
  double at_s = 0.0;

  /// Half angles in degrees, in [0, 90].
  double end(bool is_p) const { return folded(is_p ? at_p : at_s); }
  double largest() const {
    if (at_p <= 90.0 && at_s <= 90.0) return 90.0;
    return end(true) > end(false) ? end(true) : end(false);
  }
  double mean() const { return 0.5 * (end(true) + end(false)); }
};
/// `corners.s` must be set.
EdgeAngles edge_angles(const EdgeCorners& corners);

/// The point on the bisector of q and r, to the left of q -> r, where the half angle is `degrees`, which is above 0.
Vec2 place_of_angle(Vec2 q, Vec2 r, double degrees);

}  // namespace mes
