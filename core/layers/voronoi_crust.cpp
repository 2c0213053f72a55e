// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/layers/parts/helpers.h"
#include "core/structures/crust/labels.h"

namespace mes {

Layer make_voronoi_crust_layer(const StructureSet& set) {
  const auto& delaunay = set.get<Delaunay>();
  const auto& labels = set.get<Labels>();
  return make_layer(
      {.id = "voronoi-crust",
       .name = "Voronoi crust",
       .tooltip = "Delaunay edges between an inside and an outside Voronoi vertex",
       .group = LayerGroup::crust_axis,
       .in_paper = true,
       .style = {.color = palette::blue, .opacity = 0.8, .line_width_px = 2},
       .kinds = {PrimitiveKind::segment}},
      {&delaunay, &labels},
      edges_part({PrimitiveKind::segment}, delaunay, labels.edge_changes(), [&](EdgeSlot edge, Instance& out) {
        const EdgeRow& row = delaunay.edge(edge);
        if (row.f[0] == kNoSlot) return;
        if (labels.is_inside(row.f[0]) != labels.is_inside(row.f[1])) emit_edge(delaunay, edge, out);
      }));
}

}  // namespace mes
