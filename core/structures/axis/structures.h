// SPDX-License-Identifier: GPL-3.0-or-later
// The structures of this room, a line each, inputs before consumers.
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

/// After the rooms that it uses.
inline void add_axis_structures(Registry& registry) {
  registry.add_structure<InnerBalls, Delaunay, VoronoiVertices, Labels>();
  registry.add_structure<MedialAxis, Delaunay, OneStepCrust, Labels, InnerBalls>();
  registry.add_structure<AxisNodes, Delaunay, InnerBalls, MedialAxis>();
}

}  // namespace mes
