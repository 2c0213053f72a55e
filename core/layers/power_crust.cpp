// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/layers/parts/family.h"
#include "core/structures/poles/polar_diagram.h"

namespace mes {

Layer make_power_crust_layer(const StructureSet& set) {
  const auto& crust = set.get<PowerCrust>();
  const auto& diagram = crust.diagram();
  return make_layer({.id = "power-crust",
                     .name = "Power crust",
                     .tooltip = "Edges of the polar power diagram between inner and outer poles",
                     .group = LayerGroup::poles,
                     .in_paper = true,
                     .style = {.color = palette::blue, .line_width_px = 2},
                     .kinds = {PrimitiveKind::line, PrimitiveKind::ray, PrimitiveKind::segment}},
                    {&crust, &diagram},
                    table_part(
                        {PrimitiveKind::line, PrimitiveKind::ray, PrimitiveKind::segment},
                        [&diagram] { return diagram.edges().size(); }, crust.changes(),
                        [&](PowerEdgeSlot edge, Instance& out) {
                          if (crust.is_crust(edge)) emit_power_edge(diagram.edges()[edge], out);
                        },
                        ElementType{ElementKind::power_edge, &diagram}));
}

}  // namespace mes
