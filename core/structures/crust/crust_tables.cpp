// SPDX-License-Identifier: GPL-3.0-or-later
// Crust, labels, curve and Voronoi vertices as columns; most rows are those of `Delaunay`.
#include "core/graph/table_maker.h"
#include "core/structures/crust/curve.h"
#include "core/structures/crust/labels.h"
#include "core/structures/crust/one_step_crust.h"
#include "core/structures/crust/voronoi_vertices.h"

namespace mes {

std::vector<TableColumns> OneStepCrust::table_columns() const {
  TableMaker<EdgeSlot> edges(
      "edges", "Which edges are crust", [this] { return delaunay_.edge_rows(); },
      [this](EdgeSlot edge) { return delaunay_.edge(edge).is_alive(); });
  edges.limit_rows(flags_);
  edges.set_kind(ElementKind::delaunay_edge);
  edges.set_rows_of(table_name(delaunay_.id(), "edges"));
  edges.set_changes(delaunay_.edge_changes());
  edges.computed("is_crust", "The edge is part of the reconstructed curve",
                 [this](EdgeSlot edge) { return is_crust(edge); });
  edges.computed("is_shared", "Closed contours have the edge in common, so inside and outside are the same",
                 [this](EdgeSlot edge) { return is_shared(edge); });
  edges.computed("is_cocircular", "The dual Voronoi edge has length exactly zero",
                 [this](EdgeSlot edge) { return is_cocircular(edge); });
  edges.computed("confidence", "Cosine of the sum of the two opposite angles, from -1 to 1",
                 [this](EdgeSlot edge) { return confidence(edge); });

  TableMaker<SiteSlot> sites(
      "sites", "How many crust edges meet at a site", [this] { return delaunay_.site_rows(); },
      [this](SiteSlot site) { return delaunay_.is_site(site); });
  sites.set_kind(ElementKind::site);
  sites.set_rows_of(table_name(delaunay_.id(), "sites"));
  sites.set_changes(site_changes_);
  sites.column("degree", "Number of crust edges at the site", degree_);
  sites.computed("wall_degree", "Number of crust edges at the site that are not shared",
                 [this](SiteSlot site) { return static_cast<std::uint32_t>(wall_degree(site)); });

  TableMaker<FaceSlot> faces(
      "faces", "Which edges of a face are walls", [this] { return delaunay_.face_rows(); },
      [this](FaceSlot face) { return delaunay_.face(face).is_alive(); });
  faces.set_kind(ElementKind::voronoi_vertex);
  faces.set_rows_of(table_name(delaunay_.id(), "faces"));
  faces.column("wall_bits", "Bit i: the edge opposite corner i is crust and not shared", face_bits_);
  return taken(edges, sites, faces);
}

std::vector<TableColumns> Labels::table_columns() const {
  TableMaker<FaceSlot> faces(
      "faces", "Which faces are inside", [this] { return delaunay_.face_rows(); },
      [this](FaceSlot face) { return delaunay_.face(face).is_alive(); });
  faces.set_kind(ElementKind::voronoi_vertex);
  faces.set_rows_of(table_name(delaunay_.id(), "faces"));
  faces.set_changes(face_changes_);
  faces.flag("is_inside", "The face is inside the curve", inside_);

  TableMaker<EdgeSlot> edges(
      "edges", "Where labels contradict the crust", [this] { return delaunay_.edge_rows(); },
      [this](EdgeSlot edge) { return delaunay_.edge(edge).is_alive(); });
  edges.set_kind(ElementKind::delaunay_edge);
  edges.set_rows_of(table_name(delaunay_.id(), "edges"));
  edges.set_changes(edge_changes_);
  edges.computed("is_conflict", "Labels change across the edge although it is no wall, or the other way round",
                 [this](EdgeSlot edge) { return is_conflict(edge); });
  return taken(faces, edges);
}

std::vector<TableColumns> Curve::table_columns() const {
  const std::string of_sites = table_name(delaunay_.id(), "sites");
  const std::string of_edges = table_name(delaunay_.id(), "edges");

  TableMaker<SiteSlot> sites(
      "sites", "Normals of the reconstructed curve", [this] { return delaunay_.site_rows(); },
      [this](SiteSlot site) { return delaunay_.is_site(site); });
  sites.set_kind(ElementKind::site);
  sites.set_rows_of(of_sites);
  sites.set_changes(site_changes_);
  sites.column("normal", "Unit normal, to the outside where there is one; zero where two edges do not meet", normal_)
      .has_directions = true;
  sites.column("spacing", "Mean length of the two curve edges at a site with a normal", spacing_);

  TableMaker<EdgeSlot> edges(
      "edges", "Which chain a crust edge is part of", [this] { return delaunay_.edge_rows(); },
      [this](EdgeSlot e) { return delaunay_.edge(e).is_alive() && crust_.is_crust(e); });
  edges.set_kind(ElementKind::delaunay_edge);
  edges.set_rows_of(of_edges);
  edges.reference("chain", "Chain of the crust edge", chain_of_edge_, table_name(id(), "chains"));

  TableMaker<ChainSlot> chains(
      "chains", "Loops and open chains of crust edges", [this] { return chains_.size(); },
      [this](ChainSlot chain) { return !chains_[chain].sites.empty(); });
  chains.column("is_closed", "The chain is a loop", chains_, &Chain::closed);
  chains.column("has_inside", "The inside is on its left all along", chains_, &Chain::has_inside);
  chains.computed("edge_count", "Number of its edges",
                  [this](ChainSlot chain) { return static_cast<std::uint32_t>(chains_[chain].edges.size()); });
  chains.computed_reference(
      "first_site", "Where the chain begins", [this](ChainSlot chain) { return chains_[chain].sites.front(); },
      of_sites);
  chains.computed_reference(
      "last_site", "Where the chain ends; before the first site if it is a loop",
      [this](ChainSlot chain) { return chains_[chain].sites.back(); }, of_sites);
  chains.computed_reference(
      "first_edge", "Edge at the first site", [this](ChainSlot chain) { return chains_[chain].edges.front(); },
      of_edges);
  return taken(sites, edges, chains);
}

std::vector<TableColumns> VoronoiVertices::table_columns() const {
  const std::string of_faces = table_name(delaunay_.id(), "faces");
  TableMaker<FaceSlot> faces(
      "faces", "Finite faces, with those of one circumcircle known as one Voronoi vertex",
      [this] { return delaunay_.face_rows(); }, [this](FaceSlot face) { return delaunay_.is_finite_face(face); });
  faces.set_kind(ElementKind::voronoi_vertex);
  faces.set_rows_of(of_faces);
  faces.set_changes(changes_);
  faces.computed_reference(
      "vertex", "Face that stands for all faces with this circumcircle",
      [this](FaceSlot face) { return vertex(face); }, of_faces);
  return taken(faces);
}

}  // namespace mes
