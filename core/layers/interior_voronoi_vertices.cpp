// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/layers/parts/helpers.h"
#include "core/structures/axis/inner_balls.h"

namespace mes {
Layer make_interior_voronoi_vertices_layer(const StructureSet& set) {
  const auto& delaunay = set.get<Delaunay>();
  const auto& balls = set.get<InnerBalls>();
  return make_layer({.id = "interior-voronoi-vertices",
                     .name = "Interior Voronoi vertices",
                     .tooltip = "Centres of the inside circumcircles",
                     .group = LayerGroup::crust_axis,
                     .in_paper = true,
                     .scalar = "radius",
                     .style = {.color = palette::orange, .point_size_px = 4},
                     .kinds = {PrimitiveKind::point}},
                    {&delaunay, &balls},
                    faces_part({PrimitiveKind::point}, delaunay, balls.changes(), [&](Slot face, Instance& out) {
                      if (balls.is_ball(face)) out.point(delaunay.circumcenter(face), delaunay.circumradius(face));
                    }));
}

}  // namespace mes
