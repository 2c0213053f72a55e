// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <vector>

#include "core/base/geometry/vec2.h"
#include "core/base/rng.h"

namespace mes::test {

/// Draws points from a grid of size x size, some of them repeatedly.
inline std::vector<Vec2> grid_draws(std::size_t n, std::uint64_t size, std::uint64_t seed) {
  Rng rng(seed);
  std::vector<Vec2> out;
  for (std::size_t i = 0; i < n; ++i)
    out.push_back({static_cast<double>(rng.below(size)), static_cast<double>(rng.below(size))});
  return out;
}

}  // namespace mes::test
