// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/layers/parts/helpers.h"

namespace mes {

Layer make_curve_defects_layer(const StructureSet& set) {
  const auto& delaunay = set.get<Delaunay>();
  const auto& crust = set.get<OneStepCrust>();
  return make_layer(
      {.id = "curve-defects",
       .name = "Curve defects",
       .tooltip = "Samples with crust degree other than two",
       .group = LayerGroup::diagnostics,
       .scalar = "degree",
       .style = {.color = palette::vermilion, .point_size_px = 9},
       .kinds = {PrimitiveKind::point}},
      {&delaunay, &crust},
      sites_part({PrimitiveKind::point}, delaunay, crust.site_changes(), [&](SiteSlot site, Instance& out) {
        if (crust.degree(site) != 2) out.point(delaunay.site_position(site), crust.degree(site));
      }));
}

}  // namespace mes
