// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/layers/parts/helpers.h"

namespace mes {
Layer make_voronoi_disks_layer(const StructureSet& set) {
  const auto& delaunay = set.get<Delaunay>();
  return make_layer(
      {.id = "voronoi-disks",
       .name = "Voronoi disks",
       .tooltip = "Circumdisks of all Delaunay triangles",
       .group = LayerGroup::delaunay_voronoi,
       .in_fit_box = false,
       .scalar = "radius",
       .style = {.color = palette::grey, .opacity = 0.1},
       .kinds = {PrimitiveKind::disk}},
      {&delaunay},
      faces_part({PrimitiveKind::disk}, delaunay, delaunay.face_changes(), [&](Slot face, Instance& out) {
        out.disk(delaunay.circumcenter(face), delaunay.circumradius(face), delaunay.circumradius(face));
      }));
}

}  // namespace mes
