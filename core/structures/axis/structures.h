// SPDX-License-Identifier: GPL-3.0-or-later
// Registers the structures of this room, one line each, inputs before consumers.
#pragma once

#include "core/graph/registry.h"
#include "core/structures/axis/axis_nodes.h"
#include "core/structures/axis/inner_balls.h"
#include "core/structures/axis/medial_axis.h"
#include "core/structures/crust/labels.h"
#include "core/structures/crust/one_step_crust.h"
#include "core/structures/crust/voronoi_vertices.h"
#include "core/structures/delaunay/delaunay.h"

namespace mes {

/// Call after the rooms that this one uses.
inline void add_axis_structures(Registry& registry) {
  registry.add_structure<InnerBalls, Delaunay, VoronoiVertices, Labels>();
  registry.add_structure<MedialAxis, Delaunay, OneStepCrust, Labels, InnerBalls>();
  registry.add_structure<AxisNodes, Delaunay, InnerBalls, MedialAxis>();
}

}  // namespace mes
