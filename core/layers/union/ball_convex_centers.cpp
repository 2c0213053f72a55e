// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/layers/parts/family.h"

namespace mes {

Layer make_union_ball_convex_centers_layer(const UnionFamily& family) {
  return union_layer_of(family, family.sampling,
                        {.id = "ball-convex-centers",
                         .name = "centres along dual edges",
                         .tooltip = "Centres interpolated along singular and regular dual edges",
                         .scalar = "radius",
                         .style = {.color = palette::purple, .point_size_px = 3.0},
                         .kinds = {PrimitiveKind::point}},
                        sampled_part({PrimitiveKind::point}, family.sampling.convex(),
                                     [](const Disk& disk, Instance& out) { out.point(disk.center, disk.radius); }));
}

}  // namespace mes
