// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/structures/axis/axis_nodes.h"
#include "core/layers/parts/helpers.h"

namespace mes {

Layer make_axis_nodes_layer(const StructureSet& set) {
  const auto& delaunay = set.get<Delaunay>();
  const auto& axis = set.get<MedialAxis>();
  const auto& nodes = set.get<AxisNodes>();
  return make_layer({.id = "axis-nodes",
                     .name = "Axis nodes",
                     .tooltip = "Leaves and branch points of the medial axis",
                     .group = LayerGroup::diagnostics,
                     .scalar = "degree",
                     .style = {.color = palette::vermilion, .point_size_px = 6},
                     .kinds = {PrimitiveKind::point}},
                    {&delaunay, &axis, &nodes},
                    faces_part({PrimitiveKind::point}, delaunay, nodes.changes(), [&](FaceSlot face, Instance& out) {
                      if (axis.is_node(face) && axis.node_degree(face) != 2)
                        out.point(delaunay.circumcenter(face), axis.node_degree(face));
                    }));
}

}  // namespace mes
