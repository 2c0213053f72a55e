// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/layers/parts/family.h"

namespace mes {

Layer make_union_v_voronoi_layer(const UnionFamily& family) {
  const VDiagram& diagram = family.v_diagram;
  return union_layer_of(
      family, diagram,
      {.id = "v-voronoi",
       .name = "v-point Voronoi diagram",
       .tooltip = "Voronoi diagram of the v-points",
       .in_paper = true,
       .in_fit_box = false,
       .style = {.color = palette::sky, .opacity = 0.7},
       .kinds = {PrimitiveKind::line, PrimitiveKind::ray, PrimitiveKind::segment}},
      v_part({PrimitiveKind::line, PrimitiveKind::ray, PrimitiveKind::segment}, diagram, &UnionTables::v_edges,
             [&diagram](const VEdge& edge, Instance& out) { emit_v_dual(diagram.tables(), edge, out); }));
}

}  // namespace mes
