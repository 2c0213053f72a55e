// SPDX-License-Identifier: GPL-3.0-or-later
// Segments that follow one another, so that writers can give them as one path.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "render/figure/figure.h"
#include "render/figure/internal/grid.h"

namespace mes::figure {

/// Reorders and turns the segments, whose ends are on the grid, such that each begins where the one before ended
/// wherever that is possible without going back; other shapes follow after all segments. O(n log n).
void chain_segments(std::vector<Shape>& shapes, const Grid& grid);

/// The number of segments from `first` on of which each begins where the one before ended; 0 if the first shape is
/// none.
std::size_t chain_length(std::span<const Shape> shapes, std::size_t first);

/// True if such a chain, of three segments or more, ends where it began.
bool is_loop(std::span<const Shape> chain);

}  // namespace mes::figure
