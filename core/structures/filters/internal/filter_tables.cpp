// SPDX-License-Identifier: GPL-3.0-or-later
// Lists the columns of axis filters: the kept part of the axis and the filter values. Rows are those of `Delaunay`.
#include <algorithm>
#include <array>

#include "core/graph/table_maker.h"
#include "core/structures/filters/axis_center_lines.h"
#include "core/structures/filters/axis_filter.h"
#include "core/structures/filters/cover_dates.h"

namespace mes {

std::vector<TableColumns> AxisFilter::table_columns() const {
  const std::string of_edges = table_name(delaunay_.id(), "edges");
  const std::string of_faces = table_name(delaunay_.id(), "faces");
  const std::string measure_name(measure());

  TableMaker<EdgeSlot> edges("edges", "Edges of the axis that the filter keeps or removes", delaunay_.edge_rows(),
                             [this](EdgeSlot edge) { return is_edge(edge); });
  edges.limit_rows(edge_flags_);
  edges.set_kind(ElementKind::delaunay_edge);
  edges.set_rows_of(of_edges);
  edges.set_changes(edge_changes_);
  edges.computed(measure_name, "Largest value on the edge, or the mean where the mode says so",
                 [this](EdgeSlot edge) { return value(edge); });
  edges.computed("is_kept", "The edge is kept, or a part of it", [this](EdgeSlot edge) { return is_kept(edge); });
  edges.computed("is_cut", "The kept part ends before that end of the edge", [this](EdgeSlot edge) {
    return std::array{is_cut(edge, 0), is_cut(edge, 1)};
  });

  TableMaker<FaceSlot> faces(
      "faces", "Nodes of the axis that the filter keeps or removes", delaunay_.face_rows(),
      [this](FaceSlot face) { return delaunay_.face(face).is_alive() && axis_.is_node(face); });
  faces.limit_rows(node_flags_);
  faces.set_kind(ElementKind::voronoi_vertex);
  faces.set_rows_of(of_faces);
  faces.set_changes(node_changes_);
  faces.computed(measure_name, "Value at the node", [this](FaceSlot face) { return value(face); });
  faces.computed("is_kept", "The node is kept", [this](FaceSlot face) { return is_kept(face); });

  TableMaker<AxisEndSlot> removed("removed_pieces", "What the filter removes of edges of the axis, by edge and end",
                                  2 * std::min(edge_flags_.size(), delaunay_.edge_rows()), [this](AxisEndSlot row) {
                                    Vec2 a, b;
                                    return removed_piece(row, a, b);
                                  });
  removed.set_kind(ElementKind::axis_piece);
  removed.set_changes(removed_changes_);
  const auto end_of_piece = [this](AxisEndSlot row, int end) {
    Vec2 ends[2];
    removed_piece(row, ends[0], ends[1]);
    return ends[end];
  };
  removed.computed_reference(
      "edge", "Edge of the axis", [](AxisEndSlot row) { return EdgeSlot(row.index() / 2); }, of_edges);
  removed.computed("from", "End of the edge of the axis", [=](AxisEndSlot row) { return end_of_piece(row, 0); });
  removed.computed("to", "Other end, or where the filter cuts the edge",
                   [=](AxisEndSlot row) { return end_of_piece(row, 1); });
  return taken(edges, faces, removed);
}

std::vector<TableColumns> CoverDates::table_columns() const {
  TableMaker<FaceSlot> faces("faces", "When inner balls are swallowed as all of them grow", date_.size(),
                             [this](FaceSlot face) { return has_date(face); });
  faces.set_kind(ElementKind::voronoi_vertex);
  faces.set_rows_of(table_name(delaunay_.id(), "faces"));
  faces.set_changes(changes());
  faces.column("cover_date", "Factor at which a larger grown ball holds the grown ball; infinite if none does",
               date_);
  return taken(faces);
}

std::vector<TableColumns> AxisCenterLines::table_columns() const {
  const auto always = [](auto) { return true; };
  TableMaker<LineSlot> lines("lines", "Centre lines", lines_.size(), always);
  lines.column("length", "Length of the line", lines_, &Line::length);
  lines.computed("widths", "Least, mean and largest width of the shape along the line", [this](LineSlot row) {
    const Widths& widths = lines_[row].widths;
    return std::array{widths.least, widths.mean, widths.largest};
  });
  lines.computed("is_closed", "The line ends where it begins",
                 [this](LineSlot row) { return lines_[row].is_closed; });

  const std::string of_lines = table_name(id(), "lines");
  TableMaker<PieceSlot> pieces("pieces", "Straight pieces of the centre lines, from end to end", pieces_.size(),
                               always);
  pieces.column("from", "One end", pieces_, &Piece::from);
  pieces.column("to", "The other end", pieces_, &Piece::to);
  pieces.reference("line", "The line", pieces_, &Piece::line, of_lines);

  TableMaker<TransectSlot> transects("transects", "Lines across the shapes, equally far apart", transects_.size(),
                                     always);
  transects.column("left", "Nearest point of the left bank", transects_, &Transect::left);
  transects.column("axis", "Point of the axis", transects_, &Transect::axis);
  transects.column("right", "Nearest point of the right bank", transects_, &Transect::right);
  transects.column("place", "Point of the centre line", transects_, &Transect::place);
  transects.column("station", "Arc length of the line up to the point", transects_, &Transect::station);
  transects.column("width", "Sum of the distances of both banks from the axis", transects_, &Transect::width);
  transects.column("direction", "Direction of the line in degrees, counter-clockwise from the x axis", transects_,
                   &Transect::direction);
  transects.reference("line", "The line", transects_, &Transect::line, of_lines);
  return taken(lines, pieces, transects);
}

}  // namespace mes
