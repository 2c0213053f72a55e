// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/geometry/angle.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>

namespace mes {
namespace {

/// The arc tangent, by its series; |t| is at most tan(pi / 8), so that what is left out is below 2^-56 of the result.
double small_arc_tangent(double t) {
  constexpr std::size_t kTerms = 20;
  constexpr auto kFactors = [] {
    std::array<double, kTerms> out{};
    for (std::size_t i = 0; i < kTerms; ++i) out[i] = (i % 2 == 0 ? 1.0 : -1.0) / static_cast<double>(2 * i + 1);
    return out;
  }();
  // Two sums, which the processor computes side by side.
  const double square = t * t;
  const double fourth = square * square;
  double even = 0.0;
  double odd = 0.0;
  for (std::size_t i = kTerms; i > 0; i -= 2) {
    odd = odd * fourth + kFactors[i - 1];
    even = even * fourth + kFactors[i - 2];
  }
  return t + t * ((even - 1.0) + square * odd);
}

}  // namespace

double angle_of(Vec2 v) {
  const double x = std::abs(v.x);
  const double y = std::abs(v.y);
  double out = 0.0;
  if (const double most = std::max(x, y); most > 0.0) {
    constexpr double kTangentOfSixteenth = std::numbers::sqrt2 - 1.0;
    const double t = std::min(x, y) / most;
    out = t > kTangentOfSixteenth ? 0.25 * std::numbers::pi + small_arc_tangent((t - 1.0) / (t + 1.0))
                                  : small_arc_tangent(t);
    if (y > x) out = 0.5 * std::numbers::pi - out;
  }
  if (std::signbit(v.x)) out = std::numbers::pi - out;
  return std::copysign(out, v.y);
}

}  // namespace mes
