// SPDX-License-Identifier: GPL-3.0-or-later
// Indices of a triangulation of points or balls; without CGAL.
#pragma once

#include "core/base/slot.h"

namespace mes {

/// Position of a point, or of a ball, in the input of a triangulation.
using InputSlot = Slot<struct InputTag>;
/// A finite triangle of the triangulation, or one outside a hull edge where such triangles exist.
using TriangleSlot = Slot<struct TriangleTag>;

}  // namespace mes
