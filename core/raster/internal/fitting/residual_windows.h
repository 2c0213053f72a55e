// SPDX-License-Identifier: GPL-3.0-or-later
// Decides whether the residuals of a fitted curve could be noise. Private to core/raster.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <span>
#include <vector>

namespace mes {

/// The residual of one edge.
struct Residual {
  double left = 0.0;    ///< distance from the curve to the edge, pixels
  double weight = 0.0;  ///< length of the curve that it represents, pixels
  double jumps = 0.0;   ///< pixel borders or diagonals that the curve crosses for each pixel of length
  bool is_new = true;   ///< it has changed since the last check of windows
};

/// Sums over all edges before one.
struct ResidualSum {
  double left = 0.0;
  double weight = 0.0;
  double jumps = 0.0;
  std::size_t fresh = 0;
};

/// Limits of an isolated deviation: the number of its edges, and the area between them and the curve.
inline constexpr std::size_t kMostAlone = 3;
inline constexpr double kMostAloneArea = 1.6;  ///< square pixels
inline constexpr double kAlone = 0.35;         ///< pixels beyond the noise
/// The mean over a window may be off by this factor times the error of a single edge: the first share, plus the second
/// share divided by the square root of the length.
inline constexpr double kSystematic = 0.3;
inline constexpr double kIndependent = 0.8;

/// Calls `use(first, end, are_alone)` for each run of edges farther from the curve than noise, and for each other edge.
template <class Use>
void for_each_stray(std::span<const Residual> residuals, double one, Use use) {
  const double limit = one + kAlone;
  std::size_t i = 0;
  while (i < residuals.size()) {
    std::size_t end = i;
    double area = 0.0;
    for (; end < residuals.size() && std::abs(residuals[end].left) > limit; ++end)
      area += residuals[end].weight * std::abs(residuals[end].left);
    const bool are_alone = end != i && end - i <= kMostAlone && area <= kMostAloneArea;
    end = std::max(end, i + 1);
    use(i, end, are_alone);
    i = end;
  }
}

/// Calls `use(first, count)` for windows of 4, 8, 16 ... edges (cyclic if closed) that contain a new edge and whose
/// mean exceeds the noise. Single edges are off by at most `one`. The allowed mean is 0.3 of that as a systematic part,
/// plus the larger of the mean of independent errors and the effect of the grid on a straight line that crosses as many
/// borders. `sums` is scratch memory. O(n log n).
template <class Use>
void for_each_misfit(std::span<const Residual> residuals, bool is_closed, double one, std::vector<ResidualSum>& sums,
                     Use use) {
  constexpr std::size_t kFirstWindow = 4;
  const std::size_t count = residuals.size();
  sums.assign(1, {});
  sums.reserve(2 * count + 1);
  const std::size_t around = is_closed ? 2 * count : count;
  for (std::size_t k = 0; k < around; ++k) {
    const Residual& here = residuals[k < count ? k : k - count];
    const ResidualSum& sum = sums.back();
    sums.push_back({sum.left + here.weight * here.left, sum.weight + here.weight,
                    sum.jumps + here.weight * here.jumps, sum.fresh + (here.is_new ? 1U : 0U)});
  }
  for (std::size_t window = kFirstWindow; window <= count; window *= 2) {
    const std::size_t step = window / kFirstWindow;
    for (std::size_t i = 0; i < count && i + window <= around; i += step) {
      const ResidualSum& a = sums[i];
      const ResidualSum& b = sums[i + window];
      if (a.fresh == b.fresh) continue;
      const double weight = b.weight - a.weight;
      const double left = std::abs(b.left - a.left);
      if (left <= kSystematic * one * weight) continue;
      const double share = std::max(1.0 / (1.0 + b.jumps - a.jumps), kIndependent / std::sqrt(std::max(weight, 1.0)));
      if (left > one * (kSystematic + share) * weight) use(i, window);
    }
  }
}

}  // namespace mes
