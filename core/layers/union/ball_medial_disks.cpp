// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/layers/parts/family.h"

namespace mes {

Layer make_union_ball_medial_disks_layer(const UnionFamily& family) {
  return union_layer_of(
      family, family.sampling,
      {.id = "ball-medial-disks",
       .name = "disks along the axis",
       .tooltip = "Disks sampled along the medial axis of the union",
       .scalar = "radius",
       .style = {.color = palette::vermilion, .opacity = 0.15, .flat = true},
       .kinds = {PrimitiveKind::disk}},
      sampled_part({PrimitiveKind::disk}, family.sampling.medial(),
                   [](const Disk& disk, Instance& out) { out.disk(disk.center, disk.radius, disk.radius); }));
}

}  // namespace mes
