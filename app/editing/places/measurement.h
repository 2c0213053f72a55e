// SPDX-License-Identifier: GPL-3.0-or-later
// Measurements of two or three points in the plane.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/base/geometry/disk.h"
#include "core/base/geometry/vec2.h"

namespace mes {

/// For two points: their distance, the steps along the axes, and the direction from the first to the second in
/// degrees, counter-clockwise from the x axis, in (-180, 180]. For three: the distance of the last two, the angle at
/// the second one, in [0, 180] degrees, and the circle through them, or that they are on one line, which is decided
/// exactly within the range of coordinates (core/base/geometry/coordinate_range.h). Leaves out values that coinciding points
/// make undefined. Uses six digits. Fewer than two points give no lines.
std::vector<std::string> measured_words(std::span<const Vec2> places);

/// The circle through three points; nothing if they are on one line.
std::optional<Disk> measured_circle(std::span<const Vec2> places);

}  // namespace mes
