// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/layers/parts/family.h"

namespace mes {

Layer make_union_alpha_edges_layer(const UnionFamily& family) {
  const GrownComplex& complex = family.grown;
  return grown_layer(
      family,
      {.id = "alpha-edges",
       .name = "alpha edges",
       .tooltip = "Edges of the dual complex of the grown balls",
       .scalar = "growth",
       .style = {.color = palette::green, .line_width_px = 1.5},
       .kinds = {PrimitiveKind::segment}},
      table_part(
          {PrimitiveKind::segment}, [&] { return complex.filtration().edges().size(); }, complex.edge_changes(),
          [&complex](GrownEdgeSlot edge, Instance& out) {
            if (!complex.holds(edge)) return;
            const BallFiltration& of = complex.filtration();
            const BallBirths::Edge& row = of.edges()[edge];
            out.segment(of.disk(row.v[0]).center, of.disk(row.v[1]).center, of.growth(row.rank));
          },
          ElementType{ElementKind::alpha_edge, &complex}));
}

}  // namespace mes
