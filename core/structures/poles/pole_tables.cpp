// SPDX-License-Identifier: GPL-3.0-or-later
// Poles, their labels and the power crust as columns.
#include "core/graph/table_maker.h"
#include "core/structures/poles/polar_diagram.h"
#include "core/structures/poles/pole_labels.h"
#include "core/structures/poles/poles.h"

namespace mes {
std::vector<TableColumns> Poles::table_columns() const {
  const std::string of_faces = table_name(delaunay_.id(), "faces");
  TableMaker<SiteSlot> sites("sites", "Poles of the samples", delaunay_.site_rows(),
                             [this](SiteSlot site) { return delaunay_.is_site(site); });
  sites.set_kind(ElementKind::site);
  sites.set_rows_of(table_name(delaunay_.id(), "sites"));
  sites.reference("plus", "Farthest Voronoi vertex of the cell, as a face", plus_, {of_faces, kInfinitePole.index()});
  sites.reference("minus", "Farthest one on the other side of the site", minus_, {of_faces, kInfinitePole.index()});

  TableMaker<FaceSlot> faces("faces", "Which Voronoi vertices are poles", delaunay_.face_rows(),
                             [this](FaceSlot face) { return delaunay_.is_finite_face(face); });
  faces.set_kind(ElementKind::voronoi_vertex);
  faces.set_rows_of(of_faces);
  faces.set_changes(face_changes_);
  faces.column("pole_count", "How many sites have it as a pole", uses_).is_followed = false;
  faces.computed("is_pole", "The circumcentre is a pole of some site",
                 [this](FaceSlot face) { return is_pole(face); });
  return taken(sites, faces);
}

std::vector<TableColumns> PoleLabels::table_columns() const {
  TableMaker<FaceSlot> faces("faces", "Which poles are inside", delaunay_.face_rows(), [this](FaceSlot face) {
    return delaunay_.is_finite_face(face) && poles_.is_pole(face);
  });
  faces.set_kind(ElementKind::voronoi_vertex);
  faces.set_rows_of(table_name(delaunay_.id(), "faces"));
  faces.set_changes(changes_);
  faces.computed("is_inside_pole", "The pole is inside", [this](FaceSlot face) { return is_inside(face); });
  return taken(faces);
}

std::vector<TableColumns> PowerCrust::table_columns() const {
  TableMaker<PowerEdgeSlot> edges("edges", "Which edges of the power diagram are crust", is_crust_.size(),
                                  [](PowerEdgeSlot) { return true; });
  edges.set_kind(ElementKind::power_edge);
  edges.set_rows_of(table_name(diagram_.id(), "edges"));
  edges.set_changes(changes());
  edges.flag("is_crust", "The edge lies between the cell of an inside pole and that of an outside one", is_crust_);
  return taken(edges);
}

}  // namespace mes
