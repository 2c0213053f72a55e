// SPDX-License-Identifier: GPL-3.0-or-later
// The angle at a corner of a triangle, rounded to doubles, for measuring; decisions use predicates instead.
//
// Both functions see directions alone: of points times a power of two they are the same, to the last bit, and no size
// within the range of coordinates makes them overflow. Exchanging q and r changes nothing.
#pragma once

#include "core/base/vec2.h"

namespace mes {

/// Angle at `p` between q and r in degrees, in [0, 180]. Three different points.
double angle_at(Vec2 p, Vec2 q, Vec2 r);

/// Its cotangent; infinite where doubles see no angle.
double cotangent_at(Vec2 p, Vec2 q, Vec2 r);

}  // namespace mes
