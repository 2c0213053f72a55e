// SPDX-License-Identifier: GPL-3.0-or-later
// Chains of segments and parabolas, which writers can output as one path.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "render/figure/figure.h"
#include "render/figure/internal/grid.h"

namespace mes::figure {

/// Reorders and reverses the segments and parabolas, whose ends are on the grid, such that each begins at the end of the previous one
/// wherever that is possible without going back; other shapes follow after them. O(n log n).
void chain_segments(std::vector<Shape>& shapes, const Grid& grid);

/// The length of the chain from `first` on, each beginning at the end of the previous one; 0 if the first
/// shape is of another kind.
std::size_t chain_length(std::span<const Shape> shapes, std::size_t first);

/// Whether such a chain, of at least three shapes, ends at its start.
bool is_loop(std::span<const Shape> chain);

}  // namespace mes::figure
