// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/layers/parts/family.h"

namespace mes {

Layer make_union_scale_axis_boundary_layer(const UnionFamily& family) {
  return scale_layer(
      family, family.scaled,
      {.id = "scale-axis-boundary",
       .name = "scaled boundary",
       .tooltip = "Boundary arcs of the union of the balls along the axis, radii multiplied by scale-axis-factor",
       .style = {.color = palette::sky, .line_width_px = 1.5},
       .kinds = {PrimitiveKind::arc}},
      scale_axis_arcs(family.scaled));
}

}  // namespace mes
