// SPDX-License-Identifier: GPL-3.0-or-later
// Balls between two balls of a pencil, as densely as an angle says.
#pragma once

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/base/disk.h"

namespace mes {

/// Two balls are near when their circles cross at `sampling_angle` degrees or more (their radii at the crossing enclose
/// 180 degrees less that), or when their centres are nearer than `shortest`; if balls have to meet, only where they do.
class BallHalving {
 public:
  explicit BallHalving(double sampling_angle = 180.0, double shortest = 0.0, bool has_to_meet = false)
      : least_cosine_(std::cos((180.0 - sampling_angle) * std::numbers::pi / 180.0)),
        shortest_(shortest),
        has_to_meet_(has_to_meet) {}

  bool is_near(const Disk& a, const Disk& b) const {
    const double d = distance(a.center, b.center);
    if (!(d > 0.0)) return true;
    if (d < shortest_ && (!has_to_meet_ || d < a.radius + b.radius)) return true;
    // In units of the largest: squares of what doubles hold need not fit.
    const double size = std::max({a.radius, b.radius, d});
    const double ra = a.radius / size;
    const double rb = b.radius / size;
    return ra * ra + rb * rb - (d / size) * (d / size) >= least_cosine_ * 2.0 * ra * rb;
  }

  /// Adds the balls `at(u)`, 0 < u < 1, between `first` = at(0) and `last` = at(1), by halving at most twenty times. Parts
  /// are named by their place along the whole, which halving keeps exact: seen from either end they are the same.
  template <class At, class Add>
  void halve(const At& at, const Disk& first, const Disk& last, const Add& add) const {
    halve(at, 0.0, first, 1.0, last, 0, add);
  }

 private:
  static constexpr int kMostHalvings = 20;

  template <class At, class Add>
  void halve(const At& at, double from, const Disk& first, double to, const Disk& last, int depth,
             const Add& add) const {
    if (depth == kMostHalvings || is_near(first, last)) return;
    const double middle = 0.5 * (from + to);
    const Disk disk = at(middle);
    if (!is_finite(disk)) return;
    add(disk);
    halve(at, from, first, middle, disk, depth + 1, add);
    halve(at, middle, disk, to, last, depth + 1, add);
  }

  double least_cosine_;
  double shortest_;
  bool has_to_meet_;
};

inline Vec2 place_between(Vec2 a, Vec2 b, double u) {
  return (1.0 - u) * a + u * b;
}

}  // namespace mes
