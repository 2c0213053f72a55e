// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/layers/parts/helpers.h"
#include "core/structures/poles/pole_labels.h"

namespace mes {

Layer make_interior_polar_vertices_layer(const StructureSet& set) {
  const auto& delaunay = set.get<Delaunay>();
  const auto& labels = set.get<PoleLabels>();
  return make_layer({.id = "interior-polar-vertices",
                     .name = "Interior polar vertices",
                     .tooltip = "Poles labelled inside",
                     .group = LayerGroup::poles,
                     .in_paper = true,
                     .scalar = "radius",
                     .style = {.color = palette::orange, .point_size_px = 4},
                     .kinds = {PrimitiveKind::point}},
                    {&delaunay, &labels},
                    faces_part({PrimitiveKind::point}, delaunay, labels.changes(), [&](Slot face, Instance& out) {
                      if (labels.is_inside_pole(face))
                        out.point(delaunay.circumcenter(face), delaunay.circumradius(face));
                    }));
}

}  // namespace mes
