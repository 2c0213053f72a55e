// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/raster/internal/smoothing.h"

#include <algorithm>
#include <cmath>
#include <complex>
#include <cstddef>

namespace mes {
namespace {

constexpr std::size_t kLeastPoints = 8;
// Of the displacement that is allowed: up to there a scale counts in full, and beyond it less and less.
constexpr double kFull = 0.7;

/// Pixels are neither huge nor tiny, so nothing overflows.
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
  /// The beginning is what has come around so often that nothing is left of how it began.
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

/// Twice the spline minus the spline of the spline: what bends gently keeps its place to the next order.
std::vector<Vec2> filtered(const std::vector<Vec2>& points, const Spline& spline) {
  std::vector<Vec2> once = points;
  spline.apply(once);
  std::vector<Vec2> out = once;
  spline.apply(out);
  for (std::size_t i = 0; i < out.size(); ++i) out[i] = 2.0 * once[i] - out[i];
  return out;
}

/// The values with the last `reach` before them and the first `reach` after, around.
std::vector<double> extended(const std::vector<double>& values, std::size_t reach) {
  std::vector<double> out(values.end() - static_cast<std::ptrdiff_t>(reach), values.end());
  out.insert(out.end(), values.begin(), values.end());
  out.insert(out.end(), values.begin(), values.begin() + static_cast<std::ptrdiff_t>(reach));
  return out;
}

/// The largest of each value and the `reach` before and after it, around.
std::vector<double> largest_near(const std::vector<double>& values, std::size_t reach) {
  const std::size_t count = values.size();
  if (2 * reach + 1 >= count) return std::vector<double>(count, *std::ranges::max_element(values));
  // Within blocks of one window, the largest so far from the left and from the right (van Herk 1992).
  const std::size_t window = 2 * reach + 1;
  const std::vector<double> around = extended(values, reach);
  std::vector<double> from_left = around;
  std::vector<double> from_right = around;
  for (std::size_t i = 1; i < around.size(); ++i)
    if (i % window != 0) from_left[i] = std::max(from_left[i], from_left[i - 1]);
  for (std::size_t i = around.size() - 1; i > 0; --i)
    if (i % window != 0) from_right[i - 1] = std::max(from_right[i - 1], from_right[i]);
  std::vector<double> out(count);
  for (std::size_t i = 0; i < count; ++i) out[i] = std::max(from_right[i], from_left[i + window - 1]);
  return out;
}

/// The mean of each value and the `reach` before and after it, around.
std::vector<double> mean_near(const std::vector<double>& values, std::size_t reach) {
  const std::size_t count = values.size();
  reach = std::min(reach, (count - 1) / 2);
  const std::size_t window = 2 * reach + 1;
  const std::vector<double> around = extended(values, reach);
  std::vector<double> out(count);
  double sum = 0.0;
  for (std::size_t i = 0; i + 1 < window; ++i) sum += around[i];
  for (std::size_t i = 0; i < count; ++i) {
    sum += around[i + window - 1];
    out[i] = sum / static_cast<double>(window);
    sum -= around[i];
  }
  return out;
}

/// One up to `kFull` of the limit, zero from the limit on.
double weight_of(double displacement, double limit) {
  const double share = std::clamp((limit - displacement) / ((1.0 - kFull) * limit), 0.0, 1.0);
  return share * share * (3.0 - 2.0 * share);
}

}  // namespace

std::vector<Vec2> smoothed(std::span<const Vec2> contour, const SmoothingLimits& limits, const JobControl* job) {
  const std::vector<Vec2> points = at_equal_distances(contour);
  std::vector<Vec2> out = points;
  std::vector<double> moved(points.size());
  double scale = limits.widest;
  while (scale >= 2.0) scale *= 0.5;
  for (; scale <= limits.widest; scale *= 2.0) {
    if (job != nullptr && job->stop_requested()) throw Cancelled{};
    const std::vector<Vec2> wider = filtered(points, Spline(scale));
    for (std::size_t i = 0; i < points.size(); ++i) moved[i] = length_between(points[i], wider[i]);
    const auto reach = static_cast<std::size_t>(std::lround(scale));
    std::vector<double> weights = largest_near(moved, 2 * reach);
    for (double& weight : weights) weight = weight_of(weight, limits.displacement);
    // A weight that changes from point to point would bend what is smooth. Where a point moves too far, all within reach
    // have no weight.
    weights = mean_near(weights, reach);
    for (std::size_t i = 0; i < points.size(); ++i) out[i] = out[i] + weights[i] * (wider[i] - out[i]);
  }
  // The smallest scale may be too wide as well, where a contour is only a few pixels long.
  for (std::size_t i = 0; i < points.size(); ++i) {
    const double away = length_between(points[i], out[i]);
    if (away > limits.displacement) out[i] = points[i] + limits.displacement / away * (out[i] - points[i]);
  }
  return out;
}

}  // namespace mes
