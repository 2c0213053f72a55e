// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/layers/parts/family.h"

namespace mes {

Layer make_union_v_points_layer(const UnionFamily& family) {
  const BallUnion& balls = family.balls;
  return union_layer(family,
                     {.id = "v-points",
                      .name = "v-points",
                      .tooltip = "Crossings of two circles that lie on the boundary of the union",
                      .in_paper = true,
                      .scalar = "multiplicity",
                      .style = {.color = palette::purple, .point_size_px = 5},
                      .kinds = {PrimitiveKind::point}},
                     union_part({PrimitiveKind::point}, balls, &UnionTables::v_points, balls.changes().v_points,
                                [](const VPoint& v, Instance& out) {
                                  if (v.is_alive()) out.point(v.position, v.multiplicity);
                                }));
}

}  // namespace mes
