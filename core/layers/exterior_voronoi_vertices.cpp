// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/layers/parts/helpers.h"
#include "core/structures/crust/labels.h"

namespace mes {
Layer make_exterior_voronoi_vertices_layer(const StructureSet& set) {
  const auto& delaunay = set.get<Delaunay>();
  const auto& labels = set.get<Labels>();
  return make_layer(
      {.id = "exterior-voronoi-vertices",
       .name = "Exterior Voronoi vertices",
       .tooltip = "Centres of the outside circumcircles",
       .group = LayerGroup::crust_axis,
       .in_fit_box = false,
       .scalar = "radius",
       .style = {.color = palette::sky, .point_size_px = 4},
       .kinds = {PrimitiveKind::point}},
      {&delaunay, &labels},
      faces_part({PrimitiveKind::point}, delaunay, labels.face_changes(), [&](Slot face, Instance& out) {
        if (!labels.is_inside(face)) out.point(delaunay.circumcenter(face), delaunay.circumradius(face));
      }));
}

}  // namespace mes
