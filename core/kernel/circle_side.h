// SPDX-License-Identifier: GPL-3.0-or-later
// Decides on which side of the circle through three points a fourth one lies.
//
// Taking the fourth point d as origin, this is the sign of |a|^2 det(b, c) + |b|^2 det(c, a) + |c|^2 det(a, b). Take
// two neighbours, h apart, on each side of a smooth shape of unit width: the value is of order h^3, the terms are of
// order h. For h = 10^-7 and less, this is below the rounding of doubles and of intervals, but far above that of two
// doubles. Source of the form: Guibas and Stolfi, "Primitives for the manipulation of general subdivisions", 1985.
#pragma once

#include <CGAL/Mpzf.h>
#include <CGAL/number_utils.h>

#include <cmath>

#include "core/base/geometry/vec2.h"
#include "core/kernel/numbers/two_doubles.h"

namespace mes {

namespace circle_polynomials {

/// Differences of `Number`, and everything computed from them, may have another type.
template <class Number>
auto in_circle(Vec2 a, Vec2 b, Vec2 c, Vec2 d) {
  const Number dx(d.x), dy(d.y);
  const auto ax = Number(a.x) - dx, ay = Number(a.y) - dy;
  const auto bx = Number(b.x) - dx, by = Number(b.y) - dy;
  const auto cx = Number(c.x) - dx, cy = Number(c.y) - dy;
  return (ax * ax + ay * ay) * (bx * cy - by * cx) + (bx * bx + by * by) * (cx * ay - cy * ax) +
         (cx * cx + cy * cy) * (ax * by - ay * bx);
}

/// Sign of `in_circle` in doubles; 0 means not known.
inline int quick_in_circle(Vec2 a, Vec2 b, Vec2 c, Vec2 d) {
  const double ax = a.x - d.x, ay = a.y - d.y, bx = b.x - d.x, by = b.y - d.y, cx = c.x - d.x, cy = c.y - d.y;
  const double aa = ax * ax + ay * ay, bb = bx * bx + by * by, cc = cx * cx + cy * cy;
  const double bxcy = bx * cy, bycx = by * cx, cxay = cx * ay, cyax = cy * ax, axby = ax * by, aybx = ay * bx;
  const double value = aa * (bxcy - bycx) + bb * (cxay - cyax) + cc * (axby - aybx);
  const double size = aa * (std::abs(bxcy) + std::abs(bycx)) + bb * (std::abs(cxay) + std::abs(cyax)) +
                      cc * (std::abs(axby) + std::abs(aybx));
  // No value overflows, and products lose less than 1e-200 to underflow.
  if (!(aa < 1e70 && bb < 1e70 && cc < 1e70 && size > 1e-160)) return 0;
  // Let u = 2^-53. Differences are off by u of themselves, squared lengths by 4 u, determinants by 4 u of their terms
  // and the three products by 9 u; adding them up rounds by 2 u. 16 leaves room for the rounding of the bound.
  const double bound = 16.0 * 0x1p-53 * size;
  return value > bound ? 1 : (-value > bound ? -1 : 0);
}

}  // namespace circle_polynomials

/// Returns 1 if d lies inside the circle through a, b, c, which turn left; -1 outside, 0 on it. Right turns flip the
/// sign. Exact for the given doubles: tries doubles, then numbers of two doubles, then numbers of any length. Threads
/// may share it.
inline int sign_of_in_circle(Vec2 a, Vec2 b, Vec2 c, Vec2 d) {
  using circle_polynomials::in_circle;
  if (const int known = circle_polynomials::quick_in_circle(a, b, c, d); known != 0) return known;
  const TwoDoubles longer = in_circle<GivenDouble>(a, b, c, d);
  if (const int known = longer.sign(); known != 0) return known;
  return static_cast<int>(CGAL::sign(in_circle<CGAL::Mpzf>(a, b, c, d)));
}

}  // namespace mes
