// SPDX-License-Identifier: GPL-3.0-or-later
// Splits an outline into parts whose medial axes do not depend on each other.
#pragma once

#include <span>
#include <vector>

#include "core/structures/outline/outline_sides.h"

namespace mes {

/// `sides` are those of `OutlineSides::take`. Two sides are in one part if they touch, or if both bound one connected
/// region that an odd number of closed contours surrounds. So the houses of a town are a part each, together with their
/// courtyards. Sides that bound no such region are in no part.
///
/// Guarantees: exact, and the parts depend on the sides alone: they are in the order of their first sides, which keep
/// their order, and stretches of smooth curves are numbered from 0 in each part.
///
/// Cost: O(n log n) for n sides.
/// Source: the plane sweep of Shamos and Hoey, "Geometric intersection problems", 1976, for sides that do not cross.
std::vector<std::vector<OutlineSide>> independent_parts(std::span<const OutlineSide> sides);

}  // namespace mes
