// SPDX-License-Identifier: GPL-3.0-or-later
// The alpha complexes of the samples as columns; most rows are those of `Delaunay`.
#include <limits>

#include "core/graph/table_maker.h"
#include "core/structures/alpha/alpha_complex.h"
#include "core/structures/alpha/alpha_filtration.h"

namespace mes {

std::vector<TableColumns> AlphaFiltration::table_columns() const {
  const std::string of_sites = table_name(delaunay_.id(), "sites");
  const std::string of_edges = table_name(delaunay_.id(), "edges");
  const std::string of_faces = table_name(delaunay_.id(), "faces");

  TableMaker<EdgeSlot> edges("edges", "When edges come to the alpha complex", delaunay_.edge_rows(),
                             [this](EdgeSlot edge) { return delaunay_.edge(edge).is_alive(); });
  edges.set_kind(ElementKind::delaunay_edge);
  edges.set_rows_of(of_edges);
  edges.set_changes(no_changes<EdgeSlot>());
  edges.column("rank", "Rank of the radius among all at which something comes", edge_rank_);
  edges.computed("alpha", "Radius at which the edge comes", [this](EdgeSlot edge) { return radius(rank(edge)); });

  TableMaker<FaceSlot> faces("faces", "When triangles come to the alpha complex", delaunay_.face_rows(),
                             [this](FaceSlot face) { return delaunay_.is_finite_face(face); });
  faces.set_kind(ElementKind::voronoi_vertex);
  faces.set_rows_of(of_faces);
  faces.set_changes(no_changes<FaceSlot>());
  faces.column("rank", "Rank of the radius among all at which something comes", face_rank_);
  faces.computed("alpha", "Radius at which the triangle comes", [this](FaceSlot face) { return radius(rank(face)); });

  TableMaker<ClassSlot> classes("classes", "Components and holes of the union of disks, for all radii",
                                classes_.size(), [](ClassSlot) { return true; });
  classes.set_changes(no_changes<ClassSlot>());
  const auto radius_at = [this](std::uint32_t rank) {
    return rank == kNever ? std::numeric_limits<double>::infinity() : radius(rank);
  };
  classes.column("is_hole", "A hole; otherwise a component", classes_, &Class::is_hole);
  classes.computed("birth", "Radius at which the class is born",
                   [=, this](ClassSlot row) { return radius_at(classes_[row.index()].birth); });
  classes.computed("death", "Radius at which the class dies; infinite if it stays",
                   [=, this](ClassSlot row) { return radius_at(classes_[row.index()].death); });
  classes.reference("site", "Where a component is born", classes_, &Class::site, of_sites);
  classes.reference("edge", "Edge that joins the component to an older one, or closes the hole", classes_,
                    &Class::edge, of_edges);
  classes.reference("face", "Triangle that fills the hole", classes_, &Class::face, of_faces);
  return taken(edges, faces, classes);
}

std::vector<TableColumns> AlphaComplex::table_columns() const {
  const std::string of_sites = table_name(delaunay_.id(), "sites");
  const std::string of_edges = table_name(delaunay_.id(), "edges");

  TableMaker<SiteSlot> sites("sites", "Disks of the samples", is_alone_.size(),
                             [this](SiteSlot site) { return delaunay_.is_site(site); });
  sites.set_kind(ElementKind::site);
  sites.set_rows_of(of_sites);
  sites.set_changes(site_changes_);
  sites.flag("is_alone", "The disk meets no other", is_alone_);

  TableMaker<EdgeSlot> edges("edges", "Edges of the alpha complex", delaunay_.edge_rows(),
                             [this](EdgeSlot edge) { return delaunay_.edge(edge).is_alive(); });
  edges.set_kind(ElementKind::delaunay_edge);
  edges.set_rows_of(of_edges);
  edges.set_changes(edge_changes_);
  edges.computed("is_held", "The complex holds the edge", [this](EdgeSlot edge) { return holds(edge); });

  TableMaker<FaceSlot> faces("faces", "Triangles of the alpha complex", delaunay_.face_rows(),
                             [this](FaceSlot face) { return delaunay_.is_finite_face(face); });
  faces.set_kind(ElementKind::voronoi_vertex);
  faces.set_rows_of(table_name(delaunay_.id(), "faces"));
  faces.set_changes(face_changes_);
  faces.computed("is_held", "The complex holds the triangle", [this](FaceSlot face) { return holds(face); });

  TableMaker<EdgeEndSlot> ends(
      "ends", "Arcs of the boundary of the union of disks, by the edge at whose crossing each begins",
      2 * delaunay_.edge_rows(), [this](EdgeEndSlot row) {
        return delaunay_.edge(EdgeSlot(row.index() / 2)).is_alive() && arc(row).has_value();
      });
  ends.set_kind(ElementKind::alpha_end);
  ends.set_changes(end_changes_);
  ends.computed_reference(
      "edge", "Edge at whose crossing the arc begins, to its left",
      [](EdgeEndSlot row) { return EdgeSlot(row.index() / 2); }, of_edges);
  ends.computed_reference(
      "site", "Centre of the arc",
      [this](EdgeEndSlot row) { return delaunay_.edge(EdgeSlot(row.index() / 2)).v[row.index() % 2]; }, of_sites);
  ends.computed("from", "Where the arc begins, counter-clockwise",
                [this](EdgeEndSlot row) { return arc(row)->from; });
  ends.computed("to", "Where the arc ends", [this](EdgeEndSlot row) { return arc(row)->to; });

  TableMaker<ClassSlot> classes("classes", "Components and holes that are alive at the radius",
                                filtration_.classes().size(), [](ClassSlot) { return true; });
  classes.set_kind(ElementKind::alpha_class);
  classes.set_rows_of(table_name(filtration_.id(), "classes"));
  classes.set_changes(class_changes_);
  classes.computed("is_present", "The class is born and has not died",
                   [this](ClassSlot row) { return is_alive(filtration_.classes()[row.index()]); });
  return taken(sites, edges, faces, ends, classes);
}

}  // namespace mes
