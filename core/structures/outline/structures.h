// SPDX-License-Identifier: GPL-3.0-or-later
// Registers the structures of this room, one line each, inputs before consumers.
#pragma once

#include "core/graph/registry.h"
#include "core/structures/outline/axis_deviation.h"
#include "core/structures/outline/outline_axis.h"

namespace mes {

/// Call after the rooms that this one uses.
inline void add_outline_structures(Registry& registry) {
  registry.add_structure<OutlineAxis, CurveSourceInput, Samples, Contours>();
  registry.add_structure<AxisDeviation, Delaunay, MedialAxis, OutlineAxis>();
}

}  // namespace mes
