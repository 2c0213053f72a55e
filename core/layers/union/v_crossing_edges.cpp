// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/layers/parts/family.h"

namespace mes {

Layer make_union_v_crossing_edges_layer(const UnionFamily& family) {
  const VDiagram& diagram = family.v_diagram;
  return union_layer_of(family, diagram,
                        {.id = "v-crossing-edges",
                         .name = "v-point crossing edges",
                         .tooltip = "Voronoi edges of the v-points that pass a boundary vertex of the dual complex",
                         .in_paper = true,
                         .in_fit_box = false,
                         .style = {.color = palette::green, .line_width_px = 2},
                         .kinds = {PrimitiveKind::line, PrimitiveKind::ray, PrimitiveKind::segment}},
                        v_part({PrimitiveKind::line, PrimitiveKind::ray, PrimitiveKind::segment}, diagram,
                               &UnionTables::v_edges, [&diagram](const VEdge& edge, Instance& out) {
                                 if (edge.kind == VEdgeKind::crossing) emit_v_dual(diagram.tables(), edge, out);
                               }));
}

}  // namespace mes
