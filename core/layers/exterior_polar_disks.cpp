// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/layers/parts/helpers.h"
#include "core/structures/poles/pole_labels.h"

namespace mes {

Layer make_exterior_polar_disks_layer(const StructureSet& set) {
  const auto& delaunay = set.get<Delaunay>();
  const auto& poles = set.get<Poles>();
  const auto& labels = set.get<PoleLabels>();
  return make_layer({.id = "exterior-polar-disks",
                     .name = "Exterior polar disks",
                     .tooltip = "Disks of poles not labelled inside",
                     .group = LayerGroup::poles,
                     .in_fit_box = false,
                     .scalar = "radius",
                     .style = {.color = palette::sky, .opacity = 0.1},
                     .kinds = {PrimitiveKind::disk}},
                    {&delaunay, &poles, &labels},
                    faces_part({PrimitiveKind::disk}, delaunay, labels.changes(), [&](Slot face, Instance& out) {
                      if (poles.is_pole(face) && !labels.is_inside(face))
                        out.disk(delaunay.circumcenter(face), delaunay.circumradius(face),
                                 delaunay.circumradius(face));
                    }));
}

}  // namespace mes
