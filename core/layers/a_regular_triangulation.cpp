// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/layers/parts/family.h"
#include "core/structures/balls/ball_diagrams.h"

namespace mes {

Layer make_a_regular_triangulation_layer(const StructureSet& set) {
  const auto& diagram = set.get<VoronoiBallDiagram>();
  return make_layer({.id = "a-regular-triangulation",
                     .name = "Regular triangulation of the Voronoi balls",
                     .tooltip = "Regular triangulation of all finite Voronoi balls",
                     .group = LayerGroup::delaunay_voronoi,
                     .in_paper = true,
                     .in_fit_box = false,
                     .style = {.color = palette::grey, .opacity = 0.6},
                     .kinds = {PrimitiveKind::segment}},
                    {&diagram},
                    power_part({PrimitiveKind::segment}, diagram, [&diagram](const PowerEdge& edge, Instance& out) {
                      emit_centers(diagram, edge, out);
                    }));
}

}  // namespace mes
