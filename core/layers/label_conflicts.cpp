// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/layers/parts/helpers.h"
#include "core/structures/crust/labels.h"

namespace mes {

Layer make_label_conflicts_layer(const StructureSet& set) {
  const auto& delaunay = set.get<Delaunay>();
  const auto& crust = set.get<OneStepCrust>();
  const auto& labels = set.get<Labels>();
  return make_layer(
      {.id = "label-conflicts",
       .name = "Label conflicts",
       .tooltip = "Edges whose two labels contradict their crust bit",
       .group = LayerGroup::diagnostics,
       .scalar = "confidence",
       .style = {.color = palette::vermilion, .line_width_px = 4, .dashed = true},
       .kinds = {PrimitiveKind::segment}},
      {&delaunay, &crust, &labels},
      edges_part({PrimitiveKind::segment}, delaunay, labels.edge_changes(), [&](EdgeSlot edge, Instance& out) {
        if (labels.is_conflict(edge)) emit_edge(delaunay, edge, out, crust.confidence(edge));
      }));
}

}  // namespace mes
