// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/layers/parts/family.h"
#include "core/structures/poles/polar_diagram.h"

namespace mes {

Layer make_polar_power_diagram_layer(const StructureSet& set) {
  const auto& diagram = set.get<PolarDiagram>();
  return make_layer({.id = "polar-power-diagram",
                     .name = "Polar power diagram",
                     .tooltip = "Power diagram of all polar balls, with half planes for the poles at infinity",
                     .group = LayerGroup::poles,
                     .in_paper = true,
                     .in_fit_box = false,
                     .style = {.color = palette::sky, .opacity = 0.5},
                     .kinds = {PrimitiveKind::line, PrimitiveKind::ray, PrimitiveKind::segment}},
                    {&diagram},
                    power_part({PrimitiveKind::line, PrimitiveKind::ray, PrimitiveKind::segment}, diagram,
                               [&diagram](const PowerEdge& edge, Instance& out) {
                                 if (!diagram.is_at_infinity(edge.ball[0]) || !diagram.is_at_infinity(edge.ball[1]))
                                   emit_power_edge(edge, out);
                               }));
}

}  // namespace mes
