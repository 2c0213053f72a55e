// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/layers/parts/family.h"

namespace mes {

Layer make_union_scale_skeleton_layer(const UnionFamily& family) {
  return scale_layer(
      family, family.skeleton,
      {.id = "scale-skeleton",
       .name = "scale skeleton",
       .tooltip = "Scale axis reached in steps: after each, the balls along it replace the previous ones",
       .scalar = "radius",
       .style = {.color = palette::purple, .line_width_px = 2.5},
       .kinds = {PrimitiveKind::segment, PrimitiveKind::point}},
      scale_axis_pieces(family.skeleton), scale_axis_points(family.skeleton));
}

}  // namespace mes
