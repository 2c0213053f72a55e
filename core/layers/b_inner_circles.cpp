// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/layers/parts/helpers.h"
#include "core/structures/inputs/scaled_user_balls.h"

namespace mes {

Layer make_b_inner_circles_layer(const StructureSet& set) {
  const auto& balls = set.get<ScaledUserBalls>();
  return make_layer({.id = "b-inner-circles",
                     .name = "Own balls: circles",
                     .tooltip = "Circles of your own balls",
                     .group = LayerGroup::union_b,
                     .of_any_family = "inner-circles",
                     .visible_at_start = true,
                     .scalar = "radius",
                     .style = {.color = palette::orange, .opacity = 0.6},
                     .kinds = {PrimitiveKind::circle}},
                    {&balls},
                    table_part(
                        {PrimitiveKind::circle}, [&balls] { return balls.row_count(); }, balls.changes(),
                        [&balls](BallSlot row, Instance& out) {
                          if (!balls.is_alive(row)) return;
                          const Disk disk = balls.disk(row);
                          if (disk.radius > 0.0) out.circle(disk.center, disk.radius, disk.radius);
                        },
                        ElementType{ElementKind::own_ball}));
}

}  // namespace mes
