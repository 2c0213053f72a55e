// SPDX-License-Identifier: GPL-3.0-or-later
// Building blocks of the shapes. Private to core/shapes.
#pragma once

#include <cmath>
#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/base/geometry/turn.h"
#include "core/shapes/shape.h"

namespace mes {

std::unexpected<Error> impossible(std::string text);

/// A positive length, in units of the plane.
inline Parameter length_parameter(const char* id, const char* explanation, double value) {
  return {id, explanation, "", 1e-6, 1e6, value};
}

/// The point at this distance from the origin; the angle is counter-clockwise from the positive x axis.
inline Vec2 at_angle(double radius, double angle) {
  return {radius * std::cos(angle), radius * std::sin(angle)};
}

/// Starts at the right and runs counter-clockwise; a hole runs clockwise.
PlaneCurve ellipse_curve(Vec2 center, double a, double b, bool is_hole = false);
PlaneCurve polygon_curve(std::span<const Vec2> corners);

/// The curve of a function of a parameter, as cubic pieces that share ends and end tangents with the function: within
/// about 1e-9 of its size where it is smooth. A piece ends at each multiple of range / `pieces`, where the curve may
/// have corners. Closed if both ends are equal up to rounding and `may_close`. Error: `bad_input` for a value that is
/// not finite.
using PointOf = std::function<Vec2(double)>;
Expected<PlaneCurve> curve_of_function(const PointOf& at, double from, double to, std::size_t pieces, bool may_close);

// The families, one file each.
std::vector<ShapeDescriptor> round_shapes();
std::vector<ShapeDescriptor> cornered_shapes();
std::vector<ShapeDescriptor> formula_shapes();
std::vector<ShapeDescriptor> point_shapes();

}  // namespace mes
