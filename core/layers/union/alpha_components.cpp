// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/layers/parts/family.h"

namespace mes {

Layer make_union_alpha_components_layer(const UnionFamily& family) {
  const GrownComplex& complex = family.grown;
  return grown_layer(
      family,
      {.id = "alpha-components",
       .name = "alpha components",
       .tooltip = "The ball that represents each component of the grown balls in the persistence diagram",
       .style = {.color = palette::vermilion, .point_size_px = 9.0},
       .kinds = {PrimitiveKind::point}},
      table_part(
          {PrimitiveKind::point}, [&] { return complex.filtration().classes().size(); }, complex.class_changes(),
          [&complex](GrownClassSlot row, Instance& out) {
            const BallFiltration& of = complex.filtration();
            const BallFiltration::Class& one = of.classes()[row.index()];
            if (!one.is_hole && complex.is_alive(one)) out.point(of.disk(one.corner).center);
          },
          ElementType{ElementKind::alpha_class, &complex}));
}

}  // namespace mes
