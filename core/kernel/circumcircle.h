// SPDX-License-Identifier: GPL-3.0-or-later
// Circumcircle of a triangle, rounded to doubles, for drawing and measuring; decisions use predicates instead.
#pragma once

#include "core/base/vec2.h"

namespace mes {

struct Circle {
  Vec2 center;
  double radius = 0.0;
};

/// Circle through three points. Within the range of coordinates (core/base/coordinate_range.h) centre and radius are
/// finite, and right to 20 bits and more of the radius, however flat the triangle; of points times a power of two
/// they are this times that, to the last bit. Collinear points, and points that are not finite, give a centre and a
/// radius that are not.
///
/// Cost: some 10 ns; ten times as much where doubles do not do, as for a height below 1e-8 of the sides, and
/// microseconds where two doubles do not do either.
Circle circumcircle(Vec2 a, Vec2 b, Vec2 c);

}  // namespace mes
