// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/layers/parts/helpers.h"
#include "core/structures/poles/pole_labels.h"

namespace mes {

Layer make_interior_polar_disks_layer(const StructureSet& set) {
  const auto& delaunay = set.get<Delaunay>();
  const auto& labels = set.get<PoleLabels>();
  return make_layer({.id = "interior-polar-disks",
                     .name = "Interior polar disks",
                     .tooltip = "Disks of poles labelled inside",
                     .group = LayerGroup::poles,
                     .in_paper = true,
                     .scalar = "radius",
                     .style = {.color = palette::orange, .opacity = 0.2},
                     .kinds = {PrimitiveKind::disk}},
                    {&delaunay, &labels},
                    faces_part({PrimitiveKind::disk}, delaunay, labels.changes(), [&](Slot face, Instance& out) {
                      if (labels.is_inside_pole(face))
                        out.disk(delaunay.circumcenter(face), delaunay.circumradius(face),
                                 delaunay.circumradius(face));
                    }));
}

}  // namespace mes
