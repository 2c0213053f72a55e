// SPDX-License-Identifier: GPL-3.0-or-later
// Doubles as integer multiples of one power of two. Private to core/edit.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <span>

#include "core/base/geometry/coordinate_range.h"
#include "core/base/geometry/vec2.h"

namespace mes {

/// An integer point.
struct GridPoint {
  std::int64_t x = 0;
  std::int64_t y = 0;
  friend bool operator==(const GridPoint&, const GridPoint&) = default;
};

/// A grid of multiples of a power of two, as fine as doubles of a given magnitude allow. Multiples of the step by
/// integers up to `kMost` are doubles.
class CommonGrid {
 public:
  static constexpr std::int64_t kMost = std::int64_t{1} << 52U;

  /// After rounding, numbers up to twice `largest`, which must not be zero, are on the grid.
  explicit CommonGrid(double largest) : exponent_(exponent_of(largest) - 50) {}

  double step() const { return std::ldexp(1.0, exponent_); }
  /// Number of steps, rounded to the nearest integer.
  std::int64_t rounded(double x) const { return std::llround(std::ldexp(x, -exponent_)); }
  GridPoint rounded(Vec2 p) const { return {rounded(p.x), rounded(p.y)}; }
  /// Exact for integers up to `kMost`.
  double number(std::int64_t k) const { return std::ldexp(static_cast<double>(k), exponent_); }
  Vec2 place(GridPoint p) const { return {number(p.x), number(p.y)}; }
  bool holds(GridPoint p) const { return std::max(std::abs(p.x), std::abs(p.y)) <= kMost; }

 private:
  int exponent_;
};

inline double largest_magnitude(std::span<const Vec2> places) {
  double out = 0.0;
  for (const Vec2 p : places) out = std::max({out, std::abs(p.x), std::abs(p.y)});
  return out;
}

/// The mean, computed without overflow.
inline Vec2 mean_of(std::span<const Vec2> places) {
  Vec2 out;
  double count = 0.0;
  for (const Vec2 p : places) {
    count += 1.0;
    out = out + (1.0 / count) * (p - out);
  }
  return out;
}

}  // namespace mes
