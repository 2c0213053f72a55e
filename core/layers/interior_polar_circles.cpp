// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/layers/parts/helpers.h"
#include "core/structures/poles/pole_labels.h"

namespace mes {

Layer make_interior_polar_circles_layer(const StructureSet& set) {
  const auto& delaunay = set.get<Delaunay>();
  const auto& labels = set.get<PoleLabels>();
  return make_layer({.id = "interior-polar-circles",
                     .name = "Interior polar circles",
                     .tooltip = "Circles of poles labelled inside",
                     .group = LayerGroup::poles,
                     .in_paper = true,
                     .scalar = "radius",
                     .style = {.color = palette::orange, .opacity = 0.6},
                     .kinds = {PrimitiveKind::circle}},
                    {&delaunay, &labels},
                    faces_part({PrimitiveKind::circle}, delaunay, labels.changes(), [&](Slot face, Instance& out) {
                      if (labels.is_inside_pole(face))
                        out.circle(delaunay.circumcenter(face), delaunay.circumradius(face),
                                   delaunay.circumradius(face));
                    }));
}

}  // namespace mes
