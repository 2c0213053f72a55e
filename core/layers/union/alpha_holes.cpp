// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/layers/parts/family.h"

namespace mes {

Layer make_union_alpha_holes_layer(const UnionFamily& family) {
  const GrownComplex& complex = family.grown;
  return grown_layer(
      family,
      {.id = "alpha-holes",
       .name = "alpha holes",
       .tooltip =
           "The circle orthogonal to the three balls that meet last in each hole: it fills when alpha-radius is "
           "the radius of the circle",
       .scalar = "persistence",
       .style = {.color = palette::purple, .line_width_px = 2.0},
       .kinds = {PrimitiveKind::circle}},
      table_part(
          {PrimitiveKind::circle}, [&] { return complex.filtration().classes().size(); }, complex.class_changes(),
          [&complex](GrownClassSlot row, Instance& out) {
            const BallFiltration& of = complex.filtration();
            const BallFiltration::Class& one = of.classes()[row.index()];
            if (!one.is_hole || !complex.is_alive(one)) return;
            out.circle(of.triangles()[one.triangle].center, of.growth(one.death),
                       of.growth(one.death) - of.growth(one.birth));
          },
          ElementType{ElementKind::alpha_class, &complex}));
}

}  // namespace mes
