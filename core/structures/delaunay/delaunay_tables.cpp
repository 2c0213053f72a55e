// SPDX-License-Identifier: GPL-3.0-or-later
// Sites, faces and edges of the Delaunay triangulation as columns.
#include "core/graph/table_maker.h"
#include "core/structures/delaunay/delaunay.h"
#include "core/structures/delaunay/last_change.h"

namespace mes {

std::vector<TableColumns> Delaunay::table_columns() const {
  const std::string samples = table_name(samples_.Structure::id(), "samples");
  const std::string sites = table_name(id(), "sites");
  const std::string faces = table_name(id(), "faces");
  const std::string edges = table_name(id(), "edges");

  TableMaker<SiteSlot> of_sites(
      "sites", "Distinct positions of samples", [this] { return site_rows(); },
      [this](SiteSlot site) { return is_site(site); });
  of_sites.set_kind(ElementKind::site);
  of_sites.set_changes(site_changes_);
  of_sites.column("position", "Coordinates of the document", site_position_);
  of_sites.reference("sample", "One of the samples there", site_sample_, samples).is_followed = false;
  of_sites.reference("face", "A face at the site; none below dimension 2", site_face_, faces).is_followed = false;

  TableMaker<FaceSlot> of_faces(
      "faces", "Delaunay triangles, and the outside of each hull edge", [this] { return face_rows(); },
      [this](FaceSlot face) { return face_[face].is_alive(); });
  of_faces.set_kind(ElementKind::voronoi_vertex);
  of_faces.set_changes(face_changes_);
  of_faces.reference("sites", "Corners, counter-clockwise", face_, &FaceRow::v, {sites, kInfiniteSite.index()});
  // A face whose corners stay does not count as changed when a neighbour does.
  of_faces.reference("faces", "Neighbours, each opposite the corner of the same number", face_, &FaceRow::n, faces)
      .is_followed = false;
  of_faces.reference("edges", "Edges, each opposite the corner of the same number; none to infinity", face_,
                     &FaceRow::e, edges);
  of_faces.computed("is_finite", "No corner is at infinity", [this](FaceSlot face) { return is_finite_face(face); });
  of_faces.column("circumcenter", "Voronoi vertex of a finite face", face_, &FaceRow::center);
  of_faces.column("circumradius", "Radius of the circumcircle of a finite face", face_, &FaceRow::radius);

  TableMaker<EdgeSlot> of_edges(
      "edges", "Finite Delaunay edges, each with its Voronoi edge", [this] { return edge_rows(); },
      [this](EdgeSlot edge) { return edge_[edge].is_alive(); });
  of_edges.set_kind(ElementKind::delaunay_edge);
  of_edges.set_changes(edge_changes_);
  of_edges.reference("sites", "From one end to the other", edge_, &EdgeRow::v, sites);
  of_edges.reference("faces", "Left and right of the way from one end to the other; none below dimension 2", edge_,
                     &EdgeRow::f, faces);

  TableMaker<SampleSlot> of_samples(
      "samples", "Samples and their sites", [this] { return site_of_sample_.size(); },
      [this](SampleSlot sample) { return samples_.is_alive(sample); });
  of_samples.set_kind(ElementKind::sample);
  of_samples.set_rows_of(samples);
  of_samples.reference("site", "Site at the position of the sample", site_of_sample_, sites);
  of_samples.reference("next_duplicate", "Another sample there; they begin with that of the site", next_duplicate_,
                       samples);
  return taken(of_sites, of_faces, of_edges, of_samples);
}

std::vector<TableColumns> LastChange::table_columns() const {
  TableMaker<FaceSlot> faces(
      "faces", "Faces that the last edit touched", [this] { return delaunay_.face_rows(); },
      [this](FaceSlot face) { return delaunay_.face(face).is_alive(); });
  faces.set_kind(ElementKind::voronoi_vertex);
  faces.set_rows_of(table_name(delaunay_.id(), "faces"));
  faces.set_changes(face_changes());
  faces.computed("is_touched", "The last edit touched the face",
                 [this](FaceSlot face) { return is_touched_face(face); });

  TableMaker<EdgeSlot> edges(
      "edges", "Edges that the last edit touched", [this] { return delaunay_.edge_rows(); },
      [this](EdgeSlot edge) { return delaunay_.edge(edge).is_alive(); });
  edges.set_kind(ElementKind::delaunay_edge);
  edges.set_rows_of(table_name(delaunay_.id(), "edges"));
  edges.set_changes(edge_changes());
  edges.computed("is_touched", "The last edit touched the edge",
                 [this](EdgeSlot edge) { return is_touched_edge(edge); });
  return taken(faces, edges);
}

}  // namespace mes
