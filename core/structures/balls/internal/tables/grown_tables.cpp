// SPDX-License-Identifier: GPL-3.0-or-later
// Balls that grow additively as columns, for all amounts and for one.
#include <array>
#include <limits>

#include "core/graph/table_maker.h"
#include "core/structures/balls/grown_complex.h"

namespace mes {
std::vector<TableColumns> BallFiltration::table_columns() const {
  const std::string of_corners = table_name(id(), "corners");
  const std::string of_edges = table_name(id(), "edges");
  const std::string of_triangles = table_name(id(), "triangles");
  using Corner = BallBirths::Corner;
  using Edge = BallBirths::Edge;
  using Triangle = BallBirths::Triangle;
  const std::string rank = "Rank of the growth among all at which something comes";
  const auto always = [](auto) { return true; };

  TableMaker<GrownCornerSlot> corners("corners", "Balls with a power cell, in the order in which they come",
                                      this->corners().size(), always);
  corners.set_changes(no_changes<GrownCornerSlot>());
  corners.computed_reference(
      "ball", "Row of the ball", [this](GrownCornerSlot corner) { return ball(corner); },
      std::string(family().rows_of()));
  corners.computed("center", "Centre of the ball", [this](GrownCornerSlot corner) { return disk(corner).center; });
  corners.computed("radius", "Radius before it grows",
                   [this](GrownCornerSlot corner) { return disk(corner).radius; });
  corners.column("rank", rank, this->corners(), &Corner::rank);
  corners.computed("growth", "Growth at which the ball comes",
                   [this](GrownCornerSlot corner) { return growth(this->corners()[corner].rank); });

  TableMaker<GrownEdgeSlot> edges("edges", "Edges of the regular triangulation, in the order in which they come",
                                  this->edges().size(), always);
  edges.set_changes(no_changes<GrownEdgeSlot>());
  edges.reference("corners", "From one end to the other", this->edges(), &Edge::v, of_corners);
  edges.reference("triangles", "Left and right of the way from one end to the other; none outside", this->edges(),
                  &Edge::f, of_triangles);
  edges.column("rank", rank, this->edges(), &Edge::rank);
  edges.computed("growth", "Growth at which the edge comes",
                 [this](GrownEdgeSlot edge) { return growth(this->edges()[edge].rank); });

  TableMaker<GrownTriangleSlot> triangles("triangles", "Regular triangulation, in the order in which triangles come",
                                          this->triangles().size(), always);
  triangles.set_changes(no_changes<GrownTriangleSlot>());
  triangles.reference("corners", "Counter-clockwise", this->triangles(), &Triangle::v, of_corners);
  triangles.reference("triangles", "Neighbours, each opposite the corner of the same number; none outside",
                      this->triangles(), &Triangle::n, of_triangles);
  triangles.reference("edges", "Edges, each opposite the corner of the same number", this->triangles(), &Triangle::e,
                      of_edges);
  triangles.column("center", "Centre of the orthogonal circle", this->triangles(), &Triangle::center);
  triangles.column("rank", rank, this->triangles(), &Triangle::rank);
  triangles.computed("growth", "Growth at which the triangle comes",
                     [this](GrownTriangleSlot triangle) { return growth(this->triangles()[triangle].rank); });

  TableMaker<GrownClassSlot> classes(
      "classes", "Components and holes of the union of the grown balls, for all growths", classes_.size(), always);
  classes.set_changes(no_changes<GrownClassSlot>());
  const auto growth_at = [this](std::uint32_t at) {
    return at == kNever ? std::numeric_limits<double>::infinity() : growth(at);
  };
  classes.column("is_hole", "A hole; otherwise a component", classes_, &Class::is_hole);
  classes.computed("birth", "Growth at which the class is born",
                   [=, this](GrownClassSlot row) { return growth_at(classes_[row.index()].birth); });
  classes.computed("death", "Growth at which the class dies; infinite if it stays",
                   [=, this](GrownClassSlot row) { return growth_at(classes_[row.index()].death); });
  classes.reference("corner", "Where a component is born", classes_, &Class::corner, of_corners);
  classes.reference("edge", "Edge that joins the component to an older one, or closes the hole", classes_,
                    &Class::edge, of_edges);
  classes.reference("triangle", "Triangle that fills the hole", classes_, &Class::triangle, of_triangles);
  return taken(corners, edges, triangles, classes);
}

std::vector<TableColumns> GrownComplex::table_columns() const {
  const std::string_view of = filtration_.id();
  const auto always = [](auto) { return true; };

  TableMaker<GrownCornerSlot> corners("corners", "Grown balls", filtration_.corners().size(), always);
  corners.limit_rows(has_edge_);
  corners.set_kind(ElementKind::alpha_corner);
  corners.set_rows_of(table_name(of, "corners"));
  corners.set_changes(corner_changes_);
  corners.computed("is_held", "The ball has come", [this](GrownCornerSlot corner) { return holds(corner); });
  corners.computed("is_alone", "The ball has come and meets no other",
                   [this](GrownCornerSlot corner) { return is_alone(corner); });
  corners.computed("radius", "Radius of the grown ball",
                   [this](GrownCornerSlot corner) { return disk(corner).radius; });

  TableMaker<GrownEdgeSlot> edges("edges", "Edges of the dual complex of the grown balls", filtration_.edges().size(),
                                  always);
  edges.set_kind(ElementKind::alpha_edge);
  edges.set_rows_of(table_name(of, "edges"));
  edges.set_changes(edge_changes_);
  edges.computed("is_held", "The complex holds the edge", [this](GrownEdgeSlot edge) { return holds(edge); });

  TableMaker<GrownTriangleSlot> triangles("triangles", "Triangles of the dual complex of the grown balls",
                                          filtration_.triangles().size(), always);
  triangles.set_kind(ElementKind::alpha_triangle);
  triangles.set_rows_of(table_name(of, "triangles"));
  triangles.set_changes(triangle_changes_);
  triangles.computed("is_held", "The complex holds the triangle",
                     [this](GrownTriangleSlot triangle) { return holds(triangle); });

  TableMaker<GrownEndSlot> ends(
      "ends", "Arcs of the boundary of the union, by the edge at whose crossing each begins",
      2 * filtration_.edges().size(), [this](GrownEndSlot row) { return drawn(row).has_value(); });
  ends.set_kind(ElementKind::alpha_end);
  ends.set_changes(end_changes_);
  ends.computed_reference(
      "edge", "Edge at whose crossing the arc begins, to its left",
      [](GrownEndSlot row) { return GrownEdgeSlot(row.index() / 2); }, table_name(of, "edges"));
  ends.computed_reference(
      "corner", "Ball whose circle the arc is part of",
      [this](GrownEndSlot row) { return filtration_.edges()[GrownEdgeSlot(row.index() / 2)].v[row.index() % 2]; },
      table_name(of, "corners"));
  ends.computed("from", "Where the arc begins, counter-clockwise",
                [this](GrownEndSlot row) { return drawn(row)->from; });
  ends.computed("to", "Where the arc ends", [this](GrownEndSlot row) { return drawn(row)->to; });

  TableMaker<GrownClassSlot> classes("classes", "Components and holes that are alive at the growth",
                                     filtration_.classes().size(), always);
  classes.set_kind(ElementKind::alpha_class);
  classes.set_rows_of(table_name(of, "classes"));
  classes.set_changes(class_changes_);
  classes.computed("is_present", "The class is born and has not died",
                   [this](GrownClassSlot row) { return is_alive(filtration_.classes()[row.index()]); });
  return taken(corners, edges, triangles, ends, classes);
}

}  // namespace mes
