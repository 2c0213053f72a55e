// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/layers/parts/helpers.h"
#include "core/structures/crust/curve.h"

namespace mes {

// Normals are twice as long as the spacing of the samples, so that they stay distinguishable at any density.
Layer make_curve_normals_layer(const StructureSet& set) {
  const auto& delaunay = set.get<Delaunay>();
  const auto& curve = set.get<Curve>();
  return make_layer(
      {.id = "curve-normals",
       .name = "Curve normals",
       .tooltip = "Normal vector at every ordered curve sample",
       .group = LayerGroup::crust_axis,
       .data = LayerData::curve_normals,
       .style = {.color = palette::blue, .opacity = 0.6},
       .kinds = {PrimitiveKind::segment}},
      {&delaunay, &curve},
      sites_part({PrimitiveKind::segment}, delaunay, curve.site_changes(), [&](SiteSlot site, Instance& out) {
        if (!curve.has_normal(site)) return;
        const Vec2 p = delaunay.site_position(site);
        out.segment(p, p + 2.0 * curve.spacing(site) * curve.normal(site));
      }));
}

}  // namespace mes
