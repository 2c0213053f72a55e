// SPDX-License-Identifier: GPL-3.0-or-later
// What there is to say of two places in the plane, or of three.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/base/disk.h"
#include "core/base/vec2.h"

namespace mes {

/// Of two places their distance, the steps along the axes, and the direction from the first to the second in degrees,
/// counter-clockwise from the x axis, in (-180, 180]. Of three the distance of the last two, the angle at the second
/// one, in [0, 180] degrees, and the circle through them, or that they are on one line, which is decided exactly
/// within the range of coordinates (core/base/coordinate_range.h).
/// What places that coincide leave undefined is left out. Six digits. Fewer places than two give no lines.
std::vector<std::string> measured_words(std::span<const Vec2> places);

/// The circle through three places; none where they are on one line.
std::optional<Disk> measured_circle(std::span<const Vec2> places);

}  // namespace mes
