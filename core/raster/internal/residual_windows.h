// SPDX-License-Identifier: GPL-3.0-or-later
// What a curve leaves of the edges it was fitted to: whether it could be noise. Private to core/raster.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <span>
#include <vector>

namespace mes {

/// Of one edge.
struct Residual {
  double left = 0.0;    ///< beside the curve, pixels
  double weight = 0.0;  ///< length of the curve that it stands for, pixels
  double jumps = 0.0;   ///< pixel borders or diagonals that a pixel of the curve passes
  bool is_new = true;   ///< it has changed since windows were looked at
};

/// Sums over the edges before one.
struct ResidualSum {
  double left = 0.0;
  double weight = 0.0;
  double jumps = 0.0;
  std::size_t fresh = 0;
};

/// What stands alone: so many edges at most, that enclose so little beside the curve.
inline constexpr std::size_t kMostAlone = 3;
inline constexpr double kMostAloneArea = 1.6;  ///< square pixels
inline constexpr double kAlone = 0.35;         ///< pixels beyond the noise
/// The mean over a window may be off by the first share of what a single edge may be off by, plus the second share divided by
/// the square root of the length.
inline constexpr double kSystematic = 0.3;
inline constexpr double kIndependent = 0.8;

/// Calls `use(first, end, are_alone)` for edges in a row that are farther from the curve than noise, and for each other edge.
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

/// Calls `use(first, count)` for windows of 4, 8, 16 ... edges, around if they are closed, of which any is new and whose mean
/// is more than noise
/// where single edges are off by `one` at most: what independent ones leave of that, or what the grid does to a straight
/// line that passes so many borders, whichever is more, and 0.3 of it that is the same all along. `sums` is memory to work in. O(n log n).
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
