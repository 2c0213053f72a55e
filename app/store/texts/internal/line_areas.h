// SPDX-License-Identifier: GPL-3.0-or-later
// The areas that lines enclose.
#pragma once

#include <cstdint>
#include <vector>

#include "core/base/geometry/vec2.h"

namespace mes {

/// A polygon. Rings repeat their first point; the outer one is counter-clockwise, and holes are clockwise.
struct LineArea {
  std::vector<Vec2> outer;
  std::vector<std::vector<Vec2>> holes;
};

struct LineAreas {
  std::vector<LineArea> areas;  ///< from left to right by their smallest points
  std::uint64_t left_out = 0;   ///< lines with free ends, and all lines joined to a point where an odd number meets
};

/// Positive for a counter-clockwise ring, which may repeat its first point.
double area_of(const std::vector<Vec2>& ring);

/// The points inside an odd number of rings. Lines are polylines that meet at equal ends and do not cross; two may be
/// the same, or run along each other, as the common border of two parcels does, which are an area each. Which ring
/// lies in which is decided exactly for the given points.
///
/// Cost: O(n log n) for n points.
LineAreas areas_of(std::vector<std::vector<Vec2>> lines);

}  // namespace mes
