// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/layers/parts/helpers.h"
#include "core/structures/poles/poles.h"

namespace mes {

Layer make_polar_disks_layer(const StructureSet& set) {
  const auto& delaunay = set.get<Delaunay>();
  const auto& poles = set.get<Poles>();
  return make_layer({.id = "polar-disks",
                     .name = "Polar disks",
                     .tooltip = "Disks of all poles",
                     .group = LayerGroup::poles,
                     .in_fit_box = false,
                     .scalar = "radius",
                     .style = {.color = palette::purple, .opacity = 0.1},
                     .kinds = {PrimitiveKind::disk}},
                    {&delaunay, &poles},
                    faces_part({PrimitiveKind::disk}, delaunay, poles.face_changes(), [&](Slot face, Instance& out) {
                      if (poles.is_pole(face))
                        out.disk(delaunay.circumcenter(face), delaunay.circumradius(face),
                                 delaunay.circumradius(face));
                    }));
}

}  // namespace mes
