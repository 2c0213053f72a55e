// SPDX-License-Identifier: GPL-3.0-or-later
// Vertices in space that lie in one plane, in coordinates of that plane. Private to core/io.
#pragma once

#include <span>
#include <string>

#include "core/base/vec2.h"

namespace mes {

/// From above, unless all vertices lie in one plane that is not level: their coordinates are then replaced by those in
/// that plane. Of a plane through two axes they are numbers of the file; of others what is up stays up where the plane is steep, and x
/// points to the right where it is not. `rounding` is how much a number may be off. One line that says what was
/// done; empty where all heights are equal. O(n).
std::string bring_into_plane(std::span<Vec2> positions, std::span<const double> heights, double rounding);

}  // namespace mes
