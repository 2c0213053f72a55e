// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/structures/axis/medial_axis.h"
#include "core/layers/parts/helpers.h"

namespace mes {

Layer make_medial_axis_layer(const StructureSet& set) {
  const auto& delaunay = set.get<Delaunay>();
  const auto& crust = set.get<OneStepCrust>();
  const auto& axis = set.get<MedialAxis>();
  return make_layer(
      {.id = "medial-axis",
       .name = "Medial axis",
       .tooltip = "Voronoi edges joining two inside Voronoi vertices: the medial axis of the union of inner balls",
       .group = LayerGroup::crust_axis,
       .in_paper = true,
       .visible_at_start = true,
       .scalar = "lambda",
       .style = {.color = palette::vermilion, .line_width_px = 2.5},
       .kinds = {PrimitiveKind::segment}},
      {&delaunay, &crust, &axis},
      edges_part({PrimitiveKind::segment}, delaunay, axis.edge_changes(), [&](EdgeSlot edge, Instance& out) {
        if (axis.is_axis_edge(edge))
          emit_dual(delaunay, crust, edge, out, out.wants_scalar() ? contact_spread(delaunay, edge) : 0.0);
      }));
}

}  // namespace mes
