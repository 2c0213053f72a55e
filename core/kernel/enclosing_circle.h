// SPDX-License-Identifier: GPL-3.0-or-later
// Smallest circles around two and three points: their radii in doubles, and exact comparisons with a limit.
//
// The smallest circle around a segment has it as a diameter. Around a triangle it is that of the longest side where the
// angle opposite is 90 degrees or more, else the circumcircle, for which
//     R = |ab| |bc| |ca| / 2 |det(b - a, c - a)|
// So the order of the radius and r is the sign of a polynomial in the coordinates and r: of degree 2, or of degree 6.
// It is evaluated in doubles with a bound of the error, and in rationals where that does not decide.
#pragma once

#include <cmath>

#include "core/base/geometry/vec2.h"

namespace mes {

/// Exact sign of (q - p).(r - p): 1 if the angle at p is below 90 degrees, 0 at 90, -1 above. The points differ.
int sign_of_corner(Vec2 p, Vec2 q, Vec2 r);

/// True if some corner of the triangle has 90 degrees or more; exact. The points must differ.
bool is_right_or_obtuse(Vec2 a, Vec2 b, Vec2 c);

/// Half the longest side of a triangle.
double half_longest_side(Vec2 a, Vec2 b, Vec2 c);

/// True if two positive doubles are certainly in the order of the numbers that they approximate, each to within 2^-47
/// of itself. False near the ends of the range of doubles, where errors may be larger.
inline bool is_order_decided(double left, double right) {
  const double size = left > right ? left : right;
  return size > 1e-250 && size < 1e300 && std::abs(left - right) > 0x1p-46 * size;
}

/// Compares half the distance from a to b with `r`, exactly: -1, 0 or 1. `r` is finite.
int compare_half_distance_exactly(Vec2 a, Vec2 b, double r);
inline int compare_half_distance(Vec2 a, Vec2 b, double r) {
  const double left = dot(b - a, b - a);
  const double right = 4.0 * r * r;
  if (r >= 0.0 && is_order_decided(left, right)) return left < right ? -1 : 1;
  return compare_half_distance_exactly(a, b, r);
}

/// Compares the radius of the smallest circle around three points, not collinear, with `r`, exactly: -1, 0 or 1.
int compare_enclosing_radius(Vec2 a, Vec2 b, Vec2 c, double r);

}  // namespace mes
