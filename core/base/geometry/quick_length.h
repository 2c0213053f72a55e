// SPDX-License-Identifier: GPL-3.0-or-later
// Fast lengths of vectors, for long sums.
#pragma once

#include <algorithm>
#include <cmath>

#include "core/base/geometry/vec2.h"

namespace mes {

/// The length with a relative error of 2^-52: faster than `length`, but not always the same double. Use it for sums of
/// many lengths, not for drawing or decisions. Does not overflow for representable results. Scaling `a` by a power of
/// two scales the result by it. The bound: the square carries two roundings, of which the root keeps half, and the root
/// itself is rounded once.
inline double quick_length(Vec2 a) {
  const double squared = dot(a, a);
  // Below the range of doubles less than half a unit of the larger term is lost.
  if (squared > 0x1p-900 && squared < 0x1p1000) return std::sqrt(squared);
  const double size = std::max(std::abs(a.x), std::abs(a.y));
  if (size == 0.0 || !std::isfinite(size)) return length(a);
  const int exponent = std::ilogb(size);
  const Vec2 scaled{std::ldexp(a.x, -exponent), std::ldexp(a.y, -exponent)};
  return std::ldexp(std::sqrt(dot(scaled, scaled)), exponent);
}

}  // namespace mes
