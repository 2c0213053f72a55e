// SPDX-License-Identifier: GPL-3.0-or-later
// The boundary, the triangulation of its v-points, and the medial axis of the union.
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

Layer make_union_v_points_layer(const UnionFamily& family) {
  const BallUnion& balls = family.balls;
  return union_layer(family,
                     {.id = "v-points",
                      .name = "v-points",
                      .tooltip = "Crossings of two circles that lie on the boundary of the union",
                      .in_paper = true,
                      .scalar = "multiplicity",
                      .style = {.color = palette::purple, .point_size_px = 5},
                      .kinds = {PrimitiveKind::point}},
                     union_part({PrimitiveKind::point}, balls, &UnionTables::v_points, balls.changes().v_points,
                                [](const VPoint& v, Instance& out) {
                                  if (v.is_alive()) out.point(v.position, v.multiplicity);
                                }));
}

Layer make_union_v_delaunay_layer(const UnionFamily& family) {
  const VDiagram& diagram = family.v_diagram;
  return union_layer_of(
      family, diagram,
      {.id = "v-delaunay",
       .name = "v-point Delaunay triangulation",
       .tooltip = "Delaunay triangulation of the v-points",
       .style = {.color = palette::grey, .opacity = 0.6},
       .kinds = {PrimitiveKind::segment}},
      v_part({PrimitiveKind::segment}, diagram, &UnionTables::v_edges, [&diagram](const VEdge& edge, Instance& out) {
        const auto& points = diagram.tables().v_points;
        out.segment(points[edge.v[0]].position, points[edge.v[1]].position);
      }));
}

Layer make_union_v_voronoi_layer(const UnionFamily& family) {
  const VDiagram& diagram = family.v_diagram;
  return union_layer_of(
      family, diagram,
      {.id = "v-voronoi",
       .name = "v-point Voronoi diagram",
       .tooltip = "Voronoi diagram of the v-points",
       .in_paper = true,
       .in_fit_box = false,
       .style = {.color = palette::sky, .opacity = 0.7},
       .kinds = {PrimitiveKind::line, PrimitiveKind::ray, PrimitiveKind::segment}},
      v_part({PrimitiveKind::line, PrimitiveKind::ray, PrimitiveKind::segment}, diagram, &UnionTables::v_edges,
             [&diagram](const VEdge& edge, Instance& out) { emit_v_dual(diagram.tables(), edge, out); }));
}

Layer make_union_v_crossing_edges_layer(const UnionFamily& family) {
  const VDiagram& diagram = family.v_diagram;
  return union_layer_of(family, diagram,
                        {.id = "v-crossing-edges",
                         .name = "v-point crossing edges",
                         .tooltip = "Voronoi edges of the v-points that pass a boundary vertex of the dual complex",
                         .in_paper = true,
                         .in_fit_box = false,
                         .style = {.color = palette::green, .line_width_px = 2},
                         .kinds = {PrimitiveKind::line, PrimitiveKind::ray, PrimitiveKind::segment}},
                        v_part({PrimitiveKind::line, PrimitiveKind::ray, PrimitiveKind::segment}, diagram,
                               &UnionTables::v_edges, [&diagram](const VEdge& edge, Instance& out) {
                                 if (edge.kind == VEdgeKind::crossing) emit_v_dual(diagram.tables(), edge, out);
                               }));
}

Layer make_union_v_alpha_edges_layer(const UnionFamily& family) {
  const VDiagram& diagram = family.v_diagram;
  return union_layer_of(family, diagram,
                        {.id = "v-alpha-edges",
                         .name = "v-point alpha edges",
                         .tooltip = "Voronoi edges of the v-points that run along a singular dual edge",
                         .in_paper = true,
                         .in_fit_box = false,
                         .style = {.color = palette::yellow, .line_width_px = 3},
                         .kinds = {PrimitiveKind::line, PrimitiveKind::ray, PrimitiveKind::segment}},
                        v_part({PrimitiveKind::line, PrimitiveKind::ray, PrimitiveKind::segment}, diagram,
                               &UnionTables::v_edges, [&diagram](const VEdge& edge, Instance& out) {
                                 if (edge.kind == VEdgeKind::alpha) emit_v_dual(diagram.tables(), edge, out);
                               }));
}

