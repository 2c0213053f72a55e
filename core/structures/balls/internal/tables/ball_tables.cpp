// SPDX-License-Identifier: GPL-3.0-or-later
// Unions of balls, their diagrams and the samplings of their axes as columns.
#include <array>

#include "core/graph/table_maker.h"
#include "core/structures/balls/axis_difference.h"
#include "core/structures/balls/ball_diagrams.h"
#include "core/structures/balls/ball_sampling.h"
#include "core/structures/balls/ball_union.h"
#include "core/structures/balls/precision_difference.h"
#include "core/structures/balls/scale_axis.h"

namespace mes {
namespace {

TableMaker<FamilySlot> family_columns(const BallFamily& family) {
  TableMaker<FamilySlot> balls("balls", "Balls of the family", family.rows(),
                               [&family](FamilySlot row) { return family.is_ball(row); });
  balls.set_rows_of(std::string(family.rows_of()));
  balls.computed("center", "Centre of the ball", [&family](FamilySlot row) { return family.disk(row).center; });
  balls.computed("radius", "Radius of the ball as it is scaled",
                 [&family](FamilySlot row) { return family.disk(row).radius; });
  return balls;
}

/// A table in which every row is alive.
template <class Row, class Value>
TableMaker<Row> whole_table(std::string name, std::string description, const Table<Row, Value>& rows) {
  TableMaker<Row> out(std::move(name), std::move(description), rows.size(), [](Row) { return true; });
  out.set_changes(no_changes<Row>());
  return out;
}

template <class Row, class Value>
TableMaker<Row> table_with_dead_rows(std::string name, std::string description, const Table<Row, Value>& rows) {
  return {std::move(name), std::move(description), rows.size(), [&rows](Row row) { return rows[row].is_alive(); }};
}

TableMaker<VPointSlot> v_point_columns(const UnionTables& tables) {
  TableMaker<VPointSlot> points = table_with_dead_rows(
      "v_points", "V-points: where two circles cross on the boundary of the union", tables.v_points);
  points.set_kind(ElementKind::v_point);
  points.column("position", "Coordinates of the document", tables.v_points, &VPoint::position);
  points.reference("site", "Site that the v-point is; none if it is foreign", tables.v_points, &VPoint::site,
                   {"delaunay/sites"});
  points.column("multiplicity", "How many balls or dual edges gave it", tables.v_points, &VPoint::multiplicity);
  return points;
}

TableMaker<VFaceSlot> v_face_columns(const UnionTables& tables, const std::string& points, const std::string& balls) {
  TableMaker<VFaceSlot> faces = whole_table("v_faces", "Delaunay triangles of the v-points", tables.v_faces);
  faces.set_kind(ElementKind::v_face);
  faces.reference("v_points", "Corners, counter-clockwise", tables.v_faces, &VFace::v, points);
  faces.reference("ball", "Ball whose circle is the circumcircle", tables.v_faces, &VFace::ball, balls);
  faces.column("center", "Centre of the circumcircle", tables.v_faces, &VFace::center);
  faces.column("radius", "Radius of the circumcircle", tables.v_faces, &VFace::radius);
  faces.flag("is_inside", "The centre lies in the closed dual complex", tables.v_faces, &VFace::is_inside);
  return faces;
}

TableMaker<VEdgeSlot> v_edge_columns(const UnionTables& tables, const std::string& points, const std::string& faces) {
  TableMaker<VEdgeSlot> edges =
      whole_table("v_edges", "Delaunay edges of the v-points, each with its Voronoi edge", tables.v_edges);
  edges.set_kind(ElementKind::v_edge);
  edges.reference("v_points", "From one end to the other", tables.v_edges, &VEdge::v, points);
  edges.reference("v_faces", "Left and right of the way from one end to the other; none outside", tables.v_edges,
                  &VEdge::f, faces);
  edges.column("kind", "0 plain, 1 crosses the dual complex, 2 alpha", tables.v_edges, &VEdge::kind);
  return edges;
}

TableMaker<SampledSlot> sampled_columns(std::string name, std::string description, const SampledBalls& balls) {
  TableMaker<SampledSlot> out(std::move(name), std::move(description), balls.rows(),
                              [&balls](SampledSlot row) { return balls.is_alive(row); });
  out.set_changes(balls.changes());
  out.column("center", "Centre of the ball", balls.disks(), &Disk::center);
  out.column("radius", "Radius of the ball", balls.disks(), &Disk::radius);
  return out;
}

}  // namespace

std::vector<TableColumns> BallUnion::table_columns() const {
  const std::string of_balls = table_name(id(), "balls");
  const std::string of_edges = table_name(id(), "dual_edges");
  const std::string of_points = table_name(id(), "v_points");
  const std::string of_faces = table_name(id(), "v_faces");
  const UnionTables& t = tables_;

  TableMaker<FamilySlot> balls("balls", "Balls of the union", family().rows(),
                               [&t](FamilySlot row) { return t.balls[row] != BallState::none; });
  balls.set_kind(ElementKind::ball);
  balls.set_rows_of(std::string(family().rows_of()));
  balls.set_changes(changes_.balls);
  balls.column("state", "1 visible, 2 visible and without a neighbour, 3 hidden, 4 duplicate of another ball",
               t.balls);
  balls.computed("center", "Centre of the ball", [this](FamilySlot row) { return family().disk(row).center; });
  balls.computed("radius", "Radius of the ball as it is scaled",
                 [this](FamilySlot row) { return family().disk(row).radius; });

  TableMaker<DualEdgeSlot> edges = table_with_dead_rows("dual_edges", "Edges of the dual complex", t.dual_edges);
  edges.set_kind(ElementKind::dual_edge);
  edges.set_changes(changes_.dual_edges);
  edges.reference("balls", "Both ends", t.dual_edges, &DualEdge::ball, of_balls);
  edges.column("kind", "Number of dual triangles at the edge: 0 singular, 1 regular, 2 interior", t.dual_edges,
               &DualEdge::kind);
  edges.flag("shares_sample", "The v-points of the edge are samples of both balls", t.dual_edges,
             &DualEdge::shares_sample);

  TableMaker<DualFaceSlot> faces = table_with_dead_rows("dual_faces", "Triangles of the dual complex", t.dual_faces);
  faces.set_kind(ElementKind::dual_face);
  faces.set_changes(changes_.dual_faces);
  faces.reference("balls", "Corners, counter-clockwise", t.dual_faces, &DualFace::ball, of_balls);
  faces.column("sign", "Sign of the squared radius of the orthogonal circle: -1 or 0", t.dual_faces, &DualFace::sign);
  faces.flag("is_exactly_zero", "The three balls touch a common sample", t.dual_faces, &DualFace::is_exactly_zero);

  TableMaker<VPointSlot> points = v_point_columns(t);
  points.set_changes(changes_.v_points);

  TableMaker<VOriginSlot> origins =
      table_with_dead_rows("v_origins", "Which dual edge gave which v-point", t.v_origins);
  origins.set_kind(ElementKind::v_origin);
  origins.set_changes_of(changes_.v_points);
  origins.reference("v_point", "The v-point", t.v_origins, &VOrigin::v, of_points);
  origins.reference("dual_edge", "Dual edge that gave it", t.v_origins, &VOrigin::edge, of_edges);

  TableMaker<AxisPieceSlot> axis = table_with_dead_rows("axis_pieces", "Straight pieces of the medial axis", t.axis);
  axis.set_kind(ElementKind::axis_piece);
  axis.set_changes_of(changes_.dual_edges);
  axis.column("from", "One end", t.axis, &AxisPiece::a);
  axis.column("to", "The other end", t.axis, &AxisPiece::b);
  axis.column("radius_from", "Radius at the one end", t.axis, &AxisPiece::radius_a);
  axis.column("radius_to", "Radius at the other end", t.axis, &AxisPiece::radius_b);
  axis.computed_reference(
      "balls", "Balls at both ends; none where an end is a v-face",
      [&t](AxisPieceSlot row) {
        const auto ball = [&t](AxisNodeSlot node) { return t.is_ball(node) ? ball_of(node) : FamilySlot(); };
        return std::array{ball(t.axis[row].node[0]), ball(t.axis[row].node[1])};
      },
      of_balls);
  axis.computed_reference(
      "v_faces", "V-faces at both ends; none where an end is a ball",
      [&t](AxisPieceSlot row) {
        const auto face = [&t](AxisNodeSlot node) {
          return t.is_ball(node) ? VFaceSlot() : VFaceSlot(node.index() - t.balls.size());
        };
        return std::array{face(t.axis[row].node[0]), face(t.axis[row].node[1])};
      },
      of_faces);
  axis.reference("v_points", "Nearest v-points all along the piece", t.axis, &AxisPiece::v, of_points);
  axis.flag("is_singular", "The piece is a singular dual edge", t.axis, &AxisPiece::is_singular);
  axis.flag("is_zero_length", "The piece has length exactly zero", t.axis, &AxisPiece::is_zero);

  TableMaker<VFaceSlot> v_faces = v_face_columns(t, of_points, of_balls);
  TableMaker<VEdgeSlot> v_edges = v_edge_columns(t, of_points, of_faces);

  TableMaker<ArcSlot> arcs =
      table_with_dead_rows("arcs", "Arcs of the boundary of the union, counter-clockwise", t.arcs);
  arcs.set_kind(ElementKind::boundary_arc);
  arcs.set_changes(changes_.arcs);
  arcs.reference("ball", "Ball whose circle the arc is part of", t.arcs, &BoundaryArc::ball, of_balls);
  arcs.flag("is_whole", "The whole circle, but for at most one point", t.arcs, &BoundaryArc::is_whole);
  arcs.column("from", "Where the arc begins", t.arcs, &BoundaryArc::from);
  arcs.column("to", "Where the arc ends", t.arcs, &BoundaryArc::to);
  return taken(balls, edges, faces, points, origins, axis, v_faces, v_edges, arcs);
}

std::vector<TableColumns> AxisDifference::table_columns() const {
  TableMaker<PieceSlot> pieces =
      whole_table("pieces", "Pieces that only one of the one-step axis and the axis of the union has", pieces_);
  pieces.column("from", "One end", pieces_, &Piece::a);
  pieces.column("to", "The other end", pieces_, &Piece::b);
  pieces.column("only_one_step", "Only the one-step axis has the piece", pieces_, &Piece::only_one_step);
  return taken(pieces);
}

std::vector<TableColumns> PrecisionDifference::table_columns() const {
  const std::string of_balls = table_name(union_.id(), "balls");
  using DifferentEdgeSlot = Slot<struct DifferentEdgeTag>;
  using DifferentFaceSlot = Slot<struct DifferentFaceTag>;
  TableMaker<DifferentEdgeSlot> edges("edges", "Dual edges that exact numbers judge otherwise", edges_.size(),
                                      [](DifferentEdgeSlot) { return true; });
  edges.reference("balls", "Both ends", edges_, &Edge::ball, of_balls);
  edges.column("chosen", "Dual triangles at the edge in the chosen numbers; -1: not in the dual complex", edges_,
               &Edge::chosen);
  edges.column("exact", "Dual triangles at the edge in exact numbers; -1: not in the dual complex", edges_,
               &Edge::exact);
  TableMaker<DifferentFaceSlot> faces("faces", "Dual triangles that exact numbers judge otherwise", faces_.size(),
                                      [](DifferentFaceSlot) { return true; });
  faces.reference("balls", "Corners", faces_, &Face::ball, of_balls);
  faces.column("is_exact", "Only the exact dual complex has the triangle; otherwise only the chosen one has it",
               faces_, &Face::is_exact);
  return taken(edges, faces);
}

std::vector<TableColumns> PowerDiagram::table_columns() const {
  TableMaker<FamilySlot> balls = family_columns(family());
  TableMaker<PowerEdgeSlot> edges =
      whole_table("edges", "Edges of the regular triangulation, each with its edge of the power diagram", edges_);
  edges.set_kind(ElementKind::power_edge);
  edges.reference("balls", "Both ends in the triangulation", edges_, &PowerEdge::ball, table_name(id(), "balls"));
  edges.column("kind", "Edge of the power diagram: 0 segment, 1 ray, 2 line", edges_, &PowerEdge::kind);
  edges.column("from", "Vertex of the power diagram, or any point of a line", edges_, &PowerEdge::from);
  edges.column("to", "The other vertex; the direction of a ray or line", edges_, &PowerEdge::to).has_directions =
      true;
  edges.reference("vertices", "Numbers of the vertices at both ends; none at infinity", edges_, &PowerEdge::face,
                  {std::string()});
  edges.column("length", "Length of a segment", edges_, &PowerEdge::length);
  return taken(balls, edges);
}

std::vector<TableColumns> VDiagram::table_columns() const {
  const std::string of_points = table_name(id(), "v_points");
  TableMaker<VPointSlot> points = v_point_columns(tables());
  TableMaker<VFaceSlot> faces = v_face_columns(tables(), of_points, table_name(union_.id(), "balls"));
  TableMaker<VEdgeSlot> edges = v_edge_columns(tables(), of_points, table_name(id(), "v_faces"));
  return taken(points, faces, edges);
}

std::vector<TableColumns> BallSampling::table_columns() const {
  TableMaker<SampledSlot> medial =
      sampled_columns("medial", "Balls along the medial axis of the union", this->medial());
  medial.set_kind(ElementKind::sampled_ball);
  TableMaker<SampledSlot> convex =
      sampled_columns("convex", "Balls along the boundary of the dual complex", this->convex());
  return taken(medial, convex);
}

std::vector<TableColumns> AxisSampling::table_columns() const {
  TableMaker<SampledSlot> between =
      sampled_columns("between", "Balls between the ends of edges of the one-step axis", between_);
  return taken(between);
}

}  // namespace mes
