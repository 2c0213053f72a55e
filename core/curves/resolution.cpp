// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/curves/resolution.h"

#include <cmath>

namespace mes {

double resolution_of(std::span<const Vec2> points) {
  constexpr int kMostDecimals = 9;
  constexpr double kLargest = 0x1p40;  // beyond this, doubles have too few bits left to decide
  constexpr double kRounding = 0x1p-50;
  double scale = 1.0;
  int decimals = 0;
  const auto is_multiple = [&](double x) {
    const double scaled = scale * x;
    return std::abs(scaled) < kLargest && std::abs(scaled - std::nearbyint(scaled)) <= kRounding * std::abs(scaled);
  };
  for (const Vec2 p : points)
    while (!is_multiple(p.x) || !is_multiple(p.y)) {
      if (++decimals > kMostDecimals) return 0.0;
      scale *= 10.0;
    }
  return 1.0 / scale;
}

}  // namespace mes
