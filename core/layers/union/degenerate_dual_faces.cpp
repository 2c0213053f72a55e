// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/layers/parts/family.h"

namespace mes {

Layer make_union_degenerate_dual_faces_layer(const UnionFamily& family) {
  const BallUnion& balls = family.balls;
  return union_layer(
      family,
      {.id = "degenerate-dual-faces",
       .name = "degenerate dual faces",
       .tooltip = "Dual triangles whose three circles meet in one sample: their orthogonal radius is zero",
       .scalar = "1 if judged negative instead",
       .style = {.color = palette::yellow, .opacity = 0.3},
       .kinds = {PrimitiveKind::triangle}},
      union_part({PrimitiveKind::triangle}, balls, &UnionTables::dual_faces, balls.changes().dual_faces,
                 [&balls](const DualFace& face, Instance& out) {
                   if (!face.is_alive() || face.is_exactly_zero == 0) return;
                   const BallFamily& of = balls.family();
                   out.triangle(of.disk(face.ball[0]).center, of.disk(face.ball[1]).center,
                                of.disk(face.ball[2]).center, face.sign < 0 ? 1.0 : 0.0);
                 }));
}

}  // namespace mes
