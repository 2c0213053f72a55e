// SPDX-License-Identifier: GPL-3.0-or-later
// Corners of curves: where they are, and curves without them.
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
  std::size_t curve = 0;  ///< its place in the set
};

/// Where the tangent turns by more than `corner_angle`, radians, in the order of the curves. Ends are none. Pieces below
/// 1e-9 of the longest of their curve have no direction of their own. Cost: O(pieces).
std::vector<CurveCorner> corners_of(const CurveSet& curves, double corner_angle);

/// The same curves with corners rounded. Between two lines that is the arc of a circle of the radius, tangent to both;
/// where a side is curved, a cubic that begins and ends as far from the corner and has the tangents of the curve there.
/// No more than half of what lies between two corners is given up, so a large radius becomes smaller where corners are
/// near to each other. Open ends, and curves without corners, stay as they are. `radius` is positive. Cost: O(pieces).
CurveSet with_round_corners(const CurveSet& curves, double corner_angle, double radius);

}  // namespace mes
