// SPDX-License-Identifier: GPL-3.0-or-later
// The cubic spline through points, as drawing programs compute it from fit points.
#pragma once

#include <optional>
#include <span>

#include "core/base/geometry/vec2.h"
#include "core/curves/curve.h"

namespace mes {

/// Directions at the ends of an open curve, of any length; zero counts as unset.
struct EndTangents {
  std::optional<Vec2> at_start{};
  std::optional<Vec2> at_end{};
};

/// The curve with two continuous derivatives whose pieces between points are cubic, parameterized by the distances of
/// neighbours. An open curve starts and ends in the directions of `tangents`; where one is unset, its curvature is
/// zero. Equal neighbours count as one point; a closed curve may repeat its first point at the end. Two points without
/// tangents give a line, one point gives a curve without pieces. Returns nothing for no points or for numbers that are
/// not finite. O(n).
/// Source: Ahlberg, Nilson and Walsh, "The theory of splines and their applications", 1967, sections 2.1 and 2.2.
///
/// Smallest use:
///     const auto arch = cubic_through(std::vector<Vec2>{{0, 0}, {1, 1}, {2, 0}}, false);
std::optional<PlaneCurve> cubic_through(std::span<const Vec2> points, bool is_closed,
                                        const EndTangents& tangents = {});

}  // namespace mes
