// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/layers/parts/family.h"

namespace mes {

Layer make_union_ball_convex_disks_layer(const UnionFamily& family) {
  return union_layer_of(
      family, family.sampling,
      {.id = "ball-convex-disks",
       .name = "disks along dual edges",
       .tooltip = "Disks interpolated along singular and regular dual edges",
       .scalar = "radius",
       .style = {.color = palette::purple, .opacity = 0.15, .flat = true},
       .kinds = {PrimitiveKind::disk}},
      sampled_part({PrimitiveKind::disk}, family.sampling.convex(),
                   [](const Disk& disk, Instance& out) { out.disk(disk.center, disk.radius, disk.radius); }));
}

}  // namespace mes
