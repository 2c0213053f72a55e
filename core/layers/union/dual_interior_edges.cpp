// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/layers/parts/family.h"

namespace mes {

Layer make_union_dual_interior_edges_layer(const UnionFamily& family) {
  const BallUnion& balls = family.balls;
  return union_layer(family,
                     {.id = "dual-interior-edges",
                      .name = "dual interior edges",
                      .tooltip = "Dual edges between two dual triangles",
                      .in_paper = true,
                      .style = {.color = palette::green, .opacity = 0.5},
                      .kinds = {PrimitiveKind::segment}},
                     union_part({PrimitiveKind::segment}, balls, &UnionTables::dual_edges, balls.changes().dual_edges,
                                [&balls](const DualEdge& edge, Instance& out) {
                                  if (!edge.is_alive() || edge.kind != DualClass::interior) return;
                                  out.segment(balls.family().disk(edge.ball[0]).center,
                                              balls.family().disk(edge.ball[1]).center);
                                }));
}

}  // namespace mes
