// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/layers/parts/family.h"

namespace mes {

Layer make_union_inner_circles_layer(const UnionFamily& family) {
  const BallUnion& balls = family.balls;
  return union_layer(
      family,
      {.id = "inner-circles",
       .name = "circles",
       .tooltip = "Circles of the analysed disks",

       .scalar = "radius",
       .style = {.color = palette::orange, .opacity = 0.6},
       .kinds = {PrimitiveKind::circle}},
      table_part(
          {PrimitiveKind::circle}, [&balls] { return balls.tables().balls.size(); }, balls.changes().balls,
          [&balls](FamilySlot row, Instance& out) {
            if (balls.tables().balls[row] == BallState::none) return;
            const Disk disk = balls.family().disk(row);
            out.circle(disk.center, disk.radius, disk.radius);
          },
          ElementType{ElementKind::ball, &balls}));
}

}  // namespace mes
