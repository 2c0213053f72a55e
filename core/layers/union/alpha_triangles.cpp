// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/layers/parts/family.h"

namespace mes {

Layer make_union_alpha_triangles_layer(const UnionFamily& family) {
  const GrownComplex& complex = family.grown;
  return grown_layer(family,
                     {.id = "alpha-triangles",
                      .name = "alpha triangles",
                      .tooltip = "Triangles of the dual complex of the grown balls",
                      .scalar = "growth",
                      .style = {.color = palette::green, .opacity = 0.35},
                      .kinds = {PrimitiveKind::triangle}},
                     table_part(
                         {PrimitiveKind::triangle}, [&] { return complex.filtration().triangles().size(); },
                         complex.triangle_changes(),
                         [&complex](GrownTriangleSlot triangle, Instance& out) {
                           if (!complex.holds(triangle)) return;
                           const BallFiltration& of = complex.filtration();
                           const BallBirths::Triangle& row = of.triangles()[triangle];
                           out.triangle(of.disk(row.v[0]).center, of.disk(row.v[1]).center, of.disk(row.v[2]).center,
                                        of.growth(row.rank));
                         },
                         ElementType{ElementKind::alpha_triangle, &complex}));
}

}  // namespace mes
