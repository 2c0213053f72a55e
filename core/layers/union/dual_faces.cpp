// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/layers/parts/family.h"

namespace mes {

Layer make_union_dual_faces_layer(const UnionFamily& family) {
  const BallUnion& balls = family.balls;
  return union_layer(family,
                     {.id = "dual-faces",
                      .name = "dual faces",
                      .tooltip = "Triangles of the dual complex",
                      .in_paper = true,
                      .style = {.color = palette::green, .opacity = 0.15},
                      .kinds = {PrimitiveKind::triangle}},
                     union_part({PrimitiveKind::triangle}, balls, &UnionTables::dual_faces,
                                balls.changes().dual_faces, [&balls](const DualFace& face, Instance& out) {
                                  if (!face.is_alive()) return;
                                  const BallFamily& family_of = balls.family();
                                  out.triangle(family_of.disk(face.ball[0]).center,
                                               family_of.disk(face.ball[1]).center,
                                               family_of.disk(face.ball[2]).center);
                                }));
}

}  // namespace mes
