// SPDX-License-Identifier: GPL-3.0-or-later
// The vertex of the Voronoi diagram that the pointer is near to, found among the samples around it.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <span>

#include "core/base/disk.h"
#include "core/base/vec2.h"

namespace mes {

struct NearVertex {
  std::array<std::size_t, 3> corners{};  ///< positions in the list of sites, increasing
  Vec2 at{};                             ///< the centre of the circle through them
};

/// The vertex nearest to `p` of the Voronoi diagram of the sites, if it is nearer than `reach`. Sites whose distance from
/// `p` is larger than that of the nearest one by more than twice the reach make no difference. Where more than three sites
/// are on one circle, three of them. For the hand: decided by doubles. O(n^2), mostly in a few operations a pair.
std::optional<NearVertex> vertex_near(std::span<const Vec2> sites, Vec2 p, double reach);

}  // namespace mes
