// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/layers/parts/helpers.h"

namespace mes {
Layer make_voronoi_circles_layer(const StructureSet& set) {
  const auto& delaunay = set.get<Delaunay>();
  return make_layer(
      {.id = "voronoi-circles",
       .name = "Voronoi circles",
       .tooltip = "Circumcircles of all Delaunay triangles",
       .group = LayerGroup::delaunay_voronoi,
       .in_fit_box = false,
       .scalar = "radius",
       .style = {.color = palette::grey, .opacity = 0.4},
       .kinds = {PrimitiveKind::circle}},
      {&delaunay},
      faces_part({PrimitiveKind::circle}, delaunay, delaunay.face_changes(), [&](Slot face, Instance& out) {
        out.circle(delaunay.circumcenter(face), delaunay.circumradius(face), delaunay.circumradius(face));
      }));
}

}  // namespace mes
