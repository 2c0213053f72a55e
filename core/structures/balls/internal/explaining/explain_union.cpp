// SPDX-License-Identifier: GPL-3.0-or-later
// Explains rows of a union of balls.
#include <algorithm>
#include <array>
#include <map>
#include <unordered_set>

#include "core/base/counted.h"
#include "core/graph/explain.h"
#include "core/structures/axis/inner_balls.h"
#include "core/structures/balls/ball_union.h"
#include "core/structures/balls/internal/ball_places.h"

namespace mes {
namespace {

void explain_dual_edge(const BallUnion& balls, DualEdgeSlot row, Explanation& out) {
  const UnionTables& t = balls.tables();
  if (!t.dual_edges.has(row) || !t.dual_edges[row].is_alive()) return;
  const DualEdge& edge = t.dual_edges[row];
  const BallPlaces places(balls.family(), out);
  ProvenanceShapes itself, circles, points;
  itself.segment(places.center(edge.ball[0]), places.center(edge.ball[1]));
  constexpr const char* kClass[] = {"Singular dual edge: no dual triangle at it",
                                    "Regular dual edge: one dual triangle at it",
                                    "Interior dual edge: between two dual triangles"};
  out.say(ProvenanceRole::itself, kClass[static_cast<std::size_t>(edge.kind)], itself);
  for (const FamilySlot ball : edge.ball) places.add_circle(circles, ball);
  out.say(ProvenanceRole::origin,
          std::string("2 balls that meet within their power cells") +
              (balls.family().touch_samples() && edge.shares_sample != 0 ? ", and share a sample" : ""),
          circles);
  for (const VOrigin& origin : t.v_origins) {
    out.look();
    if (origin.is_alive() && origin.edge == row)
      points.point(t.v_points[origin.v].site != kNoSlot || balls.family().is_from_samples()
                       ? places.at(t, origin.v)
                       : places.crossing(t.v_points[origin.v].position, edge.ball[0], edge.ball[1]));
  }
  out.say_any(ProvenanceRole::product, "v-point made by it", "v-points made by it", points);
}

void explain_dual_face(const BallUnion& balls, DualFaceSlot row, Explanation& out) {
  const UnionTables& t = balls.tables();
  if (!t.dual_faces.has(row) || !t.dual_faces[row].is_alive()) return;
  const DualFace& face = t.dual_faces[row];
  const BallPlaces places(balls.family(), out);
  ProvenanceShapes itself, circles, common;
  itself.triangle(places.center(face.ball[0]), places.center(face.ball[1]), places.center(face.ball[2]));
  out.say(ProvenanceRole::itself,
          face.sign < 0
              ? "Dual triangle: its three balls have a common interior point"
              : "Dual triangle: its three balls meet in one point only, their orthogonal circle has radius zero",
          itself);
  std::vector<TouchedSample> shared;
  for (std::size_t i = 0; i < 3; ++i) {
    places.add_circle(circles, face.ball[i]);
    std::vector<TouchedSample> touched;
    if (balls.family().touch_samples()) balls.family().touched_samples(face.ball[i], touched);
    if (i == 0) {
      shared = touched;
    } else {
      std::erase_if(shared, [&touched](const TouchedSample& sample) {
        return std::ranges::find(touched, sample.site, &TouchedSample::site) == touched.end();
      });
    }
  }
  out.say(ProvenanceRole::origin, "3 balls", circles);
  const auto* const delaunay = out.current<Delaunay>();
  for (const TouchedSample& sample : shared)
    common.point(delaunay != nullptr ? place_of(*delaunay, sample.site) : ShapePlace(sample.position));
  out.say_any(ProvenanceRole::origin, "sample that all three touch", "samples that all three touch", common);
}

/// An end of a piece of the axis.
ShapePlace end_of(const UnionTables& t, const BallPlaces& places, const AxisPiece& piece, std::size_t end) {
  const Vec2 at = end == 0 ? piece.a : piece.b;
  if (t.is_ball(piece.node[end])) return {at, places.follows(ball_of(piece.node[end]))};
  return places.between(t, at, piece.v[0], piece.v[1]);
}

void explain_v_point(const BallUnion& balls, VPointSlot row, Explanation& out) {
  const UnionTables& t = balls.tables();
  if (!t.v_points.has(row) || !t.v_points[row].is_alive()) return;
  const VPoint& v = t.v_points[row];
  const BallPlaces places(balls.family(), out);
  ProvenanceShapes itself, edges, circles, pieces;
  itself.point(places.at(t, row));
  const bool is_foreign = balls.family().touch_samples() && v.site == kNoSlot;
  out.say(
      ProvenanceRole::itself,
      "V-point at " + place_text(v.position) + (v.site != kNoSlot ? ", a sample" : (is_foreign ? ", no sample" : "")),
      itself);
  std::unordered_set<RowNumber> touching;
  const auto add_ball = [&](FamilySlot ball) {
    if (touching.insert(ball.index()).second) places.add_circle(circles, ball);
  };
  for (const VOrigin& origin : t.v_origins) {
    out.look();
    if (!origin.is_alive() || origin.v != row) continue;
    const DualEdge& edge = t.dual_edges[origin.edge];
    edges.segment(places.center(edge.ball[0]), places.center(edge.ball[1]));
    for (const FamilySlot ball : edge.ball) add_ball(ball);
  }
  for (const AxisPiece& piece : t.axis) {
    out.look();
    if (!piece.is_alive() || (piece.v[0] != row && piece.v[1] != row)) continue;
    pieces.segment(end_of(t, places, piece, 0), end_of(t, places, piece, 1));
    for (const AxisNodeSlot node : piece.node)
      if (t.is_ball(node)) add_ball(ball_of(node));
  }
  out.say_any(ProvenanceRole::origin, "ball whose circle passes through it", "balls whose circles cross here",
              circles);
  out.say_any(ProvenanceRole::origin, "dual edge that made it", "dual edges that made it", edges);
  out.say_any(ProvenanceRole::product, "piece of the axis has it as a nearest boundary point",
              "pieces of the axis have it as a nearest boundary point", pieces);
}

void explain_v_origin(const BallUnion& balls, VOriginSlot row, Explanation& out) {
  const auto& origins = balls.tables().v_origins;
  if (origins.has(row) && origins[row].is_alive()) explain_v_point(balls, origins[row].v, out);
}

void explain_axis_piece(const BallUnion& balls, AxisPieceSlot row, Explanation& out) {
  const UnionTables& t = balls.tables();
  if (!t.axis.has(row) || !t.axis[row].is_alive()) return;
  const AxisPiece& piece = t.axis[row];
  const BallPlaces places(balls.family(), out);
  ProvenanceShapes itself, points, circles;
  const std::array<Disk, 2> ends{Disk{piece.a, piece.radius_a}, Disk{piece.b, piece.radius_b}};
  const std::array<ShapePlace, 2> places_of_ends{end_of(t, places, piece, 0), end_of(t, places, piece, 1)};
  itself.segment(places_of_ends[0], places_of_ends[1]);
  out.say(ProvenanceRole::itself,
          std::string(piece.is_singular != 0 ? "Piece of the axis along a singular dual edge"
                                             : "Piece of the axis on the Voronoi diagram of the v-points") +
              ", radius " + number_text(piece.radius_a) + " to " + number_text(piece.radius_b),
          itself);
  for (const VPointSlot v : piece.v)
    if (t.v_points.has(v) && t.v_points[v].is_alive()) points.point(places.at(t, v));
  out.say_any(ProvenanceRole::origin, "v-point nearest to all of it", "v-points nearest to all of it", points);
  for (std::size_t i = 0; i < ends.size(); ++i) circles.circle(ends[i], places_of_ends[i].follows);
  out.say(ProvenanceRole::origin, "the maximal balls at its two ends", circles);
}

/// An end of an arc of a ball: the v-point there. O(v-points).
ShapePlace arc_end(const UnionTables& t, const BallPlaces& places, Vec2 at, FamilySlot ball, Explanation& out) {
  for (const VOrigin& origin : t.v_origins) {
    out.look();
    if (!origin.is_alive() || t.v_points[origin.v].position != at) continue;
    const DualEdge& edge = t.dual_edges[origin.edge];
    if (edge.ball[0] == ball || edge.ball[1] == ball) return places.crossing(at, edge.ball[0], edge.ball[1]);
  }
  return at;
}

void explain_arc(const BallUnion& balls, ArcSlot row, Explanation& out) {
  const UnionTables& t = balls.tables();
  if (!t.arcs.has(row) || !t.arcs[row].is_alive()) return;
  ProvenanceShapes itself, circle;
  const BoundaryArc& arc = t.arcs[row];
  const BallPlaces places(balls.family(), out);
  if (const auto drawn = drawn_arc(arc, balls.family().disk(arc.ball))) {
    if (drawn->from == drawn->to)
      places.add_circle(itself, arc.ball);
    else
      itself.arc({drawn->center, drawn->radius}, arc_end(t, places, drawn->from, arc.ball, out),
                 arc_end(t, places, drawn->to, arc.ball, out), places.follows(arc.ball));
  }
  out.say(ProvenanceRole::itself,
          arc.is_whole != 0 ? "A whole circle on the boundary of the union"
                            : "Arc on the boundary of the union, between two v-points",
          itself);
  places.add_circle(circle, arc.ball);
  out.say(ProvenanceRole::origin, "its ball", circle);
}

}  // namespace

void BallUnion::explain_place(FamilySlot row, Explanation& out) const {
  const UnionTables& t = tables();
  if (!t.balls.has(row)) return;
  const BallPlaces places(family(), out);
  ProvenanceShapes edges, triangles, points;
  for (const DualEdge& edge : t.dual_edges) {
    out.look();
    if (!edge.is_alive() || (edge.ball[0] != row && edge.ball[1] != row)) continue;
    edges.segment(places.center(edge.ball[0]), places.center(edge.ball[1]));
  }
  for (const DualFace& face : t.dual_faces) {
    out.look();
    if (face.is_alive() && std::ranges::find(face.ball, row) != std::end(face.ball))
      triangles.triangle(places.center(face.ball[0]), places.center(face.ball[1]), places.center(face.ball[2]));
  }
  std::size_t free_arcs = 0;
  std::vector<ShapePlace> ends;
  std::map<std::array<double, 2>, std::size_t> found;  // index of the end at a position
  for (const BoundaryArc& arc : t.arcs) {
    out.look();
    if (!arc.is_alive() || arc.ball != row) continue;
    ++free_arcs;
    if (arc.is_whole != 0) continue;
    for (const Vec2 end : {arc.from, arc.to})
      if (found.try_emplace({end.x, end.y}, ends.size()).second) ends.emplace_back(end);
  }
  // Does the same as `arc_end`, in one pass.
  for (const VOrigin& origin : t.v_origins) {
    out.look();
    if (found.empty()) break;
    if (!origin.is_alive()) continue;
    const DualEdge& edge = t.dual_edges[origin.edge];
    if (edge.ball[0] != row && edge.ball[1] != row) continue;
    const Vec2 at = t.v_points[origin.v].position;
    const auto end = found.find({at.x, at.y});
    if (end == found.end()) continue;
    ends[end->second] = places.crossing(at, edge.ball[0], edge.ball[1]);
    found.erase(end);
  }
  for (const ShapePlace& end : ends) points.point(end);
  out.say_any(ProvenanceRole::product, "dual edge at it", "dual edges at it", edges);
  out.say_any(ProvenanceRole::product, "dual triangle at it", "dual triangles at it", triangles);
  out.say_any(ProvenanceRole::product, "end of its arcs on the boundary of the union",
              "ends of its " + counted(free_arcs, "arc", "arcs") + " on the boundary of the union", points);
}

void BallUnion::explain_scale(FamilySlot row, Explanation& out) const {
  if (family().scale() == 1.0) return;
  ProvenanceShapes circle;
  BallPlaces(family(), out).add_circle(circle, row);
  out.say(ProvenanceRole::product,
          "Scaled by " + number_text(family().scale()) + " for its union: radius " +
              number_text(family().disk(row).radius),
          circle);
}

void BallUnion::explain(ElementKind kind, RowNumber row, Explanation& out) const {
  const FamilySlot ball(row);
  switch (kind) {
    case ElementKind::ball:
      if (!family().is_ball(ball)) return;
      out.about(ElementKind::voronoi_vertex, same_row<FaceSlot>(ball));
      explain_scale(ball, out);
      return explain_place(ball, out);
    case ElementKind::dual_edge: return explain_dual_edge(*this, DualEdgeSlot(row), out);
    case ElementKind::dual_face: return explain_dual_face(*this, DualFaceSlot(row), out);
    case ElementKind::v_point: return explain_v_point(*this, VPointSlot(row), out);
    case ElementKind::v_origin: return explain_v_origin(*this, VOriginSlot(row), out);
    case ElementKind::axis_piece: return explain_axis_piece(*this, AxisPieceSlot(row), out);
    case ElementKind::boundary_arc: return explain_arc(*this, ArcSlot(row), out);
    default: return;
  }
}

void AUnion::explain(ElementKind kind, RowNumber row, Explanation& out) const {
  const auto* inner = out.current<InnerBalls>();
  const auto* delaunay = out.current<Delaunay>();
  const SiteSlot site(row);
  const FaceSlot face(row);
  switch (kind) {
    case ElementKind::site:
      if (rung() == UnionRung::shortcut && delaunay != nullptr && delaunay->is_site(site) &&
          tables().v_points[same_row<VPointSlot>(site)].multiplicity >= 2) {
        ProvenanceShapes shapes;
        shapes.point(place_of(*delaunay, site));
        out.say(ProvenanceRole::product, "it is a v-point of union A", shapes);
      }
      return;
    case ElementKind::voronoi_vertex:
      if (inner != nullptr && inner->is_ball(face)) explain_place(same_row<FamilySlot>(inner->ball(face)), out);
      return;
    case ElementKind::ball:
      // The explanation of its Voronoi vertex includes its role in this union.
      if (!family().is_ball(FamilySlot(row))) return;
      out.about(ElementKind::voronoi_vertex, face);
      return explain_scale(FamilySlot(row), out);
    default: return BallUnion::explain(kind, row, out);
  }
}

void BUnion::explain(ElementKind kind, RowNumber row, Explanation& out) const {
  const FamilySlot ball(row);
  switch (kind) {
    case ElementKind::own_ball:
      if (!family().is_ball(ball)) return;
      explain_scale(ball, out);
      return explain_place(ball, out);
    case ElementKind::ball:
      if (family().is_ball(ball)) out.about(ElementKind::own_ball, same_row<BallSlot>(ball));
      return;
    default: return BallUnion::explain(kind, row, out);
  }
}

}  // namespace mes
