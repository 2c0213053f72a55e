// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/layers/parts/family.h"

namespace mes {

Layer make_union_scale_axis_layer(const UnionFamily& family) {
  return scale_layer(
      family, family.scaled,
      {.id = "scale-axis",
       .name = "scale axis",
       .tooltip = "Medial axis of the union of the balls along the axis, radii multiplied by scale-axis-factor, "
                  "without spurious branches of the sampling, radii divided by it again",
       .scalar = "radius",
       .style = {.color = palette::vermilion, .line_width_px = 2.5},
       .kinds = {PrimitiveKind::segment, PrimitiveKind::point}},
      scale_axis_pieces(family.scaled), scale_axis_points(family.scaled));
}

}  // namespace mes
