// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/layers/parts/helpers.h"
#include "core/structures/crust/labels.h"

namespace mes {
Layer make_exterior_voronoi_circles_layer(const StructureSet& set) {
  const auto& delaunay = set.get<Delaunay>();
  const auto& labels = set.get<Labels>();
  return make_layer(
      {.id = "exterior-voronoi-circles",
       .name = "Exterior Voronoi circles",
       .tooltip = "Circumcircles of triangles not labelled inside",
       .group = LayerGroup::crust_axis,
       .in_fit_box = false,
       .scalar = "radius",
       .style = {.color = palette::sky, .opacity = 0.4, .dashed = true},
       .kinds = {PrimitiveKind::circle}},
      {&delaunay, &labels},
      faces_part({PrimitiveKind::circle}, delaunay, labels.face_changes(), [&](Slot face, Instance& out) {
        if (!labels.is_inside(face))
          out.circle(delaunay.circumcenter(face), delaunay.circumradius(face), delaunay.circumradius(face));
      }));
}

}  // namespace mes
