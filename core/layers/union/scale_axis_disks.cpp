// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/layers/parts/family.h"

namespace mes {

Layer make_union_scale_axis_disks_layer(const UnionFamily& family) {
  const AxisBallUnion& balls = family.scaled;
  Layer layer =
      scale_layer(family, balls,
                  {.id = "scale-axis-disks",
                   .name = "scale axis disks",
                   .tooltip = "Disks along the scale axis, with their radii divided by scale-axis-factor again",
                   .scalar = "radius",
                   .style = {.color = palette::blue, .opacity = 0.15},
                   .kinds = {PrimitiveKind::disk}},
                  sampled_part(
                      {PrimitiveKind::disk}, family.scaled_sampling.medial(),
                      [&balls](const Disk& disk, Instance& out) {
                        const double radius = disk.radius / balls.factor();
                        out.disk(disk.center, radius, radius);
                      },
                      &family.scaled_sampling));
  layer.structures.push_back(&family.scaled_sampling);
  layer.descriptor.structures.emplace_back(family.scaled_sampling.id());
  return layer;
}

}  // namespace mes
