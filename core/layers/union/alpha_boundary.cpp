// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/layers/parts/family.h"

namespace mes {

Layer make_union_alpha_boundary_layer(const UnionFamily& family) {
  const GrownComplex& complex = family.grown;
  return grown_layer(
      family,
      {.id = "alpha-boundary",
       .name = "alpha boundary",
       .tooltip = "Boundary of the union of the grown balls",
       .style = {.color = palette::blue, .line_width_px = 1.5},
       .kinds = {PrimitiveKind::arc, PrimitiveKind::circle}},
      table_part(
          {PrimitiveKind::arc}, [&] { return 2 * complex.filtration().edges().size(); }, complex.end_changes(),
          [&complex](GrownEndSlot row, Instance& out) {
            if (const auto arc = complex.drawn(row)) out.arc(*arc);
          },
          ElementType{ElementKind::alpha_end, &complex}),
      table_part(
          {PrimitiveKind::circle}, [&] { return complex.filtration().corners().size(); }, complex.corner_changes(),
          [&complex](GrownCornerSlot corner, Instance& out) {
            const Disk disk = complex.disk(corner);
            if (complex.is_alone(corner) && disk.radius > 0.0) out.circle(disk.center, disk.radius);
          },
          ElementType{ElementKind::alpha_corner, &complex}));
}

}  // namespace mes
