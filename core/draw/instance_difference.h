// SPDX-License-Identifier: GPL-3.0-or-later
// Finds the instances of one layer that another layer does not have.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/draw/primitives.h"

namespace mes {

/// The indices of instances of `a` without counterpart in `b`. Counterparts have the same coordinates and radii up to
/// `tolerance`, regardless of the order of a segment's ends or a triangle's corners, or the sign of a line's direction.
/// Scalars and multiplicities do not count; the points that lines pass through are compared as they are. Both hold
/// `stride_of(kind)` doubles for each instance; `tolerance` is in units of the document and positive.
///
/// Cost: O(size of both) if few instances lie within a tolerance of each other. Threads: any.
std::vector<std::uint32_t> without_counterpart(PrimitiveKind kind, std::span<const double> a,
                                               std::span<const double> b, double tolerance);

}  // namespace mes
