// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/layers/parts/family.h"

namespace mes {

Layer make_union_scale_axis_grown_disks_layer(const UnionFamily& family) {
  return scale_layer(family, family.scaled,
                     {.id = "scale-axis-grown-disks",
                      .name = "scaled disks along the axis",
                      .tooltip = "Disks along the medial axis of the union, radii multiplied by scale-axis-factor",
                      .scalar = "radius",
                      .style = {.color = palette::sky, .opacity = 0.25, .flat = true},
                      .kinds = {PrimitiveKind::disk}},
                     ball_part(PrimitiveKind::disk, family.scaled, [](BallState, const Disk& disk, Instance& out) {
                       out.disk(disk.center, disk.radius, disk.radius);
                     }));
}

}  // namespace mes
