// SPDX-License-Identifier: GPL-3.0-or-later
// Circumcircle of a triangle, rounded to doubles, for drawing and measuring; decisions use predicates instead.
#pragma once

#include "core/base/geometry/vec2.h"

namespace mes {

struct Circle {
  Vec2 center;
  double radius = 0.0;
};

/// Circle through three points. Within the range of coordinates (core/base/geometry/coordinate_range.h) centre and radius are
/// finite, and correct to at least 20 bits of the radius, however flat the triangle. Scaling the points by a power of
/// two scales both exactly. Collinear points, and points that are not finite, give a centre and a radius that are not
/// finite.
///
/// Cost: about 10 ns; ten times as much where doubles do not suffice, as for a height below 1e-8 of the sides, and
/// microseconds where two doubles do not suffice either.
Circle circumcircle(Vec2 a, Vec2 b, Vec2 c);

}  // namespace mes
