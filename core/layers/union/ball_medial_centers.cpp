// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/layers/parts/family.h"

namespace mes {

Layer make_union_ball_medial_centers_layer(const UnionFamily& family) {
  return union_layer_of(family, family.sampling,
                        {.id = "ball-medial-centers",
                         .name = "centres along the axis",
                         .tooltip = "Centres sampled along the medial axis of the union",
                         .scalar = "radius",
                         .style = {.color = palette::vermilion, .point_size_px = 3.0},
                         .kinds = {PrimitiveKind::point}},
                        sampled_part({PrimitiveKind::point}, family.sampling.medial(),
                                     [](const Disk& disk, Instance& out) { out.point(disk.center, disk.radius); }));
}

}  // namespace mes
