// SPDX-License-Identifier: GPL-3.0-or-later
// Decides exactly whether one length exceeds a multiple of another.
#pragma once

#include <algorithm>
#include <cmath>

#include "core/base/geometry/vec2.h"
#include "core/kernel/edge_predicates.h"

namespace mes {

/// Compares |ab| with `times` |cd| by their rounded squares: 1 if |ab| is larger, -1 if it is smaller, 0 if rounding
/// decides. `times` is a power of two.
inline int compare_rounded(double square_of_ab, double times, double square_of_cd) {
  const double limit = times * times * square_of_cd;
  const double size = std::max(square_of_ab, limit);
  // Either side is within 4 units of its true value unless it under- or overflows.
  if (!(size > 1e-270 && size < 1e300) || std::abs(square_of_ab - limit) <= 0x1p-48 * size) return 0;
  return square_of_ab > limit ? 1 : -1;
}

/// True if |ab| exceeds `times` |cd|, exactly. `times` is a power of two.
inline bool is_longer(Vec2 a, Vec2 b, double times, Vec2 c, Vec2 d) {
  const double size = std::max({std::abs(c.x), std::abs(c.y), std::abs(d.x), std::abs(d.y)});
  if (size < 1e300) return compare_lengths(a, b, times * c, times * d) > 0;
  return compare_lengths((1.0 / times) * a, (1.0 / times) * b, c, d) > 0;
}

}  // namespace mes
