// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/layers/parts/family.h"

namespace mes {

Layer make_union_ball_medial_circles_layer(const UnionFamily& family) {
  return union_layer_of(
      family, family.sampling,
      {.id = "ball-medial-circles",
       .name = "circles along the axis",
       .tooltip = "Circles sampled along the medial axis of the union",
       .scalar = "radius",
       .style = {.color = palette::vermilion, .opacity = 0.5},
       .kinds = {PrimitiveKind::circle}},
      sampled_part({PrimitiveKind::circle}, family.sampling.medial(),
                   [](const Disk& disk, Instance& out) { out.circle(disk.center, disk.radius, disk.radius); }));
}

}  // namespace mes
