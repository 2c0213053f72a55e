// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/layers/parts/family.h"

namespace mes {

Layer make_union_alpha_disks_layer(const UnionFamily& family) {
  const GrownComplex& complex = family.grown;
  return grown_layer(
      family,
      {.id = "alpha-disks",
       .name = "alpha disks",
       .tooltip = "The balls with squared radii grown by the square of alpha-radius; hidden ones are "
                  "left out",
       .style = {.color = palette::sky, .opacity = 0.25, .flat = true},
       .kinds = {PrimitiveKind::disk}},
      table_part(
          {PrimitiveKind::disk}, [&] { return complex.filtration().corners().size(); }, complex.corner_changes(),
          [&complex](GrownCornerSlot corner, Instance& out) {
            const Disk disk = complex.disk(corner);
            if (disk.radius > 0.0) out.disk(disk.center, disk.radius);
          },
          ElementType{ElementKind::alpha_corner, &complex}));
}

}  // namespace mes
