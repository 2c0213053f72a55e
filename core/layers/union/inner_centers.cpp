// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/layers/parts/family.h"

namespace mes {

Layer make_union_inner_centers_layer(const UnionFamily& family) {
  const BallUnion& balls = family.balls;
  return union_layer(
      family,
      {.id = "inner-centers",
       .name = "centres",
       .tooltip = "Centres of the analysed disks",

       .scalar = "radius",
       .style = {.color = palette::orange, .point_size_px = 4},
       .kinds = {PrimitiveKind::point}},
      table_part(
          {PrimitiveKind::point}, [&balls] { return balls.tables().balls.size(); }, balls.changes().balls,
          [&balls](FamilySlot row, Instance& out) {
            if (balls.tables().balls[row] == BallState::none) return;
            const Disk disk = balls.family().disk(row);
            out.point(disk.center, disk.radius);
          },
          ElementType{ElementKind::ball, &balls}));
}

}  // namespace mes
