// SPDX-License-Identifier: GPL-3.0-or-later
// To how many decimals coordinates were rounded.
#pragma once

#include <span>

#include "core/base/vec2.h"

namespace mes {

/// The largest power of ten from 1 down to 1e-9 of which all coordinates are multiples, up to what rounding to doubles
/// does; 0 where there is none, as for numbers that were computed. O(n).
///
/// Smallest use:
///     curves.resolution = resolution_of(curve.points());
double resolution_of(std::span<const Vec2> points);

}  // namespace mes
