// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/layers/parts/family.h"

namespace mes {

Layer make_union_power_diagram_layer(const UnionFamily& family) {
  const PowerDiagram& diagram = family.power_diagram;
  return union_layer_of(family, diagram,
                        {.id = "ball-power-diagram",
                         .name = "power diagram",
                         .tooltip = "Power diagram of the balls",
                         .in_fit_box = false,
                         .style = {.color = palette::sky, .opacity = 0.6},
                         .kinds = {PrimitiveKind::line, PrimitiveKind::ray, PrimitiveKind::segment}},
                        power_part({PrimitiveKind::line, PrimitiveKind::ray, PrimitiveKind::segment}, diagram,
                                   [](const PowerEdge& edge, Instance& out) { emit_power_edge(edge, out); }));
}

}  // namespace mes
