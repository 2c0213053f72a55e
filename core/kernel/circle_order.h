// SPDX-License-Identifier: GPL-3.0-or-later
// Circles through two and three points, ordered by their radii.
#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "core/base/vec2.h"

namespace mes {

/// The circle through a, b and c, which are not collinear; or, if `has_third` is false, the circle with the segment from
/// a to b as a diameter.
struct SpannedCircle {
  Vec2 a{}, b{}, c{};
  bool has_third = false;
};

/// Places of circles among their different radii.
struct RadiusRanks {
  std::vector<std::uint32_t> rank;  ///< of each circle: how many different radii are smaller than its own
  std::vector<double> radius;       ///< of each rank, rounded up
};

/// What it guarantees:
///  1. Two circles have the same rank if and only if their radii are equal, as real numbers, for the given doubles;
///     otherwise the larger radius has the larger rank. `radius` never decreases with the rank.
///  2. Ranks and radii depend on the set of circles alone, not on the order of circles or of points. Circles times a power
///     of two have the same ranks, and radii times that power to the last bit.
///  3. The radius of a rank is the least double that is not smaller than it.
///
/// Cost: O(n log n) on all cores where radii are well apart; a rational number for each different circle whose radius is
/// equal to another, or nearly so. Circles with sides of the same squares, each of them a double, as on a lattice of
/// integers, count once; those of samples of one circle, whose radii are nearly equal, do not. `checkpoint` is called now
/// and then, and may throw. Coordinates are within core/base/coordinate_range.h.
RadiusRanks rank_radii(std::span<const SpannedCircle> circles, const std::function<void()>& checkpoint);

/// The smallest circle around a and b holds p, inside or on it: the angle at p is 90 degrees or more. Exact; p is neither
/// a nor b.
bool sees_wide(Vec2 p, Vec2 a, Vec2 b);

/// The least double that is not smaller than the radius, exactly.
double radius_above(const SpannedCircle& circle);

}  // namespace mes
