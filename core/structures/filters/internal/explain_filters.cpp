// SPDX-License-Identifier: GPL-3.0-or-later
// Explains the part of the axis filters in rows that they share with `Delaunay`, and the pieces they removed.
#include <string>

#include "core/structures/delaunay/explain_parts.h"
#include "core/structures/filters/angle_axis.h"
#include "core/structures/filters/cover_axis.h"
#include "core/structures/filters/lambda_axis.h"

namespace mes {

std::string LambdaAxis::spoken(double value) const {
  return "lambda " + number_text(value);
}

std::string AngleAxis::spoken(double value) const {
  return "object angle " + number_text(value) + " degrees";
}

std::string CoverAxis::spoken(double value) const {
  return value < 1.0 ? "swallowed when balls grow by " + number_text(1.0 / (1.0 - value))
                     : std::string("never swallowed");
}

void AxisFilter::explain(ElementKind kind, RowNumber row, Explanation& out) const {
  if (kind == ElementKind::axis_piece) {
    const EdgeSlot edge(row / 2);
    if (is_removed(edge)) out.about(ElementKind::delaunay_edge, edge);
    return;
  }
  ProvenanceShapes shapes;
  if (kind == ElementKind::delaunay_edge && is_edge(EdgeSlot(row))) {
    const EdgeSlot edge(row);
    const auto end = [&](int i) {
      return is_cut(edge, i) ? ShapePlace(kept_end(edge, i)) : place_of(delaunay_, delaunay_.edge(edge).f[i]);
    };
    if (is_kept(edge)) shapes.segment(end(0), end(1));
    const char* const part = !is_kept(edge) ? "removed" : (is_removed(edge) ? "kept in part" : "kept");
    out.say(ProvenanceRole::product, spoken(value(edge)) + ": " + part, shapes);
  }
  const FaceSlot face(row);
  if (kind != ElementKind::voronoi_vertex || !delaunay_.is_finite_face(face) || !balls_.is_ball(face)) return;
  const FaceSlot node = balls_.ball(face);
  if (is_kept(node)) shapes.point(place_of(delaunay_, node));
  out.say(ProvenanceRole::product, spoken(value(node)) + (is_kept(node) ? ": kept" : ": removed"), shapes);
}

}  // namespace mes
