// SPDX-License-Identifier: GPL-3.0-or-later
// Finds the corners of curves, and rounds them.
//
// At a corner the local feature size is zero, so no density of samples is enough for the theorems of the crust there.
//
// Smallest use:
//     for (const CurveCorner& corner : corners_of(curves, 0.5)) mark(corner.place, corner.angle);
//     const CurveSet smooth = with_round_corners(curves, 0.5, 2.0);
#pragma once

#include <cstddef>
#include <vector>

#include "core/curves/curve.h"

namespace mes {

struct CurveCorner {
  Vec2 place{};
  double angle = 0.0;     ///< between the two sides, radians: 0 where the curve turns back, below pi
  std::size_t curve = 0;  ///< index in the set
};

/// Points where the tangent turns by more than `corner_angle`, in radians, in the order of the curves. Ends are not
/// corners. Pieces below 1e-9 of the longest piece of their curve have no direction of their own. Cost: O(pieces).
std::vector<CurveCorner> corners_of(const CurveSet& curves, double corner_angle);

/// The same curves with rounded corners. Between two lines the rounding is a circular arc of the radius, tangent to
/// both. Where a side is curved, it is a cubic that begins and ends at the same distance from the corner, with the
/// tangents of the curve there. At most half of the curve between two corners is cut off, so a large radius shrinks
/// where corners are close to each other. Open ends, and curves without corners, do not change. `radius` must be
/// positive. Cost: O(pieces).
CurveSet with_round_corners(const CurveSet& curves, double corner_angle, double radius);

}  // namespace mes
