// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/structures/density/feature_size.h"
#include "core/layers/parts/helpers.h"

namespace mes {

Layer make_feature_size_layer(const StructureSet& set) {
  const auto& delaunay = set.get<Delaunay>();
  const auto& sizes = set.get<FeatureSize>();
  return make_layer(
      {.id = "feature-size",
       .name = "Feature size",
       .tooltip = "Samples with their distance to the axis on both sides, which estimates the local "
                  "feature size",
       .group = LayerGroup::samples,
       .scalar = "local feature size",
       .style = {.color = palette::black, .point_size_px = 7, .color_map = "cividis"},
       .kinds = {PrimitiveKind::point}},
      {&delaunay, &sizes},
      sites_part({PrimitiveKind::point}, delaunay, sizes.site_changes(), [&](SiteSlot site, Instance& out) {
        if (sizes.has_size(site)) out.point(delaunay.site_position(site), sizes.size(site));
      }));
}

}  // namespace mes
