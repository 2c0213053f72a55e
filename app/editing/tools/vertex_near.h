// SPDX-License-Identifier: GPL-3.0-or-later
// Finds the Voronoi vertex near the pointer among the samples around it.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <span>

#include "core/base/geometry/disk.h"
#include "core/base/geometry/vec2.h"

namespace mes {

struct NearVertex {
  std::array<std::size_t, 3> corners{};  ///< indices in the list of sites, increasing
  Vec2 at{};                             ///< the centre of the circle through them
};

/// The vertex of the sites' Voronoi diagram nearest to `p`, if it is nearer than `reach`. Sites farther from `p` than
/// the nearest one by more than twice the reach do not matter. If more than three sites are on one circle, returns
/// three of them. Meant for the hand, so it decides by doubles. O(n^2), mostly a few operations per pair.
std::optional<NearVertex> vertex_near(std::span<const Vec2> sites, Vec2 p, double reach);

}  // namespace mes
