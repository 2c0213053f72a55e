// SPDX-License-Identifier: GPL-3.0-or-later
// Inner balls and the one-step axis as columns; rows are those of `Delaunay`.
#include <array>

#include "core/graph/table_maker.h"
#include "core/structures/axis/axis_nodes.h"
#include "core/structures/axis/inner_balls.h"
#include "core/structures/axis/medial_axis.h"

namespace mes {

std::vector<TableColumns> InnerBalls::table_columns() const {
  const std::string of_faces = table_name(delaunay_.id(), "faces");
  TableMaker<FaceSlot> faces(
      "faces", "Inner Voronoi balls: circumdisks of inside triangles", [this] { return delaunay_.face_rows(); },
      [this](FaceSlot face) { return delaunay_.face(face).is_alive() && is_ball(face); });
  faces.set_kind(ElementKind::voronoi_vertex);
  faces.set_rows_of(of_faces);
  faces.set_changes(changes_);
  faces.computed_reference(
      "ball", "Face that stands for all faces with this circumcircle", [this](FaceSlot face) { return ball(face); },
      of_faces);
  faces.column("center", "Centre of the ball", delaunay_.faces(), &FaceRow::center);
  faces.column("radius", "Radius of the ball", delaunay_.faces(), &FaceRow::radius);
  return taken(faces);
}

std::vector<TableColumns> MedialAxis::table_columns() const {
  TableMaker<EdgeSlot> edges(
      "edges", "Voronoi edges of the one-step axis", [this] { return delaunay_.edge_rows(); },
      [this](EdgeSlot edge) { return delaunay_.edge(edge).is_alive() && is_axis_edge(edge); });
  edges.set_kind(ElementKind::delaunay_edge);
  edges.set_rows_of(table_name(delaunay_.id(), "edges"));
  edges.set_changes(edge_changes());
  edges
      .computed_reference(
          "nodes", "Balls at both ends, left and right of the Delaunay edge",
          [this](EdgeSlot edge) {
            const EdgeRow& row = delaunay_.edge(edge);
            return std::array{balls_.ball(row.f[0]), balls_.ball(row.f[1])};
          },
          table_name(balls_.id(), "faces"))
      .is_followed = false;
  edges.computed("is_zero_length", "The edge joins faces of one node, and is no edge of the axis as a graph",
                 [this](EdgeSlot edge) { return is_zero_length(edge); });
  edges.computed("length", "Length of the edge",
                 [this](EdgeSlot edge) { return is_zero_length(edge) ? 0.0 : delaunay_.dual_length(edge); });
  return taken(edges);
}

std::vector<TableColumns> AxisNodes::table_columns() const {
  TableMaker<FaceSlot> faces(
      "faces", "Nodes of the one-step axis", [this] { return delaunay_.face_rows(); },
      [this](FaceSlot face) { return delaunay_.face(face).is_alive() && axis_.is_node(face); });
  faces.set_kind(ElementKind::voronoi_vertex);
  faces.set_rows_of(table_name(delaunay_.id(), "faces"));
  faces.set_changes(changes_);
  faces.computed("degree", "Axis edges of positive length at the node: 1 at a leaf, 3 or more at a branch point",
                 [this](FaceSlot face) { return static_cast<std::uint32_t>(axis_.node_degree(face)); });
  return taken(faces);
}

}  // namespace mes
