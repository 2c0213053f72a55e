// SPDX-License-Identifier: GPL-3.0-or-later
// Explains rows of the diagrams of a union of balls.
#include <algorithm>
#include <array>
#include <unordered_map>

#include "core/graph/explain.h"
#include "core/structures/axis/inner_balls.h"
#include "core/structures/balls/ball_diagrams.h"
#include "core/structures/balls/internal/ball_places.h"

namespace mes {
namespace {

/// The balls that meet at triangles of a diagram, if they are of the document. O(edges), for any number of triangles.
class MeetingBalls {
 public:
  /// Finds them at both sides of the edges that are `wanted`.
  template <class Wanted>
  MeetingBalls(const PowerDiagram& diagram, const BallPlaces& places, Wanted wanted, Explanation& out)
      : places_(places) {
    if (!places.follow_balls()) return;
    for (const PowerEdge& edge : diagram.edges()) {
      out.look();
      if (!wanted(edge)) continue;
      for (const TriangleSlot face : edge.face)
        if (face != kNoSlot) at_.try_emplace(face.index());
    }
    for (const PowerEdge& edge : diagram.edges()) {
      out.look();
      for (const TriangleSlot face : edge.face)
        if (face != kNoSlot) add(face, edge);
    }
  }

  /// The power centre at a triangle.
  ShapePlace center(Vec2 at, TriangleSlot face) const {
    if (face == kNoSlot) return at;
    const auto found = at_.find(face.index());
    if (found == at_.end() || found->second.count < 3) return at;
    return places_.power_center(at, found->second.balls);
  }

 private:
  struct Balls {
    std::array<FamilySlot, 3> balls{};
    std::size_t count = 0;
  };
  void add(TriangleSlot face, const PowerEdge& edge) {
    const auto found = at_.find(face.index());
    if (found == at_.end()) return;
    auto& [balls, count] = found->second;
    for (const FamilySlot ball : edge.ball)
      if (count < balls.size() && std::ranges::find(balls, ball) == balls.end()) balls[count++] = ball;
  }

  const BallPlaces& places_;
  std::unordered_map<RowNumber, Balls> at_;
};

void add_edge(ProvenanceShapes& shapes, const MeetingBalls& meeting, const BallPlaces& places,
              const PowerEdge& edge) {
  const auto center = [&](Vec2 at, TriangleSlot face) { return meeting.center(at, face); };
  switch (edge.kind) {
    case PowerEdge::Kind::segment:
      shapes.segment(center(edge.from, edge.face[0]), center(edge.to, edge.face[1]));
      break;
    case PowerEdge::Kind::ray: {
      const ShapePlace from = center(edge.from, edge.face[0] != kNoSlot ? edge.face[0] : edge.face[1]);
      const ShapePlace a = places.center(edge.ball[0]);
      const ShapePlace b = places.center(edge.ball[1]);
      if (!places.follow_balls()) return shapes.ray(edge.from, edge.to);
      const bool is_left = dot(perpendicular(b.at - a.at), edge.to) > 0.0;
      shapes.ray_along_bisector(from, is_left ? a : b, is_left ? b : a);
      break;
    }
    case PowerEdge::Kind::line: {
      Followed before = places.both(edge.ball[0], edge.ball[1]);
      if (before.balls[0] == kNoSlot) return shapes.line(edge.from, edge.to);
      // On both sides of the edge, half the distance of the centres away.
      const Vec2 half = 0.5 * (places.center(edge.ball[1]).at - places.center(edge.ball[0]).at);
      Followed after = before;
      before.along = -0.5;
      after.along = 0.5;
      shapes.bisector({edge.from - half, before}, {edge.from + half, after});
      break;
    }
  }
}

void explain_v_face(const UnionTables& t, const BallPlaces& places, VFaceSlot row, Explanation& out) {
  if (!t.v_faces.has(row)) return;
  const VFace& face = t.v_faces[row];
  ProvenanceShapes itself, points;
  const ShapePlace center = places.between(t, face.center, face.v[0], face.v[1]);
  itself.point(center);
  itself.circle({face.center, face.radius}, center.follows);
  out.say(ProvenanceRole::itself,
          std::string("Voronoi vertex of the v-points ") + (face.is_inside != 0 ? "inside" : "outside") +
              " the dual complex" + (face.ball != kNoSlot ? ", the centre of a ball" : ""),
          itself);
  for (const VPointSlot v : face.v) points.point(places.at(t, v));
  out.say(ProvenanceRole::origin, "3 v-points on its circle", points);
}

void explain_v_edge(const UnionTables& t, const BallPlaces& places, VEdgeSlot row, Explanation& out) {
  if (!t.v_edges.has(row)) return;
  const VEdge& edge = t.v_edges[row];
  ProvenanceShapes itself, points;
  itself.segment(places.at(t, edge.v[0]), places.at(t, edge.v[1]));
  constexpr const char* kKind[] = {"Voronoi edge of two v-points",
                                   "Voronoi edge of two v-points, through a ball's centre",
                                   "Voronoi edge of two v-points, along a singular dual edge"};
  out.say(ProvenanceRole::itself, kKind[static_cast<std::size_t>(edge.kind)], itself);
  for (const VPointSlot v : edge.v) points.point(places.at(t, v));
  out.say(ProvenanceRole::origin, "2 v-points", points);
}

}  // namespace

void PowerDiagram::explain(ElementKind kind, RowNumber row, Explanation& out) const {
  if (kind != ElementKind::power_edge) return;
  const PowerEdgeSlot own(row);
  if (!edges().has(own)) return;
  const PowerEdge& edge = edges()[own];
  ProvenanceShapes itself, circles;
  const BallPlaces places(family(), out);
  const MeetingBalls meeting(
      *this, places, [&edge](const PowerEdge& other) { return &other == &edge; }, out);
  add_edge(itself, meeting, places, edge);
  itself.segment(places.center(edge.ball[0]), places.center(edge.ball[1]));
  out.say(ProvenanceRole::itself, "Edge of the power diagram, and of the triangulation of the balls", itself);
  for (const FamilySlot ball : edge.ball) places.add_circle(circles, ball);
  out.say(ProvenanceRole::origin, "2 balls of equal power along it", circles);
}

void PowerDiagram::explain_cell(FamilySlot ball, Explanation& out) const {
  ProvenanceShapes cell;
  const BallPlaces places(family(), out);
  const auto is_side = [ball](const PowerEdge& edge) { return edge.ball[0] == ball || edge.ball[1] == ball; };
  const MeetingBalls meeting(*this, places, is_side, out);
  for (const PowerEdge& edge : edges()) {
    out.look();
    if (is_side(edge)) add_edge(cell, meeting, places, edge);
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
  const BallPlaces places(union_.family(), out);
  if (kind == ElementKind::v_face) explain_v_face(tables(), places, VFaceSlot(row), out);
  if (kind == ElementKind::v_edge) explain_v_edge(tables(), places, VEdgeSlot(row), out);
}

}  // namespace mes
