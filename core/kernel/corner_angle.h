// SPDX-License-Identifier: GPL-3.0-or-later
// The angle at a corner of a triangle, rounded to doubles, for measuring; decisions use predicates instead.
//
// Both functions depend on directions alone: scaling the points by a power of two changes no bit, and no size within
// the range of coordinates makes them overflow. Exchanging q and r changes nothing.
#pragma once

#include "core/base/geometry/vec2.h"

namespace mes {

/// Angle at `p` between q and r in degrees, in [0, 180]. The points must differ.
double angle_at(Vec2 p, Vec2 q, Vec2 r);

/// Cotangent of that angle; infinite where doubles make the points collinear.
double cotangent_at(Vec2 p, Vec2 q, Vec2 r);

}  // namespace mes
