// SPDX-License-Identifier: GPL-3.0-or-later
// What a triangulation of points or balls is indexed by; without CGAL.
#pragma once

#include "core/base/slot.h"

namespace mes {

/// Position of a point, or of a ball, in the input of a triangulation.
using InputSlot = Slot<struct InputTag>;
/// A finite triangle of it, or one outside a hull edge where there are such.
using TriangleSlot = Slot<struct TriangleTag>;

}  // namespace mes
