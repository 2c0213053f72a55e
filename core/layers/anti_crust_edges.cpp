// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/layers/parts/family.h"
#include "core/structures/poles/polar_diagram.h"

namespace mes {

Layer make_anti_crust_edges_layer(const StructureSet& set) {
  const auto& crust = set.get<PowerCrust>();
  const auto& diagram = crust.diagram();
  return make_layer(
      {.id = "anti-crust-edges",
       .name = "Anti crust edges",
       .tooltip = "Edges of the polar triangulation whose dual is not in the power crust",
       .group = LayerGroup::poles,
       .in_fit_box = false,
       .style = {.color = palette::green, .opacity = 0.6},
       .kinds = {PrimitiveKind::segment}},
      {&crust, &diagram},
      table_part(
          {PrimitiveKind::segment}, [&diagram] { return diagram.edges().size(); }, crust.changes(),
          [&](PowerEdgeSlot row, Instance& out) {
            const PowerEdge& edge = diagram.edges()[row];
            if (crust.is_crust(row) || diagram.is_at_infinity(edge.ball[0]) || diagram.is_at_infinity(edge.ball[1]))
              return;
            emit_centers(diagram, edge, out);
          },
          ElementType{ElementKind::power_edge, &diagram}));
}

}  // namespace mes
