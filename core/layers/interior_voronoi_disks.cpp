// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/layers/parts/helpers.h"
#include "core/structures/axis/inner_balls.h"

namespace mes {
Layer make_interior_voronoi_disks_layer(const StructureSet& set) {
  const auto& delaunay = set.get<Delaunay>();
  const auto& balls = set.get<InnerBalls>();
  return make_layer({.id = "interior-voronoi-disks",
                     .name = "Interior Voronoi disks",
                     .tooltip = "Disks of inside triangles; their union approximates the shape",
                     .group = LayerGroup::crust_axis,
                     .in_paper = true,
                     .visible_at_start = true,
                     .scalar = "radius",
                     .style = {.color = palette::orange, .opacity = 0.2, .flat = true},
                     .kinds = {PrimitiveKind::disk}},
                    {&delaunay, &balls},
                    faces_part({PrimitiveKind::disk}, delaunay, balls.changes(), [&](Slot face, Instance& out) {
                      if (balls.is_ball(face))
                        out.disk(delaunay.circumcenter(face), delaunay.circumradius(face),
                                 delaunay.circumradius(face));
                    }));
}

}  // namespace mes
