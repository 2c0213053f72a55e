// SPDX-License-Identifier: GPL-3.0-or-later
// Angles that have the same bits on each machine. The functions of C libraries differ in the last bit from one library
// to another, and those of glibc between processors with and without fused multiplication.
#pragma once

#include "core/base/geometry/vec2.h"

namespace mes {

/// The angle from the positive x axis to a finite vector in radians, in [-pi, pi]: `std::atan2(v.y, v.x)` within four
/// units in the last place. Halves and quarters of turns, and eighths of vectors with |x| = |y|, are those of `atan2`.
double angle_of(Vec2 v);

}  // namespace mes
