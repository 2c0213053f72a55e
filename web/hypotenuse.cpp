// SPDX-License-Identifier: GPL-3.0-or-later
// The C library of emscripten rounds the last bit of `hypot` otherwise than glibc for a seventh of all arguments, and
// most lengths that layers draw are computed by it. This one takes the place of its own and agrees with glibc 2.35 and
// later, which have the same formula: C. F. Borges, "An improved algorithm for hypot(a,b)", 2019.
#include <cmath>

namespace {

// 0 <= y <= x, neither so large nor so small that a square leaves the range of doubles.
double corrected_hypotenuse(double x, double y) {
  const double h = std::sqrt(x * x + y * y);
  // The two terms add up to h^2 - x^2 - y^2. They come from differences that are exact.
  double first = 0.0;
  double second = 0.0;
  if (h <= 2.0 * y) {
    const double over = h - y;
    first = x * (2.0 * over - x);
    second = (over - 2.0 * (x - y)) * over;
  } else {
    const double over = h - x;
    first = 2.0 * over * (x - 2.0 * y);
    second = (4.0 * over - y) * y + over * over;
  }
  return h - (first + second) / (2.0 * h);
}

}  // namespace

extern "C" double hypot(double x, double y) {
  if (std::isinf(x) || std::isinf(y)) return HUGE_VAL;
  const bool is_steep = std::abs(x) < std::abs(y);
  const double large = std::abs(is_steep ? y : x);
  const double small = std::abs(is_steep ? x : y);
  if (small <= large * 0x1p-54) return large + small;
  if (large > 0x1p511) return corrected_hypotenuse(large * 0x1p-600, small * 0x1p-600) * 0x1p600;
  if (small < 0x1p-459) return corrected_hypotenuse(large * 0x1p600, small * 0x1p600) * 0x1p-600;
  return corrected_hypotenuse(large, small);
}
