// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/kernel/circumcircle.h"

#include <CGAL/Exact_rational.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "core/base/power_of_two.h"
#include "core/kernel/numbers/two_doubles.h"

namespace mes {
namespace {

using Rational = CGAL::Exact_rational;

// The circle in doubles, if they suffice. Returns nothing for collinear points, nor where fewer than 24 bits of the
// doubled area, or of the vector from `a` to the centre, are certain.
//
// Differences to `a` are taken first, so a far offset costs no accuracy. Let s be the largest of them. Coordinates
// are multiples of 2^-153 times the largest in the document, so differences are 0 or at least 2^-154 s. For s between
// 2^-60 and 2^60 no product of three of them leaves the normal range; otherwise they are first scaled by a power of
// two. So scaling the points by a power of two scales this circle exactly.
std::optional<Circle> quick_circumcircle(Vec2 a, Vec2 b, Vec2 c) {
  Vec2 u = b - a;
  Vec2 v = c - a;
  const double size = std::max({std::abs(u.x), std::abs(u.y), std::abs(v.x), std::abs(v.y)});
  if (!(size > 0.0 && std::isfinite(size))) return std::nullopt;
  int exponent = 0;
  if (!(size > 0x1p-60 && size < 0x1p60)) {
    exponent = std::ilogb(size);
    u = {times_power_of_two(u.x, -exponent), times_power_of_two(u.y, -exponent)};
    v = {times_power_of_two(v.x, -exponent), times_power_of_two(v.y, -exponent)};
  }
  // Differences and products lose less than 2^-50 of the terms.
  constexpr double kSure = 0x1p-26;
  const double doubled_area = cross(u, v);
  if (!(std::abs(doubled_area) > kSure * (std::abs(u.x * v.y) + std::abs(u.y * v.x)))) return std::nullopt;
  const double uu = dot(u, u);
  const double vv = dot(v, v);
  const Vec2 n{v.y * uu - u.y * vv, u.x * vv - v.x * uu};
  const double terms = (std::abs(v.x) + std::abs(v.y)) * uu + (std::abs(u.x) + std::abs(u.y)) * vv;
  if (!(std::max(std::abs(n.x), std::abs(n.y)) > kSure * terms)) return std::nullopt;
  const double scale = 0.5 / doubled_area;
  const Vec2 d{n.x * scale, n.y * scale};
  const double radius = std::sqrt(dot(d, d));
  if (exponent == 0) return Circle{a + d, radius};
  return Circle{a + Vec2{times_power_of_two(d.x, exponent), times_power_of_two(d.y, exponent)},
                times_power_of_two(radius, exponent)};
}

// The same in numbers of two doubles, which tell slivers from segments where doubles cannot. Returns nothing where
// fewer than 40 bits are certain. Scaled likewise, so losses below the range of doubles never decide.
std::optional<Circle> careful_circumcircle(Vec2 a, Vec2 b, Vec2 c) {
  const Vec2 u = b - a;
  const Vec2 v = c - a;
  const double size = std::max({std::abs(u.x), std::abs(u.y), std::abs(v.x), std::abs(v.y)});
  if (!(size > 0.0 && std::isfinite(size))) return std::nullopt;
  const int exponent = size > 0x1p-60 && size < 0x1p60 ? 0 : std::ilogb(size);
  const auto between = [exponent](double from, double to) {
    return TwoDoubles::difference(times_power_of_two(to, -exponent), times_power_of_two(from, -exponent));
  };
  const TwoDoubles ux = between(a.x, b.x), uy = between(a.y, b.y), vx = between(a.x, c.x), vy = between(a.y, c.y);
  const TwoDoubles four_areas = 2.0 * (ux * vy - uy * vx);
  const TwoDoubles uu = ux * ux + uy * uy;
  const TwoDoubles vv = vx * vx + vy * vy;
  const TwoDoubles x = vy * uu - uy * vv;
  const TwoDoubles y = ux * vv - vx * uu;
  constexpr double kSure = 0x1p-40;
  const double reach = std::max(std::abs(x.value()), std::abs(y.value()));
  if (!(four_areas.error() < kSure * std::abs(four_areas.value()))) return std::nullopt;
  if (!(std::max(x.error(), y.error()) < kSure * reach)) return std::nullopt;
  const Vec2 d{x.value() / four_areas.value(), y.value() / four_areas.value()};
  return Circle{a + Vec2{times_power_of_two(d.x, exponent), times_power_of_two(d.y, exponent)},
                times_power_of_two(length(d), exponent)};
}

Circle exact_circumcircle(Vec2 a, Vec2 b, Vec2 c) {
  constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
  if (!is_finite(a) || !is_finite(b) || !is_finite(c)) return {{kNone, kNone}, kNone};
  const auto between = [](double from, double to) { return Rational(Rational(to) - Rational(from)); };
  const Rational ux = between(a.x, b.x), uy = between(a.y, b.y), vx = between(a.x, c.x), vy = between(a.y, c.y);
  const Rational four_areas = 2 * (ux * vy - uy * vx);
  if (four_areas == 0) return {{kNone, kNone}, kNone};
  const Rational uu = ux * ux + uy * uy;
  const Rational vv = vx * vx + vy * vy;
  const Vec2 d{CGAL::to_double(Rational((vy * uu - uy * vv) / four_areas)),
               CGAL::to_double(Rational((ux * vv - vx * uu) / four_areas))};
  return {a + d, length(d)};
}

}  // namespace

Circle circumcircle(Vec2 a, Vec2 b, Vec2 c) {
  if (const auto quick = quick_circumcircle(a, b, c)) return *quick;
  if (const auto careful = careful_circumcircle(a, b, c)) return *careful;
  return exact_circumcircle(a, b, c);
}

}  // namespace mes
