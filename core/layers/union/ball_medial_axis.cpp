// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/layers/parts/family.h"

namespace mes {

Layer make_union_ball_medial_axis_layer(const UnionFamily& family) {
  const BallUnion& balls = family.balls;
  return union_layer(
      family,
      {.id = "ball-medial-axis",
       .name = "medial axis",
       .tooltip = "Medial axis of the union of the balls, from the general pipeline or its certified shortcut",
       .in_paper = true,
       .scalar = "radius",
       .style = {.color = palette::vermilion, .line_width_px = 2.5},
       .kinds = {PrimitiveKind::segment, PrimitiveKind::point}},
      union_part({PrimitiveKind::segment}, balls, &UnionTables::axis, balls.changes().dual_edges,
                 [](const AxisPiece& piece, Instance& out) {
                   if (piece.is_alive()) out.segment(piece.a, piece.b, 0.5 * (piece.radius_a + piece.radius_b));
                 }),
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
