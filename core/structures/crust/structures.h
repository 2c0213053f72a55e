// SPDX-License-Identifier: GPL-3.0-or-later
// Registers the structures of this room, one line each, inputs before consumers.
#pragma once

#include "core/graph/registry.h"
#include "core/structures/crust/curve.h"
#include "core/structures/crust/labels.h"
#include "core/structures/crust/one_step_crust.h"
#include "core/structures/crust/voronoi_vertices.h"
#include "core/structures/delaunay/delaunay.h"
#include "core/structures/inputs/shared_borders.h"

namespace mes {

/// Call after the rooms that this one uses.
inline void add_crust_structures(Registry& registry) {
  registry.add_structure<OneStepCrust, Delaunay, SharedBorders>();
  registry.add_structure<Labels, Delaunay, OneStepCrust>();
  registry.add_structure<Curve, Delaunay, OneStepCrust, Labels>();
  registry.add_structure<VoronoiVertices, Delaunay, OneStepCrust>();
}

}  // namespace mes
