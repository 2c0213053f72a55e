// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/layers/parts/family.h"

namespace mes {

Layer make_union_isolated_layer(const UnionFamily& family) {
  const BallUnion& balls = family.balls;
  return union_layer(
      family,
      {.id = "isolated",
       .name = "isolated balls",
       .tooltip = "Balls that meet no other: dual vertices without an edge",
       .in_paper = false,
       .scalar = "radius",
       .style = {.color = palette::green, .point_size_px = 7},
       .kinds = {PrimitiveKind::point}},
      table_part(
          {PrimitiveKind::point}, [&balls] { return balls.tables().balls.size(); }, balls.changes().balls,
          [&balls](FamilySlot row, Instance& out) {
            if (balls.tables().balls[row] != BallState::isolated) return;
            const Disk disk = balls.family().disk(row);
            out.point(disk.center, disk.radius);
          },
          ElementType{ElementKind::ball, &balls}));
}

}  // namespace mes
