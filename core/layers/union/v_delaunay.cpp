// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/layers/parts/family.h"

namespace mes {

Layer make_union_v_delaunay_layer(const UnionFamily& family) {
  const VDiagram& diagram = family.v_diagram;
  return union_layer_of(
      family, diagram,
      {.id = "v-delaunay",
       .name = "v-point Delaunay triangulation",
       .tooltip = "Delaunay triangulation of the v-points",
       .style = {.color = palette::grey, .opacity = 0.6},
       .kinds = {PrimitiveKind::segment}},
      v_part({PrimitiveKind::segment}, diagram, &UnionTables::v_edges, [&diagram](const VEdge& edge, Instance& out) {
        const auto& points = diagram.tables().v_points;
        out.segment(points[edge.v[0]].position, points[edge.v[1]].position);
      }));
}

}  // namespace mes
