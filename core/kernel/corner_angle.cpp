// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/kernel/corner_angle.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/base/geometry/angle.h"
#include "core/base/power_of_two.h"

namespace mes {
namespace {

// The direction, scaled to about unit size where products might leave the range of doubles.
Vec2 direction(Vec2 from, Vec2 to) {
  const Vec2 d = to - from;
  const double size = std::max(std::abs(d.x), std::abs(d.y));
  if ((size > 0x1p-400 && size < 0x1p400) || size == 0.0) return d;
  const int exponent = std::ilogb(size);
  return {times_power_of_two(d.x, -exponent), times_power_of_two(d.y, -exponent)};
}

}  // namespace

double angle_at(Vec2 p, Vec2 q, Vec2 r) {
  const Vec2 u = direction(p, q);
  const Vec2 v = direction(p, r);
  return angle_of({dot(u, v), std::abs(cross(u, v))}) * (180.0 / std::numbers::pi);
}

double cotangent_at(Vec2 p, Vec2 q, Vec2 r) {
  const Vec2 u = direction(p, q);
  const Vec2 v = direction(p, r);
  return dot(u, v) / std::abs(cross(u, v));
}

}  // namespace mes
