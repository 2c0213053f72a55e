// SPDX-License-Identifier: GPL-3.0-or-later
// Moves points, by as little as doubles allow, into an exactly degenerate position.
//
// Four points that look cocircular hardly ever are: their coordinates are rounded. These functions find doubles whose
// exact values lie on one line or on one circle. All of them are multiples of one power of two, so the problem is one
// about integers:
//  * on a line, they are A + t (p, q) with integers t, and p / q is a continued fraction of the slope;
//  * on a circle, they are C + (x, y) with x^2 + y^2 = N. A product N of many primes that are 1 modulo 4 is a sum of
//    two squares in very many ways (Gauss): four times the product of the exponents plus one.
#pragma once

#include <span>
#include <vector>

#include "core/base/error.h"
#include "core/base/geometry/disk.h"
#include "core/base/geometry/vec2.h"

namespace mes {

struct DegeneratePlaces {
  std::vector<Vec2> places;    ///< the moved points, in the order given, no two equal
  double largest_shift = 0.0;  ///< largest distance that a point was moved, in units of the coordinates
};

/// Moves points onto one line: any three of the results are collinear as real numbers. Fewer than three points stay.
/// The line is that of least squares with a rounded direction. Beyond their distance from it, points move by about
/// 2^-30 of their extent, or of their distance from the origin if that is larger.
///
/// Error: points that are equal or would become so; all points equal. Cost: O(n log n).
Expected<DegeneratePlaces> on_one_line(std::span<const Vec2> places);

/// Moves points onto one circle: any four of the results are cocircular as real numbers. Fewer than four points stay.
/// The circle is that of least squares, rounded. Beyond their distance from it, points move by about 2e-5 of its
/// radius, rarely by more than 1e-4. If the circle is small compared with its distance from the origin, they move
/// farther: by about 2e-3 of the radius for a ratio of 10^6.
///
/// Error: points that are equal or would become so; points that are nearly on a line. Cost: O(n log n), plus some
/// milliseconds for the points of the circle.
Expected<DegeneratePlaces> on_one_circle(std::span<const Vec2> places);

/// The circle that minimizes the sum of squared distances to the points. Error: fewer than three points, or points so
/// close to a line that the circle is a hundred times as large as their extent.
Expected<Disk> nearest_circle(std::span<const Vec2> places);

}  // namespace mes
