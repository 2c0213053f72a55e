// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/layers/parts/helpers.h"
#include "core/structures/density/feature_size.h"

namespace mes {

Layer make_sampling_epsilon_layer(const StructureSet& set) {
  const auto& delaunay = set.get<Delaunay>();
  const auto& sizes = set.get<FeatureSize>();
  return make_layer(
      {.id = "sampling-epsilon",
       .name = "Sampling epsilon",
       .tooltip =
           "Curve edges by half their length divided by the feature size at their ends; above 0.25 the samples "
           "are sparse",
       .group = LayerGroup::crust_axis,
       .scalar = "epsilon",
       .style = {.color = palette::blue, .line_width_px = 4.0, .color_map = "inferno"},
       .kinds = {PrimitiveKind::segment}},
      {&delaunay, &sizes},
      edges_part({PrimitiveKind::segment}, delaunay, sizes.edge_changes(), [&](EdgeSlot edge, Instance& out) {
        if (sizes.has_epsilon(edge)) emit_edge(delaunay, edge, out, sizes.epsilon(edge));
      }));
}

}  // namespace mes
