// SPDX-License-Identifier: GPL-3.0-or-later
// What one layer draws and another does not.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/draw/primitives.h"

namespace mes {

/// The instances of `a`, by number, that have no counterpart in `b`: an instance whose coordinates and radii are the same
/// up to `tolerance`, whichever end of a segment, corner of a triangle or sign of a line's direction comes first. Scalars
/// do not count, nor how often an instance is there; the points that lines pass through are compared as they are. Both
/// hold `stride_of(kind)` doubles an instance; `tolerance` is in units of the document and positive.
///
/// Cost: O(size of both), where few instances lie within a tolerance of each other. Threads: any.
std::vector<std::uint32_t> without_counterpart(PrimitiveKind kind, std::span<const double> a,
                                               std::span<const double> b, double tolerance);

}  // namespace mes
