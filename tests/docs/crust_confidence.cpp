// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/layers/parts/helpers.h"

namespace mes {

Layer make_crust_confidence_layer(const StructureSet& set) {
  const auto& delaunay = set.get<Delaunay>();
  const auto& crust = set.get<OneStepCrust>();
  return make_layer(
      {.id = "crust-confidence",
       .name = "Crust confidence",
       .tooltip = "Curve edges, with the cosine of alpha + beta as scalar: 0 is a tie, 1 is certain",
       .group = LayerGroup::diagnostics,
       .scalar = "confidence",
       .style = {.color = palette::green, .line_width_px = 4.0},
       .kinds = {PrimitiveKind::segment}},
      {&delaunay, &crust},
      edges_part({PrimitiveKind::segment}, delaunay, delaunay.edge_changes(), [&](EdgeSlot edge, Instance& out) {
        if (crust.is_crust(edge)) emit_edge(delaunay, edge, out, crust.confidence(edge));
      }));
}

}  // namespace mes
