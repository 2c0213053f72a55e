// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/layers/parts/helpers.h"
#include "core/structures/poles/pole_labels.h"

namespace mes {

Layer make_exterior_polar_circles_layer(const StructureSet& set) {
  const auto& delaunay = set.get<Delaunay>();
  const auto& poles = set.get<Poles>();
  const auto& labels = set.get<PoleLabels>();
  return make_layer({.id = "exterior-polar-circles",
                     .name = "Exterior polar circles",
                     .tooltip = "Circles of poles not labelled inside",
                     .group = LayerGroup::poles,
                     .in_fit_box = false,
                     .scalar = "radius",
                     .style = {.color = palette::sky, .opacity = 0.4},
                     .kinds = {PrimitiveKind::circle}},
                    {&delaunay, &poles, &labels},
                    faces_part({PrimitiveKind::circle}, delaunay, labels.changes(), [&](Slot face, Instance& out) {
                      if (poles.is_pole(face) && !labels.is_inside(face))
                        out.circle(delaunay.circumcenter(face), delaunay.circumradius(face),
                                   delaunay.circumradius(face));
                    }));
}

}  // namespace mes
