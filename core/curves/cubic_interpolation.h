// SPDX-License-Identifier: GPL-3.0-or-later
// The cubic spline through points, as drawing programs make it of fit points.
#pragma once

#include <optional>
#include <span>

#include "core/base/vec2.h"
#include "core/curves/curve.h"

namespace mes {

/// Directions at the ends of an open curve, of any length; zero counts as none.
struct EndTangents {
  std::optional<Vec2> at_start{};
  std::optional<Vec2> at_end{};
};

/// The curve with two continuous derivatives whose pieces between points are cubic, with distances of neighbours as
/// parameters. An open one has the directions of `tangents` at its ends, and no curvature where there is none. Neighbours that are equal are one
/// point; a closed curve may repeat its first point at the end. Two points without tangents are a line, one is a curve without
/// pieces. Nothing for no points, or for numbers that are not finite. O(n).
/// Source: Ahlberg, Nilson and Walsh, "The theory of splines and their applications", 1967, sections 2.1 and 2.2.
///
/// Smallest use:
///     const auto arch = cubic_through(std::vector<Vec2>{{0, 0}, {1, 1}, {2, 0}}, false);
std::optional<PlaneCurve> cubic_through(std::span<const Vec2> points, bool is_closed,
                                        const EndTangents& tangents = {});

}  // namespace mes
