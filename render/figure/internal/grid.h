// SPDX-License-Identifier: GPL-3.0-or-later
// The grid of figure coordinates, multiples of a power of ten, and their text.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <string>

#include "core/base/geometry/vec2.h"

namespace mes::figure {

constexpr double power_of_ten(int exponent) {
  double out = 1.0;
  for (int i = 0; i < exponent; ++i) out *= 10.0;
  return out;
}

/// Decimals of coordinates on a page: its longer side has at least 20,000 steps, five for each pixel of a large screen,
/// and a step is at most a hundredth of a point, 1/7200 inch.
inline int decimals_for(double width, double height) {
  constexpr double kSteps = 2e4;
  constexpr int kLeast = 2;
  constexpr int kMost = 6;
  const double side = std::max({width, height, 1e-3});
  return std::clamp(static_cast<int>(std::ceil(std::log10(kSteps / side))), kLeast, kMost);
}

class Grid {
 public:
  explicit Grid(int decimals) : decimals_(decimals), steps_(power_of_ten(decimals)) {}

  double operator()(double value) const { return std::round(value * steps_) / steps_; }
  Vec2 operator()(Vec2 p) const { return {(*this)(p.x), (*this)(p.y)}; }
  double step() const { return 1.0 / steps_; }
  std::int64_t index(double value) const { return std::llround(value * steps_); }
  int decimals() const { return decimals_; }

 private:
  int decimals_;
  double steps_;
};

/// Decimals of colour components, and of an opacity, from 0 to 1.
inline constexpr int kColorDecimals = 4;
inline constexpr int kOpacityDecimals = 4;

/// Appends a number below 10^9 with `decimals` decimals, without trailing zeros; the same in every locale.
void append_decimal(std::string& out, double value, int decimals);

/// Writes numbers and pairs of numbers.
class NumberWriter {
 public:
  NumberWriter(std::string& out, int decimals) : out_(out), decimals_(decimals) {}
  void operator()(double value) const { append_decimal(out_, value, decimals_); }
  /// Writes a pair with a space between.
  void operator()(Vec2 p) const {
    (*this)(p.x);
    out_ += ' ';
    (*this)(p.y);
  }

 private:
  std::string& out_;
  int decimals_;
};

}  // namespace mes::figure
