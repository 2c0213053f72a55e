// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/layers/parts/helpers.h"

namespace mes {

Layer make_delaunay_layer(const StructureSet& set) {
  const auto& delaunay = set.get<Delaunay>();
  return make_layer({.id = "delaunay",
                     .name = "Delaunay",
                     .tooltip = "Edges of the Delaunay triangulation of the samples",
                     .group = LayerGroup::delaunay_voronoi,
                     .in_paper = true,
                     .style = {.color = palette::grey, .opacity = 0.6},
                     .kinds = {PrimitiveKind::segment}},
                    {&delaunay},
                    edges_part({PrimitiveKind::segment}, delaunay, delaunay.edge_changes(),
                               [&delaunay](EdgeSlot edge, Instance& out) { emit_edge(delaunay, edge, out); }));
}

}  // namespace mes
