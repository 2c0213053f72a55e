// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/layers/parts/family.h"

namespace mes {

Layer make_union_v_alpha_edges_layer(const UnionFamily& family) {
  const VDiagram& diagram = family.v_diagram;
  return union_layer_of(family, diagram,
                        {.id = "v-alpha-edges",
                         .name = "v-point alpha edges",
                         .tooltip = "Voronoi edges of the v-points that run along a singular dual edge",
                         .in_paper = true,
                         .in_fit_box = false,
                         .style = {.color = palette::yellow, .line_width_px = 3},
                         .kinds = {PrimitiveKind::line, PrimitiveKind::ray, PrimitiveKind::segment}},
                        v_part({PrimitiveKind::line, PrimitiveKind::ray, PrimitiveKind::segment}, diagram,
                               &UnionTables::v_edges, [&diagram](const VEdge& edge, Instance& out) {
                                 if (edge.kind == VEdgeKind::alpha) emit_v_dual(diagram.tables(), edge, out);
                               }));
}

}  // namespace mes
