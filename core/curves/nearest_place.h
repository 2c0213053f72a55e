// SPDX-License-Identifier: GPL-3.0-or-later
// The place of curves that is nearest to a point.
//
// Smallest use:
//     if (const auto place = nearest_place(curves, {0.0, 5.0}, 6.0)) use(*place);
#pragma once

#include <optional>

#include "core/base/box2.h"
#include "core/curves/curve.h"

namespace mes {

/// Nothing within `reach`, ends included. On lines the foot of the perpendicular, rounded; on other pieces the nearest
/// up to 1e-9 of the piece's parameter, from the best of 32 intervals. Points of the set are not asked. Cost: O(pieces) comparisons
/// with boxes, and evaluations for the pieces near by.
std::optional<Vec2> nearest_place(const CurveSet& curves, Vec2 p, double reach);

/// The parameter of the place of a piece that is nearest to a point, as exact as there.
double nearest_parameter(const Piece& piece, Vec2 p);

/// Contains the piece: the box of its control points, and of an arc that of its whole ellipse.
Box2 box_of(const Piece& piece);

}  // namespace mes
