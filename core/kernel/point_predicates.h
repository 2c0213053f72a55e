// SPDX-License-Identifier: GPL-3.0-or-later
// Exact signs for the usual questions about points and disks, for occasional calls. Code that makes millions of calls
// has predicates of its own.
#pragma once

#include "core/base/geometry/disk.h"
#include "core/base/geometry/vec2.h"

namespace mes {

// Each returns -1, 0 or 1. Coordinates are finite, and radii are not negative.

/// 1: a, b, c turn counter-clockwise; 0: they lie on a line.
int orientation(Vec2 a, Vec2 b, Vec2 c);
/// 1: d lies inside the circle through a, b, c, if these turn counter-clockwise; 0: on it. Clockwise turns flip the
/// sign.
int side_of_circle(Vec2 a, Vec2 b, Vec2 c, Vec2 d);
/// 1: c lies inside the circle with the diameter ab; 0: on it.
int side_of_diametral_circle(Vec2 a, Vec2 b, Vec2 c);
/// 1: d lies inside the orthogonal circle of a, b, c, if their centres turn counter-clockwise: its power to that circle
/// is less than its squared radius. Clockwise turns flip the sign.
int side_of_power_circle(const Disk& a, const Disk& b, const Disk& c, const Disk& d);
/// Compares the lengths of ab and cd.
int compare_distances(Vec2 a, Vec2 b, Vec2 c, Vec2 d);
/// Compares the radii of the circles through a, b, c and through d, e, f. A circle through points on a line is larger
/// than any other.
int compare_circumradii(Vec2 a, Vec2 b, Vec2 c, Vec2 d, Vec2 e, Vec2 f);

}  // namespace mes
