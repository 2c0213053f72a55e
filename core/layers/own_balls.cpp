// SPDX-License-Identifier: GPL-3.0-or-later
// The user's own balls.
#include "core/layers/parts/helpers.h"
#include "core/structures/inputs/scaled_user_balls.h"

namespace mes {

Layer make_b_inner_disks_layer(const StructureSet& set) {
  const auto& balls = set.get<ScaledUserBalls>();
  return make_layer({.id = "b-inner-disks",
                     .name = "Own balls: disks",
                     .tooltip = "Disks of your own balls",
                     .group = LayerGroup::union_b,
                     .of_any_family = "inner-disks",
                     .visible_at_start = true,
                     .scalar = "radius",
                     .style = {.color = palette::orange, .opacity = 0.2},
                     .kinds = {PrimitiveKind::disk}},
                    {&balls},
                    table_part(
                        {PrimitiveKind::disk}, [&balls] { return balls.row_count(); }, balls.changes(),
                        [&balls](BallSlot row, Instance& out) {
                          if (!balls.is_alive(row)) return;
                          const Disk disk = balls.disk(row);
                          if (disk.radius > 0.0) out.disk(disk.center, disk.radius, disk.radius);
                        },
                        ElementType{ElementKind::own_ball}));
}

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

Layer make_b_inner_centers_layer(const StructureSet& set) {
  const auto& balls = set.get<ScaledUserBalls>();
  return make_layer(
      {.id = "b-inner-centers",
       .name = "Own balls: centres",
       .tooltip = "Centres of your own balls; drag one to move its ball, turn the wheel on it to change the radius",
       .group = LayerGroup::union_b,
       .data = LayerData::balls,
       .of_any_family = "inner-centers",
       .visible_at_start = true,
       .scalar = "radius",
       .style = {.color = palette::orange, .point_size_px = 4},
       .kinds = {PrimitiveKind::point}},
      {&balls},
      table_part(
          {PrimitiveKind::point}, [&balls] { return balls.row_count(); }, balls.changes(),
          [&balls](BallSlot row, Instance& out) {
            if (!balls.is_alive(row)) return;
            const Disk disk = balls.disk(row);
            out.point(disk.center, disk.radius);
          },
          ElementType{ElementKind::own_ball}));
}

}  // namespace mes
