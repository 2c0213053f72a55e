// SPDX-License-Identifier: GPL-3.0-or-later
// Vertices in space that lie in one plane, in coordinates of that plane. Private to core/io.
#pragma once

#include <span>
#include <string>

#include "core/base/geometry/vec2.h"

namespace mes {

/// Projects from above, unless all vertices lie in one plane that is not level: then replaces their coordinates by
/// those in this plane. For a plane through two axes, these are numbers of the file; for other planes, up stays up if
/// the plane is steep, and otherwise x points to the right. `rounding` is the largest error of a number. Returns one
/// line about the change; empty if all heights are equal. O(n).
std::string bring_into_plane(std::span<Vec2> positions, std::span<const double> heights, double rounding);

}  // namespace mes
