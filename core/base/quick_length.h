// SPDX-License-Identifier: GPL-3.0-or-later
// Lengths of vectors for sums of many.
#pragma once

#include <algorithm>
#include <cmath>

#include "core/base/vec2.h"

namespace mes {

/// The length with a relative error of 2^-52, quicker than `length` and not always the same double: for sums of many
/// lengths, and not for what is drawn or decided. Does not overflow for representable results. A power of two before `a`
/// is one before the result. The bound: the square carries two roundings, of which the root keeps half, and the root
/// itself is rounded once.
inline double quick_length(Vec2 a) {
  const double squared = dot(a, a);
  // What is lost below the range of doubles is less than half a unit of the larger term.
  if (squared > 0x1p-900 && squared < 0x1p1000) return std::sqrt(squared);
  const double size = std::max(std::abs(a.x), std::abs(a.y));
  if (size == 0.0 || !std::isfinite(size)) return length(a);
  const int exponent = std::ilogb(size);
  const Vec2 scaled{std::ldexp(a.x, -exponent), std::ldexp(a.y, -exponent)};
  return std::ldexp(std::sqrt(dot(scaled, scaled)), exponent);
}

}  // namespace mes
