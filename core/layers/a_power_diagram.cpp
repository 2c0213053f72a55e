// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/layers/parts/family.h"
#include "core/structures/balls/ball_diagrams.h"

namespace mes {

Layer make_a_power_diagram_layer(const StructureSet& set) {
  const auto& diagram = set.get<VoronoiBallDiagram>();
  return make_layer({.id = "a-power-diagram",
                     .name = "Power diagram of the Voronoi balls",
                     .tooltip = "Power diagram of all finite Voronoi balls",
                     .group = LayerGroup::delaunay_voronoi,
                     .in_paper = true,
                     .in_fit_box = false,
                     .style = {.color = palette::sky, .opacity = 0.6},
                     .kinds = {PrimitiveKind::line, PrimitiveKind::ray, PrimitiveKind::segment}},
                    {&diagram},
                    power_part({PrimitiveKind::line, PrimitiveKind::ray, PrimitiveKind::segment}, diagram,
                               [](const PowerEdge& edge, Instance& out) { emit_power_edge(edge, out); }));
}

}  // namespace mes
