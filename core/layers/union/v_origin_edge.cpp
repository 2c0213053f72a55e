// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/layers/parts/family.h"

namespace mes {

Layer make_union_v_origin_edge_layer(const UnionFamily& family) {
  const BallUnion& balls = family.balls;
  return union_layer(
      family,
      {.id = "v-origin-edge",
       .name = "v-point origin edges",
       .tooltip = "Links each v-point with the middle of the dual edge that made it",
       .in_paper = true,
       .style = {.color = palette::purple, .opacity = 0.7},
       .kinds = {PrimitiveKind::segment}},
      union_part(
          {PrimitiveKind::segment}, balls, &UnionTables::v_origins, balls.changes().v_points,
          [&balls](const VOrigin& origin, Instance& out) {
            if (!origin.is_alive()) return;
            const DualEdge& edge = balls.tables().dual_edges[origin.edge];
            const Vec2 a = balls.family().disk(edge.ball[0]).center;
            const Vec2 b = balls.family().disk(edge.ball[1]).center;
            out.segment(balls.tables().v_points[origin.v].position, {0.5 * a.x + 0.5 * b.x, 0.5 * a.y + 0.5 * b.y});
          }));
}

}  // namespace mes
