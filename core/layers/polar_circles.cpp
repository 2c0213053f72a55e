// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/layers/parts/helpers.h"
#include "core/structures/poles/poles.h"

namespace mes {

Layer make_polar_circles_layer(const StructureSet& set) {
  const auto& delaunay = set.get<Delaunay>();
  const auto& poles = set.get<Poles>();
  return make_layer(
      {.id = "polar-circles",
       .name = "Polar circles",
       .tooltip = "Circles of all poles",
       .group = LayerGroup::poles,
       .in_fit_box = false,
       .scalar = "radius",
       .style = {.color = palette::purple, .opacity = 0.4},
       .kinds = {PrimitiveKind::circle}},
      {&delaunay, &poles},
      faces_part({PrimitiveKind::circle}, delaunay, poles.face_changes(), [&](Slot face, Instance& out) {
        if (poles.is_pole(face))
          out.circle(delaunay.circumcenter(face), delaunay.circumradius(face), delaunay.circumradius(face));
      }));
}

}  // namespace mes
