// SPDX-License-Identifier: GPL-3.0-or-later
// Circumcircle of a triangle in doubles, for drawing and measuring; decisions use predicates instead.
#pragma once

#include <algorithm>
#include <cmath>

#include "core/base/vec2.h"

namespace mes {

struct Circle {
  Vec2 center;
  double radius = 0.0;
};

/// Circle through three points. Differences to `a` are taken first, so a far offset costs no accuracy, and are scaled
/// by a power of two when products would leave the range of doubles. Collinear points give a centre that is not
/// finite.
inline Circle circumcircle(Vec2 a, Vec2 b, Vec2 c) {
  Vec2 u = b - a;
  Vec2 v = c - a;
  const double size = std::max({std::abs(u.x), std::abs(u.y), std::abs(v.x), std::abs(v.y)});
  double unit = 1.0;
  if (!(size > 1e-60 && size < 1e60)) {
    if (!std::isfinite(size)) {
      // The differences themselves overflow: work at a quarter of the size.
      const Circle quarter = circumcircle(0.25 * a, 0.25 * b, 0.25 * c);
      return {4.0 * quarter.center, 4.0 * quarter.radius};
    }
    const int exponent = std::ilogb(size);
    unit = std::ldexp(1.0, exponent);
    u = {std::ldexp(u.x, -exponent), std::ldexp(u.y, -exponent)};
    v = {std::ldexp(v.x, -exponent), std::ldexp(v.y, -exponent)};
  }
  const double uu = dot(u, u);
  const double vv = dot(v, v);
  const double scale = 0.5 / cross(u, v);
  const Vec2 d{(v.y * uu - u.y * vv) * scale, (u.x * vv - v.x * uu) * scale};
  return {a + unit * d, unit * std::sqrt(dot(d, d))};
}

}  // namespace mes
