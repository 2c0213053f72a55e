// SPDX-License-Identifier: GPL-3.0-or-later
// The power diagram and the dual complex.
#include "core/layers/parts/family.h"

namespace mes {

Layer make_union_power_diagram_layer(const UnionFamily& family) {
  const PowerDiagram& diagram = family.power_diagram;
  return union_layer_of(family, diagram,
                        {.id = "ball-power-diagram",
                         .name = "power diagram",
                         .tooltip = "Power diagram of the balls",
                         .in_fit_box = false,
                         .style = {.color = palette::sky, .opacity = 0.6},
                         .kinds = {PrimitiveKind::line, PrimitiveKind::ray, PrimitiveKind::segment}},
                        power_part({PrimitiveKind::line, PrimitiveKind::ray, PrimitiveKind::segment}, diagram,
                                   [](const PowerEdge& edge, Instance& out) { emit_power_edge(edge, out); }));
}

Layer make_union_ball_triangulation_layer(const UnionFamily& family) {
  const PowerDiagram& diagram = family.power_diagram;
  return union_layer_of(
      family, diagram,
      {.id = "ball-triangulation",
       .name = "regular triangulation",
       .tooltip = "Regular triangulation of the balls",
       .in_paper = true,
       .style = {.color = palette::grey, .opacity = 0.6},
       .kinds = {PrimitiveKind::segment}},
      power_part({PrimitiveKind::segment}, diagram,
                 [&diagram](const PowerEdge& edge, Instance& out) { emit_centers(diagram, edge, out); }));
}

Layer make_union_dual_faces_layer(const UnionFamily& family) {
  const BallUnion& balls = family.balls;
  return union_layer(family,
                     {.id = "dual-faces",
                      .name = "dual faces",
                      .tooltip = "Triangles of the dual complex",
                      .in_paper = true,
                      .style = {.color = palette::green, .opacity = 0.15},
                      .kinds = {PrimitiveKind::triangle}},
                     union_part({PrimitiveKind::triangle}, balls, &UnionTables::dual_faces,
                                balls.changes().dual_faces, [&balls](const DualFace& face, Instance& out) {
                                  if (!face.is_alive()) return;
                                  const BallFamily& family_of = balls.family();
                                  out.triangle(family_of.disk(face.ball[0]).center,
                                               family_of.disk(face.ball[1]).center,
                                               family_of.disk(face.ball[2]).center);
                                }));
}

Layer make_union_degenerate_dual_faces_layer(const UnionFamily& family) {
  const BallUnion& balls = family.balls;
  return union_layer(
      family,
      {.id = "degenerate-dual-faces",
       .name = "degenerate dual faces",
       .tooltip = "Dual triangles whose three circles meet in one sample: their orthogonal radius is zero",
       .scalar = "1 if judged negative instead",
       .style = {.color = palette::yellow, .opacity = 0.3},
       .kinds = {PrimitiveKind::triangle}},
      union_part({PrimitiveKind::triangle}, balls, &UnionTables::dual_faces, balls.changes().dual_faces,
                 [&balls](const DualFace& face, Instance& out) {
                   if (!face.is_alive() || face.is_exactly_zero == 0) return;
                   const BallFamily& of = balls.family();
                   out.triangle(of.disk(face.ball[0]).center, of.disk(face.ball[1]).center,
                                of.disk(face.ball[2]).center, face.sign < 0 ? 1.0 : 0.0);
                 }));
}

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

Layer make_union_dual_regular_edges_layer(const UnionFamily& family) {
  const BallUnion& balls = family.balls;
  return union_layer(family,
                     {.id = "dual-regular-edges",
                      .name = "dual regular edges",
                      .tooltip = "Dual edges that bound one dual triangle",
                      .in_paper = true,
                      .style = {.color = palette::green, .line_width_px = 2},
                      .kinds = {PrimitiveKind::segment}},
                     union_part({PrimitiveKind::segment}, balls, &UnionTables::dual_edges, balls.changes().dual_edges,
                                [&balls](const DualEdge& edge, Instance& out) {
                                  if (!edge.is_alive() || edge.kind != DualClass::regular) return;
                                  out.segment(balls.family().disk(edge.ball[0]).center,
                                              balls.family().disk(edge.ball[1]).center);
                                }));
}

Layer make_union_dual_singular_edges_layer(const UnionFamily& family) {
  const BallUnion& balls = family.balls;
  return union_layer(family,
                     {.id = "dual-singular-edges",
                      .name = "dual singular edges",
                      .tooltip = "Dual edges that bound no dual triangle",
                      .in_paper = true,
                      .style = {.color = palette::vermilion, .line_width_px = 3},
                      .kinds = {PrimitiveKind::segment}},
                     union_part({PrimitiveKind::segment}, balls, &UnionTables::dual_edges, balls.changes().dual_edges,
                                [&balls](const DualEdge& edge, Instance& out) {
                                  if (!edge.is_alive() || edge.kind != DualClass::singular) return;
                                  out.segment(balls.family().disk(edge.ball[0]).center,
                                              balls.family().disk(edge.ball[1]).center);
                                }));
}

}  // namespace mes
