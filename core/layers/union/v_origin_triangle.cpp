// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/layers/parts/family.h"

namespace mes {

Layer make_union_v_origin_triangle_layer(const UnionFamily& family) {
  const BallUnion& balls = family.balls;
  return union_layer(family,
                     {.id = "v-origin-triangle",
                      .name = "v-point origin triangles",
                      .tooltip = "Triangle of a v-point and the dual edge that made it",
                      .in_paper = true,
                      .style = {.color = palette::purple, .opacity = 0.15},
                      .kinds = {PrimitiveKind::triangle}},
                     union_part({PrimitiveKind::triangle}, balls, &UnionTables::v_origins, balls.changes().v_points,
                                [&balls](const VOrigin& origin, Instance& out) {
                                  if (!origin.is_alive()) return;
                                  const DualEdge& edge = balls.tables().dual_edges[origin.edge];
                                  const Vec2 v = balls.tables().v_points[origin.v].position;
                                  const Vec2 a = balls.family().disk(edge.ball[0]).center;
                                  const Vec2 b = balls.family().disk(edge.ball[1]).center;
                                  if (cross(a - v, b - v) < 0.0) {
                                    out.triangle(v, b, a);
                                  } else {
                                    out.triangle(v, a, b);
                                  }
                                }));
}

}  // namespace mes
