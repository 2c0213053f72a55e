// SPDX-License-Identifier: GPL-3.0-or-later
// Circles through two and three points, ordered by their radii.
#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "core/base/geometry/vec2.h"

namespace mes {

/// The circle through a, b and c, which are not collinear; or, if `has_third` is false, the circle with the segment from
/// a to b as a diameter.
struct SpannedCircle {
  Vec2 a{}, b{}, c{};
  bool has_third = false;
};

/// Ranks of circles among their different radii.
struct RadiusRanks {
  std::vector<std::uint32_t> rank;  ///< for each circle, the number of different radii smaller than its own
  std::vector<double> radius;       ///< for each rank, its radius rounded up
};

/// Guarantees:
///  1. Two circles have the same rank if and only if their radii are equal, as real numbers, for the given doubles;
///     otherwise the larger radius has the larger rank. `radius` never decreases with the rank.
///  2. Ranks and radii depend on the set of circles alone, not on the order of circles or of points. Scaling by a power
///     of two keeps the ranks and scales the radii exactly.
///  3. `radius` is the least double that is not smaller than the true radius of the rank.
///
/// Cost: O(n log n) on all cores where radii are well apart, plus a rational number for each different circle whose
/// radius equals another or nearly so. Circles whose squared sides are the same exact doubles, as on a lattice of
/// integers, share one number; circles through samples of one circle, whose radii are nearly equal, do not.
/// `checkpoint` is called now and then, and may throw. Coordinates are within core/base/geometry/coordinate_range.h.
RadiusRanks rank_radii(std::span<const SpannedCircle> circles, const std::function<void()>& checkpoint);

/// True if the smallest circle around a and b holds p, inside or on it, that is, if the angle at p is 90 degrees or
/// more. Exact; p is neither a nor b.
bool sees_wide(Vec2 p, Vec2 a, Vec2 b);

/// The least double that is not smaller than the exact radius.
double radius_above(const SpannedCircle& circle);

}  // namespace mes
