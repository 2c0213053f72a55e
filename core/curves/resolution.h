// SPDX-License-Identifier: GPL-3.0-or-later
// Finds the number of decimals that coordinates were rounded to.
#pragma once

#include <span>

#include "core/base/geometry/vec2.h"

namespace mes {

/// The largest power of ten from 1 down to 1e-9 that divides all coordinates, up to rounding to doubles. Returns 0 if
/// no such power exists, as for computed numbers. O(n).
///
/// Smallest use:
///     curves.resolution = resolution_of(curve.points());
double resolution_of(std::span<const Vec2> points);

}  // namespace mes
