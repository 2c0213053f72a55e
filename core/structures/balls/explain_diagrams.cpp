// SPDX-License-Identifier: GPL-3.0-or-later
// What rows of the diagrams of a union of balls are.
#include "core/graph/explain.h"
#include "core/structures/axis/inner_balls.h"
#include "core/structures/balls/ball_diagrams.h"
#include "core/structures/balls/internal/ball_places.h"

namespace mes {
namespace {

void add_edge(ProvenanceShapes& shapes, const PowerEdge& edge) {
  switch (edge.kind) {
    case PowerEdge::Kind::segment: shapes.segment(edge.from, edge.to); break;
    case PowerEdge::Kind::ray: shapes.ray(edge.from, edge.to); break;
    case PowerEdge::Kind::line: shapes.line(edge.from, edge.to); break;
  }
}

void explain_v_face(const UnionTables& t, VFaceSlot row, Explanation& out) {
  if (!t.v_faces.has(row)) return;
  const VFace& face = t.v_faces[row];
  ProvenanceShapes itself, points;
  itself.point(face.center);
  itself.circle({face.center, face.radius});
  out.say(ProvenanceRole::itself,
          std::string("Voronoi vertex of the v-points ") + (face.is_inside != 0 ? "inside" : "outside") +
              " the dual complex" + (face.ball != kNoSlot ? ", the centre of a ball" : ""),
          itself);
  for (const VPointSlot v : face.v) points.point(t.v_points[v].position);
  out.say(ProvenanceRole::origin, "3 v-points on its circle", points);
}

void explain_v_edge(const UnionTables& t, VEdgeSlot row, Explanation& out) {
  if (!t.v_edges.has(row)) return;
  const VEdge& edge = t.v_edges[row];
  ProvenanceShapes itself, points;
  itself.segment(t.v_points[edge.v[0]].position, t.v_points[edge.v[1]].position);
  constexpr const char* kKind[] = {"Voronoi edge of two v-points",
                                   "Voronoi edge of two v-points, through a ball's centre",
                                   "Voronoi edge of two v-points, along a singular dual edge"};
  out.say(ProvenanceRole::itself, kKind[static_cast<std::size_t>(edge.kind)], itself);
  for (const VPointSlot v : edge.v) points.point(t.v_points[v].position);
  out.say(ProvenanceRole::origin, "2 v-points", points);
}

}  // namespace

void PowerDiagram::explain(ElementKind kind, RowNumber row, Explanation& out) const {
  if (kind != ElementKind::power_edge) return;
  const PowerEdgeSlot own(row);
  if (!edges().has(own)) return;
  const PowerEdge& edge = edges()[own];
  ProvenanceShapes itself, circles;
  add_edge(itself, edge);
  const BallPlaces places(family(), out);
  itself.segment(places.center(edge.ball[0]), places.center(edge.ball[1]));
  out.say(ProvenanceRole::itself, "Edge of the power diagram, and of the triangulation of the balls", itself);
  for (const FamilySlot ball : edge.ball) places.add_circle(circles, ball);
  out.say(ProvenanceRole::origin, "2 balls of equal power along it", circles);
}

void PowerDiagram::explain_cell(FamilySlot ball, Explanation& out) const {
  ProvenanceShapes cell;
  for (const PowerEdge& edge : edges()) {
    if (edge.ball[0] != ball && edge.ball[1] != ball) continue;
    add_edge(cell, edge);
  }
  out.say_any(ProvenanceRole::product, "side of its power cell", "sides of its power cell", cell);
}

void APowerDiagram::explain(ElementKind kind, RowNumber row, Explanation& out) const {
  if (kind != ElementKind::voronoi_vertex) return PowerDiagram::explain(kind, row, out);
  const FaceSlot face(row);
  if (const auto* inner = out.current<InnerBalls>(); inner != nullptr && inner->is_ball(face))
    explain_cell(same_row<FamilySlot>(inner->ball(face)), out);
}

void BPowerDiagram::explain(ElementKind kind, RowNumber row, Explanation& out) const {
  if (kind != ElementKind::own_ball) return PowerDiagram::explain(kind, row, out);
  const auto ball = same_row<FamilySlot>(BallSlot(row));
  if (family().is_ball(ball)) explain_cell(ball, out);
}

void VDiagram::explain(ElementKind kind, RowNumber row, Explanation& out) const {
  if (kind == ElementKind::v_face) explain_v_face(tables(), VFaceSlot(row), out);
  if (kind == ElementKind::v_edge) explain_v_edge(tables(), VEdgeSlot(row), out);
}

}  // namespace mes
