// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/layers/parts/helpers.h"

namespace mes {

Layer make_voronoi_layer(const StructureSet& set) {
  const auto& delaunay = set.get<Delaunay>();
  const auto& crust = set.get<OneStepCrust>();
  return make_layer(
      {.id = "voronoi",
       .name = "Voronoi",
       .tooltip = "Edges of the Voronoi diagram of the samples",
       .group = LayerGroup::delaunay_voronoi,
       .in_paper = true,
       .in_fit_box = false,
       .style = {.color = palette::sky, .opacity = 0.8},
       .kinds = {PrimitiveKind::segment, PrimitiveKind::ray, PrimitiveKind::line}},
      {&delaunay, &crust},
      edges_part({PrimitiveKind::segment, PrimitiveKind::ray, PrimitiveKind::line}, delaunay, delaunay.edge_changes(),
                 [&](EdgeSlot edge, Instance& out) { emit_dual(delaunay, crust, edge, out); }));
}

}  // namespace mes
