// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/layers/parts/helpers.h"

namespace mes {

Layer make_curve_layer(const StructureSet& set) {
  const auto& delaunay = set.get<Delaunay>();
  const auto& crust = set.get<OneStepCrust>();
  return make_layer(
      {.id = "curve",
       .name = "Curve",
       .tooltip = "Delaunay edges accepted by the one-step crust test",
       .group = LayerGroup::crust_axis,
       .data = LayerData::curve,
       .visible_at_start = true,
       .scalar = "confidence",
       .style = {.color = palette::blue, .line_width_px = 2},
       .kinds = {PrimitiveKind::segment}},
      {&delaunay, &crust},
      edges_part({PrimitiveKind::segment}, delaunay, delaunay.edge_changes(), [&](EdgeSlot edge, Instance& out) {
        if (crust.is_crust(edge)) emit_edge(delaunay, edge, out, out.wants_scalar() ? crust.confidence(edge) : 0.0);
      }));
}

}  // namespace mes
