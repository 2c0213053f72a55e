// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/raster/internal/smoothing.h"

#include <algorithm>
#include <cmath>
#include <complex>
#include <cstddef>

namespace mes {
namespace {

constexpr std::size_t kLeastPoints = 8;

/// Pixel coordinates are neither huge nor tiny, so nothing overflows.
double length_between(Vec2 a, Vec2 b) {
  return std::sqrt(dot(b - a, b - a));
}

std::vector<Vec2> at_equal_distances(std::span<const Vec2> contour) {
  const auto side = [&](std::size_t i) {
    return length_between(contour[i], contour[i + 1 < contour.size() ? i + 1 : 0]);
  };
  double all = 0.0;
  for (std::size_t i = 0; i < contour.size(); ++i) all += side(i);
  const std::size_t count = std::max(kLeastPoints, static_cast<std::size_t>(std::lround(all)));
  std::vector<Vec2> out;
  out.reserve(count);
  std::size_t i = 0;
  double passed = 0.0;
  double here = side(0);
  for (std::size_t k = 0; k < count; ++k) {
    const double wanted = all * (static_cast<double>(k) / static_cast<double>(count));
    while (i + 1 < contour.size() && passed + here < wanted) {
      passed += here;
      ++i;
      here = side(i);
    }
    const double share = here > 0.0 ? std::clamp((wanted - passed) / here, 0.0, 1.0) : 0.0;
    out.push_back(contour[i] + share * (contour[i + 1 < contour.size() ? i + 1 : 0] - contour[i]));
  }
  return out;
}

/// The points that minimise the sum of squares of distances to the given ones, plus the fourth power of `scale` times
/// that of second differences: the smoothing spline of a closed curve. The inverse of its matrix is a recursive filter
/// of second order, run once forwards and once backwards.
class Spline {
 public:
  explicit Spline(double scale) {
    // Roots of scale^4 (2 - z - 1/z)^2 + 1 within the unit circle.
    const std::complex<double> half = std::complex<double>(1.0, -0.5 / (scale * scale));
    const std::complex<double> root = std::sqrt(half * half - 1.0);
    std::complex<double> pole = half - root;
    if (std::abs(pole) > 1.0) pole = half + root;
    first_ = 2.0 * pole.real();
    second_ = -std::norm(pole);
    gain_ = 1.0 - first_ - second_;
    constexpr double kForgotten = 1e-10;
    memory_ = static_cast<std::size_t>(std::ceil(std::log(kForgotten) / std::log(std::abs(pole))));
  }

  void apply(std::vector<Vec2>& points) const {
    pass(points);
    std::ranges::reverse(points);
    pass(points);
    std::ranges::reverse(points);
  }

 private:
  /// Starts the filter after so many turns around the curve that its initial state has decayed.
  void pass(std::vector<Vec2>& points) const {
    const std::size_t count = points.size();
    std::size_t i = (count - memory_ % count) % count;
    Vec2 last = points[i];
    Vec2 before = last;
    const auto next = [&](Vec2 point) {
      const Vec2 out = gain_ * point + first_ * last + second_ * before;
      before = last;
      last = out;
      return out;
    };
    for (std::size_t k = 0; k < memory_; ++k) {
      next(points[i]);
      if (++i == count) i = 0;
    }
    for (Vec2& point : points) point = next(point);
  }

  double first_ = 0.0;
  double second_ = 0.0;
  double gain_ = 0.0;
  std::size_t memory_ = 0;
};

}  // namespace

std::vector<Vec2> softened(std::span<const Vec2> contour, double scale) {
  constexpr double kLeastTurns = 16.0;  // a curve with fewer points than this many scales would shrink
  std::vector<Vec2> out = at_equal_distances(contour);
  Spline(std::min(scale, static_cast<double>(out.size()) / kLeastTurns)).apply(out);
  return out;
}

}  // namespace mes
