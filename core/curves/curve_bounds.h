// SPDX-License-Identifier: GPL-3.0-or-later
// The smallest boxes around pieces of curves and around curves, and whether they overlap.
#pragma once

#include <span>

#include "core/base/geometry/box2.h"
#include "core/curves/curve.h"

namespace mes {

/// O(1). Up to rounding.
Box2 bounds_of(const Piece& piece);
/// Empty for no curves. O(pieces).
Box2 bounds_of(std::span<const PlaneCurve> curves);

}  // namespace mes
