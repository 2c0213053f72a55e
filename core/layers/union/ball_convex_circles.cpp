// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/layers/parts/family.h"

namespace mes {

Layer make_union_ball_convex_circles_layer(const UnionFamily& family) {
  return union_layer_of(
      family, family.sampling,
      {.id = "ball-convex-circles",
       .name = "circles along dual edges",
       .tooltip = "Circles interpolated along singular and regular dual edges",
       .scalar = "radius",
       .style = {.color = palette::purple, .opacity = 0.5},
       .kinds = {PrimitiveKind::circle}},
      sampled_part({PrimitiveKind::circle}, family.sampling.convex(),
                   [](const Disk& disk, Instance& out) { out.circle(disk.center, disk.radius, disk.radius); }));
}

}  // namespace mes