Layer make_union_v_exterior_vertices_layer(const UnionFamily& family) {
  const VDiagram& diagram = family.v_diagram;
  return union_layer_of(
      family, diagram,
      {.id = "v-exterior-vertices",
       .name = "v-point exterior vertices",
       .tooltip = "Voronoi vertices of the v-points outside the dual complex",
       .in_fit_box = false,
       .scalar = "radius",
       .style = {.color = palette::sky, .point_size_px = 4},
       .kinds = {PrimitiveKind::point}},
      v_part({PrimitiveKind::point}, diagram, &UnionTables::v_faces, [](const VFace& face, Instance& out) {
        if (face.is_inside == 0) out.point(face.center, face.radius);
      }));
}

Layer make_union_v_interior_vertices_layer(const UnionFamily& family) {
  const VDiagram& diagram = family.v_diagram;
  return union_layer_of(
      family, diagram,
      {.id = "v-interior-vertices",
       .name = "v-point interior vertices",
       .tooltip = "Voronoi vertices of the v-points inside the dual complex",
       .in_fit_box = true,
       .scalar = "radius",
       .style = {.color = palette::orange, .point_size_px = 4},
       .kinds = {PrimitiveKind::point}},
      v_part({PrimitiveKind::point}, diagram, &UnionTables::v_faces, [](const VFace& face, Instance& out) {
        if (face.is_inside != 0) out.point(face.center, face.radius);
      }));
}

Layer make_union_v_origin_edge_layer(const UnionFamily& family) {
  const BallUnion& balls = family.balls;
  return union_layer(
      family,
      {.id = "v-origin-edge",
       .name = "v-point origin edges",
       .tooltip = "Links each v-point with the middle of the dual edge that made it",
       .in_paper = true,
       .style = {.color = palette::purple, .opacity = 0.7},
       .kinds = {PrimitiveKind::segment}},
      union_part(
          {PrimitiveKind::segment}, balls, &UnionTables::v_origins, balls.changes().v_points,
          [&balls](const VOrigin& origin, Instance& out) {
            if (!origin.is_alive()) return;
            const DualEdge& edge = balls.tables().dual_edges[origin.edge];
            const Vec2 a = balls.family().disk(edge.ball[0]).center;
            const Vec2 b = balls.family().disk(edge.ball[1]).center;
            out.segment(balls.tables().v_points[origin.v].position, {0.5 * a.x + 0.5 * b.x, 0.5 * a.y + 0.5 * b.y});
          }));
}

Layer make_union_v_origin_triangle_layer(const UnionFamily& family) {
  const BallUnion& balls = family.balls;
  return union_layer(family,
                     {.id = "v-origin-triangle",
                      .name = "v-point origin triangles",
                      .tooltip = "Triangle of a v-point and the dual edge that made it",
                      .in_paper = true,
                      .style = {.color = palette::purple, .opacity = 0.15},
                      .kinds = {PrimitiveKind::triangle}},
                     union_part({PrimitiveKind::triangle}, balls, &UnionTables::v_origins, balls.changes().v_points,
                                [&balls](const VOrigin& origin, Instance& out) {
                                  if (!origin.is_alive()) return;
                                  const DualEdge& edge = balls.tables().dual_edges[origin.edge];
                                  const Vec2 v = balls.tables().v_points[origin.v].position;
                                  const Vec2 a = balls.family().disk(edge.ball[0]).center;
                                  const Vec2 b = balls.family().disk(edge.ball[1]).center;
                                  if (cross(a - v, b - v) < 0.0) {
                                    out.triangle(v, b, a);
                                  } else {
                                    out.triangle(v, a, b);
                                  }
                                }));
}

Layer make_union_ball_medial_axis_layer(const UnionFamily& family) {
  const BallUnion& balls = family.balls;
  return union_layer(
      family,
      {.id = "ball-medial-axis",
       .name = "medial axis",
       .tooltip = "Medial axis of the union of the balls, from the general pipeline or its certified shortcut",
       .in_paper = true,
       .scalar = "radius",
       .style = {.color = palette::vermilion, .line_width_px = 2.5},
       .kinds = {PrimitiveKind::segment, PrimitiveKind::point}},
      union_part({PrimitiveKind::segment}, balls, &UnionTables::axis, balls.changes().dual_edges,
                 [](const AxisPiece& piece, Instance& out) {
                   if (piece.is_alive()) out.segment(piece.a, piece.b, 0.5 * (piece.radius_a + piece.radius_b));
                 }),
      table_part(
          {PrimitiveKind::point}, [&balls] { return balls.tables().balls.size(); }, balls.changes().balls,
          [&balls](FamilySlot row, Instance& out) {
            if (balls.tables().balls[row] != BallState::isolated) return;
            const Disk disk = balls.family().disk(row);
            out.point(disk.center, disk.radius);
          },
          ElementType{ElementKind::ball, &balls}));
}

}  // namespace mes
