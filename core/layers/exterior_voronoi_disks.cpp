// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/layers/parts/helpers.h"
#include "core/structures/crust/labels.h"

namespace mes {
Layer make_exterior_voronoi_disks_layer(const StructureSet& set) {
  const auto& delaunay = set.get<Delaunay>();
  const auto& labels = set.get<Labels>();
  return make_layer({.id = "exterior-voronoi-disks",
                     .name = "Exterior Voronoi disks",
                     .tooltip = "Disks of triangles not labelled inside",
                     .group = LayerGroup::crust_axis,
                     .in_fit_box = false,
                     .scalar = "radius",
                     .style = {.color = palette::sky, .opacity = 0.1},
                     .kinds = {PrimitiveKind::disk}},
                    {&delaunay, &labels},
                    faces_part({PrimitiveKind::disk}, delaunay, labels.face_changes(), [&](Slot face, Instance& out) {
                      if (!labels.is_inside(face))
                        out.disk(delaunay.circumcenter(face), delaunay.circumradius(face),
                                 delaunay.circumradius(face));
                    }));
}

}  // namespace mes
