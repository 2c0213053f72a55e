// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/layers/parts/family.h"
#include "core/structures/poles/polar_diagram.h"

namespace mes {

Layer make_polar_triangulation_layer(const StructureSet& set) {
  const auto& diagram = set.get<PolarDiagram>();
  return make_layer({.id = "polar-triangulation",
                     .name = "Polar triangulation",
                     .tooltip = "Regular triangulation of all polar balls",
                     .group = LayerGroup::poles,
                     .in_paper = true,
                     .in_fit_box = false,
                     .style = {.color = palette::grey, .opacity = 0.5},
                     .kinds = {PrimitiveKind::segment}},
                    {&diagram},
                    power_part({PrimitiveKind::segment}, diagram, [&diagram](const PowerEdge& edge, Instance& out) {
                      if (diagram.is_at_infinity(edge.ball[0]) || diagram.is_at_infinity(edge.ball[1])) return;
                      emit_centers(diagram, edge, out);
                    }));
}

}  // namespace mes
