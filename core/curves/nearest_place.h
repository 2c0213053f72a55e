// SPDX-License-Identifier: GPL-3.0-or-later
// The point of curves that is nearest to a given point.
//
// Smallest use:
//     if (const auto place = nearest_place(curves, {0.0, 5.0}, 6.0)) use(*place);
#pragma once

#include <optional>

#include "core/curves/curve.h"

namespace mes {

/// Returns nothing if no curve is within `reach`; ends of curves count. On a line the result is the foot of the
/// perpendicular, rounded; on other pieces it is the nearest point up to 1e-9 of the parameter, found from the best of
/// 32 intervals. Isolated points of the set are ignored. Cost: O(pieces) box tests, and evaluations for nearby pieces.
std::optional<Vec2> nearest_place(const CurveSet& curves, Vec2 p, double reach);

/// Parameter of the point of a piece that is nearest to `p`, with the same precision.
double nearest_parameter(const Piece& piece, Vec2 p);

}  // namespace mes
