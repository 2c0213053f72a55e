// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/layers/parts/helpers.h"

namespace mes {

Layer make_all_medial_axis_layer(const StructureSet& set) {
  const auto& delaunay = set.get<Delaunay>();
  const auto& crust = set.get<OneStepCrust>();
  return make_layer({.id = "all-medial-axis",
                     .name = "All medial axis",
                     .tooltip = "Duals of all non-crust Delaunay edges, inside and outside",
                     .group = LayerGroup::crust_axis,
                     .in_fit_box = false,
                     .scalar = "lambda",
                     .style = {.color = palette::vermilion, .opacity = 0.5},
                     .kinds = {PrimitiveKind::segment, PrimitiveKind::ray, PrimitiveKind::line}},
                    {&delaunay, &crust},
                    edges_part({PrimitiveKind::segment, PrimitiveKind::ray, PrimitiveKind::line}, delaunay,
                               delaunay.edge_changes(), [&](EdgeSlot edge, Instance& out) {
                                 if (!crust.is_crust(edge))
                                   emit_dual(delaunay, crust, edge, out, contact_spread(delaunay, edge));
                               }));
}

}  // namespace mes
