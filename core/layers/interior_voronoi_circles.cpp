// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/layers/parts/helpers.h"
#include "core/structures/axis/inner_balls.h"

namespace mes {
Layer make_interior_voronoi_circles_layer(const StructureSet& set) {
  const auto& delaunay = set.get<Delaunay>();
  const auto& balls = set.get<InnerBalls>();
  return make_layer({.id = "interior-voronoi-circles",
                     .name = "Interior Voronoi circles",
                     .tooltip = "Circumcircles whose triangle is labelled inside",
                     .group = LayerGroup::crust_axis,
                     .in_paper = true,
                     .scalar = "radius",
                     .style = {.color = palette::orange, .opacity = 0.6},
                     .kinds = {PrimitiveKind::circle}},
                    {&delaunay, &balls},
                    faces_part({PrimitiveKind::circle}, delaunay, balls.changes(), [&](Slot face, Instance& out) {
                      if (balls.is_ball(face))
                        out.circle(delaunay.circumcenter(face), delaunay.circumradius(face),
                                   delaunay.circumradius(face));
                    }));
}

}  // namespace mes
