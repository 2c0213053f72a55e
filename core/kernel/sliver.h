// SPDX-License-Identifier: GPL-3.0-or-later
// Circumcircle of a triangle of doubles, however thin.
#pragma once

#include <CGAL/Exact_rational.h>

#include <cmath>

#include "core/base/circumcircle.h"
#include "core/kernel/rounding.h"

namespace mes {

/// As `circumcircle`, but in rationals where doubles cannot tell the triangle from a segment: the centre is finite
/// unless the three are collinear or it lies beyond the doubles.
inline Circle circumcircle_of_sliver(Vec2 a, Vec2 b, Vec2 c) {
  const Vec2 u = b - a;
  const Vec2 v = c - a;
  if (std::abs(cross(u, v)) > 1e-12 * (std::abs(u.x * v.y) + std::abs(u.y * v.x))) return circumcircle(a, b, c);
  using Exact = CGAL::Exact_rational;
  const Exact ux = Exact(b.x) - Exact(a.x), uy = Exact(b.y) - Exact(a.y);
  const Exact vx = Exact(c.x) - Exact(a.x), vy = Exact(c.y) - Exact(a.y);
  const Exact twice = Exact(2) * (ux * vy - uy * vx);
  if (twice == Exact(0)) return circumcircle(a, b, c);
  const Exact uu = ux * ux + uy * uy, vv = vx * vx + vy * vy;
  const Exact dx = (vy * uu - uy * vv) / twice, dy = (ux * vv - vx * uu) / twice;
  return {{nearest_double(Exact(Exact(a.x) + dx)), nearest_double(Exact(Exact(a.y) + dy))},
          std::hypot(nearest_double(dx), nearest_double(dy))};
}

}  // namespace mes
