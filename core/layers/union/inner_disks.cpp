// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/layers/parts/family.h"

namespace mes {

Layer make_union_inner_disks_layer(const UnionFamily& family) {
  const BallUnion& balls = family.balls;
  return union_layer(
      family,
      {.id = "inner-disks",
       .name = "disks",
       .tooltip = "Disks whose union is analysed",

       .scalar = "radius",
       .style = {.color = palette::orange, .opacity = 0.2, .flat = true},
       .kinds = {PrimitiveKind::disk}},
      table_part(
          {PrimitiveKind::disk}, [&balls] { return balls.tables().balls.size(); }, balls.changes().balls,
          [&balls](FamilySlot row, Instance& out) {
            if (balls.tables().balls[row] == BallState::none) return;
            const Disk disk = balls.family().disk(row);
            out.disk(disk.center, disk.radius, disk.radius);
          },
          ElementType{ElementKind::ball, &balls}));
}

}  // namespace mes
