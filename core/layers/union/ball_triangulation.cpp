// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/layers/parts/family.h"

namespace mes {

Layer make_union_ball_triangulation_layer(const UnionFamily& family) {
  const PowerDiagram& diagram = family.power_diagram;
  return union_layer_of(
      family, diagram,
      {.id = "ball-triangulation",
       .name = "regular triangulation",
       .tooltip = "Regular triangulation of the balls",
       .in_paper = true,
       .style = {.color = palette::grey, .opacity = 0.6},
       .kinds = {PrimitiveKind::segment}},
      power_part({PrimitiveKind::segment}, diagram,
                 [&diagram](const PowerEdge& edge, Instance& out) { emit_centers(diagram, edge, out); }));
}

}  // namespace mes
