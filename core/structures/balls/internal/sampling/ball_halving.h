// SPDX-License-Identifier: GPL-3.0-or-later
// Balls between two balls of a pencil, as dense as an angle requires.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <optional>
#include <string_view>
#include <vector>

#include "core/base/geometry/disk.h"
#include "core/base/geometry/finding.h"

namespace mes {

/// Two balls are near if their circles cross at `sampling_angle` degrees or more (their radii at the crossing enclose
/// 180 degrees less that). They are also near if their centres are closer than `shortest` and, where balls have to
/// meet, they do. A tolerance adds balls whose circles cross at 120 degrees or more and are nowhere farther than the
/// tolerance below a line that touches both.
class BallHalving {
 public:
  explicit BallHalving(double sampling_angle = 180.0, double shortest = 0.0, bool has_to_meet = false,
                       double tolerance = 0.0)
      : least_cosine_(std::cos((180.0 - sampling_angle) * std::numbers::pi / 180.0)),
        shortest_(shortest),
        has_to_meet_(has_to_meet),
        tolerance_(tolerance) {}

  double tolerance() const { return tolerance_; }
  /// False at 120 degrees or less, where a tolerance changes nothing.
  bool has_use_for_tolerance() const { return least_cosine_ > kLeastCosine + kRounding; }
  /// The largest distance at which balls of that radius are near.
  double widest(double radius) const {
    const double of_short_parts = has_to_meet_ ? std::min(shortest_, 2.0 * radius) : shortest_;
    return std::max(radius * std::sqrt(2.0 * (1.0 - least_cosine(radius))), of_short_parts);
  }

  bool is_near(const Disk& a, const Disk& b) const {
    const double d = distance(a.center, b.center);
    if (!(d > 0.0)) return true;
    if (d < shortest_ && (!has_to_meet_ || d < a.radius + b.radius)) return true;
    // Scaled by the largest, since squares of large doubles overflow.
    const double size = std::max({a.radius, b.radius, d});
    const double ra = a.radius / size;
    const double rb = b.radius / size;
    return ra * ra + rb * rb - (d / size) * (d / size) >= least_cosine(std::max(a.radius, b.radius)) * 2.0 * ra * rb;
  }

  /// Adds the balls `at(u)`, 0 < u < 1, between `first` = at(0) and `last` = at(1), by halving at most twenty times.
  /// Parts are named by their parameter u, which halving keeps exact: seen from either end they are the same.
  template <class At, class Add>
  void halve(const At& at, const Disk& first, const Disk& last, const Add& add) const {
    halve(at, 0.0, first, 1.0, last, 0, add);
  }

 private:
  static constexpr int kMostHalvings = 20;
  static constexpr double kLeastCosine = 0.5;  // cosine of 60 degrees
  static constexpr double kRounding = 1e-15;

  /// Least cosine of the angle that radii enclose at the crossing; `radius` is the larger one.
  double least_cosine(double radius) const {
    if (tolerance_ == 0.0) return least_cosine_;
    // For radii of at most r and half the angle h, the dent is at most r (1 - cos h) deep.
    const double cosine_of_half = 1.0 - std::min(1.0, tolerance_ / radius);
    return std::min(least_cosine_, std::max(kLeastCosine, 2.0 * cosine_of_half * cosine_of_half - 1.0));
  }

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
  double tolerance_;
};

/// Largest number of balls between that are grown, shrunk or shown at once. A union takes about two kilobytes for each.
inline constexpr std::size_t kMostBallsBetween = 500'000;

/// The tolerance to try after one with too many balls. The first is 2^-29 of the diameter of the samples, or of own
/// balls, each further one four times the last, up to 2^-11, half a pixel in a thousand. Nothing after that, nor if it
/// is of no use.
std::optional<double> wider_tolerance(const BallHalving& halving, double diameter);
/// The same; throws `SizeRefusal` if there is none.
double next_tolerance(const BallHalving& halving, double diameter);
/// Reports that balls were made with a tolerance, if it is not 0.
void find_tolerance(std::string_view structure, double tolerance, std::size_t balls, std::vector<Finding>& out);

inline Vec2 place_between(Vec2 a, Vec2 b, double u) {
  return (1.0 - u) * a + u * b;
}

}  // namespace mes
