// SPDX-License-Identifier: GPL-3.0-or-later
// Places moved, by as little as doubles allow, so that they are degenerate exactly.
//
// Four points that look cocircular hardly ever are: their coordinates are rounded. What is asked for here are doubles
// whose real values lie on one line, or on one circle, to the last digit. All of them are multiples of one power of
// two, so the question is one about integers:
//  * on a line, they are A + t (p, q) with integers t, and p / q a continued fraction of the slope;
//  * on a circle, they are C + (x, y) with x^2 + y^2 = N. A product N of many primes that leave 1 when divided by 4 is
//    a sum of two squares in very many ways (Gauss): four times the product of the exponents plus one.
#pragma once

#include <span>
#include <vector>

#include "core/base/disk.h"
#include "core/base/error.h"
#include "core/base/vec2.h"

namespace mes {

struct DegeneratePlaces {
  std::vector<Vec2> places;    ///< as many as were given, in their order, no two equal
  double largest_shift = 0.0;  ///< how far the one that moved most was moved, in units of the coordinates
};

/// The places, moved onto one line: each three of them are collinear as real numbers. Fewer than three stay where they
/// are. The line is that of least squares, but for its direction, which is rounded; shifts are some 2^-30 of the extent
/// beyond the distance from that line, or of the distance from the origin where that is larger.
///
/// Error: places that are equal or would become so; all places equal. Cost: O(n log n).
Expected<DegeneratePlaces> on_one_line(std::span<const Vec2> places);

/// The places, moved onto one circle: each four of them are cocircular as real numbers. Fewer than four stay where they
/// are. The circle is that of least squares, rounded; beyond their distance from it, places move by some 2e-5 of its
/// radius, rarely by more than 1e-4. Where the circle is small against its distance from the origin they move farther:
/// by some 2e-3 of the radius for a ratio of 10^6.
///
/// Error: places that are equal or would become so; places that are nearly on a line. Cost: O(n log n), and some
/// milliseconds for the points of the circle.
Expected<DegeneratePlaces> on_one_circle(std::span<const Vec2> places);

/// The circle that is nearest to the places in the sense of least squares of distances. Error: fewer than three places, or
/// places so near to a line that the circle is a hundred times as large as they are.
Expected<Disk> nearest_circle(std::span<const Vec2> places);

}  // namespace mes
