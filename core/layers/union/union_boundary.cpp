// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/layers/parts/family.h"

namespace mes {

Layer make_union_union_boundary_layer(const UnionFamily& family) {
  const BallUnion& balls = family.balls;
  return union_layer(family,
                     {.id = "union-boundary",
                      .name = "boundary",
                      .tooltip = "Boundary arcs of the union",
                      .style = {.color = palette::black, .line_width_px = 1.5},
                      .kinds = {PrimitiveKind::arc}},
                     union_part({PrimitiveKind::arc}, balls, &UnionTables::arcs, balls.changes().arcs,
                                [&balls](const BoundaryArc& arc, Instance& out) {
                                  if (!arc.is_alive()) return;
                                  if (const auto drawn = drawn_arc(arc, balls.family().disk(arc.ball)))
                                    out.arc(*drawn);
                                }));
}

}  // namespace mes
