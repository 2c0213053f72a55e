// SPDX-License-Identifier: GPL-3.0-or-later
// A smooth curve through points.
//
// Smallest use:
//     const PlaneCurve curve = smooth_curve(points, true, 0.8);
#pragma once

#include <span>

#include "core/base/geometry/vec2.h"
#include "core/curves/curve.h"

namespace mes {

/// A curve of cubic pieces from each point to the next; a closed curve returns to the first. It has a corner at open
/// ends, and at points where the polygon turns by more than `corner_angle`, in radians; elsewhere its tangent is that
/// of the centripetal Catmull-Rom spline. `points` must not be empty. Equal neighbours are skipped. O(n).
/// Source: Barry and Goldman, "A recursive evaluation algorithm for a class of Catmull-Rom splines", 1988, with the
/// knots of Lee, "Choosing nodes in parametric curve interpolation", 1989.
PlaneCurve smooth_curve(std::span<const Vec2> points, bool is_closed, double corner_angle);

}  // namespace mes
