// SPDX-License-Identifier: GPL-3.0-or-later
// Medial axes, of the samples and of the outline, and lines along them.
#include <optional>

#include "core/layers/parts/helpers.h"
#include "core/structures/axis/axis_nodes.h"
#include "core/structures/axis/medial_axis.h"
#include "core/structures/filters/axis_center_lines.h"
#include "core/structures/filters/cover_dates.h"
#include "core/structures/outline/outline_axis.h"

namespace mes {

Layer make_medial_axis_layer(const StructureSet& set) {
  const auto& delaunay = set.get<Delaunay>();
  const auto& crust = set.get<OneStepCrust>();
  const auto& axis = set.get<MedialAxis>();
  return make_layer(
      {.id = "medial-axis",
       .name = "Medial axis",
       .tooltip = "Voronoi edges joining two inside Voronoi vertices: the medial axis of the union of inner balls",
       .group = LayerGroup::crust_axis,
       .in_paper = true,
       .visible_at_start = true,
       .scalar = "lambda",
       .style = {.color = palette::vermilion, .line_width_px = 2.5},
       .kinds = {PrimitiveKind::segment}},
      {&delaunay, &crust, &axis},
      edges_part({PrimitiveKind::segment}, delaunay, axis.edge_changes(), [&](EdgeSlot edge, Instance& out) {
        if (axis.is_axis_edge(edge))
          emit_dual(delaunay, crust, edge, out, out.wants_scalar() ? contact_spread(delaunay, edge) : 0.0);
      }));
}

Layer make_all_medial_axis_layer(const StructureSet& set) {
  const auto& delaunay = set.get<Delaunay>();
  const auto& crust = set.get<OneStepCrust>();
  return make_layer({.id = "all-medial-axis",
                     .name = "All medial axis",
                     .tooltip = "Duals of all non-crust Delaunay edges, inside and outside",
                     .group = LayerGroup::crust_axis,
                     .in_fit_box = false,
                     .scalar = "lambda",
                     .style = {.color = palette::vermilion, .opacity = 0.5},
                     .kinds = {PrimitiveKind::segment, PrimitiveKind::ray, PrimitiveKind::line}},
                    {&delaunay, &crust},
                    edges_part({PrimitiveKind::segment, PrimitiveKind::ray, PrimitiveKind::line}, delaunay,
                               delaunay.edge_changes(), [&](EdgeSlot edge, Instance& out) {
                                 if (!crust.is_crust(edge))
                                   emit_dual(delaunay, crust, edge, out, contact_spread(delaunay, edge));
                               }));
}

Layer make_axis_nodes_layer(const StructureSet& set) {
  const auto& delaunay = set.get<Delaunay>();
  const auto& axis = set.get<MedialAxis>();
  const auto& nodes = set.get<AxisNodes>();
  return make_layer({.id = "axis-nodes",
                     .name = "Axis nodes",
                     .tooltip = "Leaves and branch points of the medial axis",
                     .group = LayerGroup::diagnostics,
                     .scalar = "degree",
                     .style = {.color = palette::vermilion, .point_size_px = 6},
                     .kinds = {PrimitiveKind::point}},
                    {&delaunay, &axis, &nodes},
                    faces_part({PrimitiveKind::point}, delaunay, nodes.changes(), [&](FaceSlot face, Instance& out) {
                      if (axis.is_node(face) && axis.node_degree(face) != 2)
                        out.point(delaunay.circumcenter(face), axis.node_degree(face));
                    }));
}

Layer make_outline_axis_layer(const StructureSet& set) {
  const auto& axis = set.get<OutlineAxis>();
  return make_layer(
      {.id = "outline-axis",
       .name = "Axis of the outline",
       .tooltip = "Exact medial axis of the contours or curves inside them, without samples: straight and curved "
                  "edges",
       .group = LayerGroup::crust_axis,
       .scalar = "radius",
       .style = {.color = palette::green, .line_width_px = 1.5},
       .kinds = {PrimitiveKind::segment, PrimitiveKind::parabola}},
      {&axis},
      table_part(
          {PrimitiveKind::segment, PrimitiveKind::parabola}, [&axis] { return axis.graph().edges.size(); },
          axis.changes(),
          [&axis](OutlineEdgeSlot row, Instance& out) {
            const OutlineEdge& edge = axis.graph().edges[row];
            const OutlineNode& from = axis.graph().nodes[edge.nodes[0]];
            const OutlineNode& to = axis.graph().nodes[edge.nodes[1]];
            const double radius = 0.5 * (from.radius + to.radius);
            if (const std::optional<Vec2> control = axis.control(row))
              out.parabola({from.center, *control, to.center}, radius);
            else
              out.segment(from.center, to.center, radius);
          },
          ElementType{ElementKind::axis_piece, &axis}));
}

namespace {

/// A transect has two parts, which form an angle in bends.
using HalfSlot = Slot<struct TransectHalfTag>;

}  // namespace

Layer make_center_lines_layer(const StructureSet& set) {
  const auto& lines = set.get<AxisCenterLines>();
  return make_layer({.id = "center-lines",
                     .name = "Centre lines",
                     .tooltip = "The longest lines of the pruned medial axis, smoothed inside the shapes",
                     .group = LayerGroup::crust_axis,
                     .style = {.color = palette::vermilion, .line_width_px = 3},
                     .kinds = {PrimitiveKind::segment}},
                    {&lines},
                    table_part(
                        {PrimitiveKind::segment}, [&lines] { return lines.pieces().size(); },
                        no_changes<AxisCenterLines::PieceSlot>(),
                        [&lines](AxisCenterLines::PieceSlot row, Instance& out) {
                          const AxisCenterLines::Piece& piece = lines.pieces()[row];
                          out.segment(piece.from, piece.to);
                        }));
}

Layer make_transects_layer(const StructureSet& set) {
  const auto& lines = set.get<AxisCenterLines>();
  return make_layer(
      {.id = "transects",
       .name = "Transects",
       .tooltip = "Lines across the shapes in equal steps along the centre lines, with the width there",
       .group = LayerGroup::crust_axis,
       .scalar = "width",
       .style = {.color = palette::purple, .line_width_px = 1.5},
       .kinds = {PrimitiveKind::segment}},
      {&lines},
      table_part(
          {PrimitiveKind::segment}, [&lines] { return 2 * lines.transects().size(); }, no_changes<HalfSlot>(),
          [&lines](HalfSlot row, Instance& out) {
            const AxisCenterLines::TransectSlot slot(row.index() / 2);
            const AxisCenterLines::Transect& at = lines.transects()[slot];
            out.segment(row.index() % 2 == 0 ? at.left : at.right, at.axis, at.width);
          }));
}

Layer make_cover_dates_layer(const StructureSet& set) {
  const auto& delaunay = set.get<Delaunay>();
  const auto& dates = set.get<CoverDates>();
  return make_layer({.id = "cover-dates",
                     .name = "Cover dates",
                     .tooltip = "Centres of the inner balls, with 1 - 1/s, where s is the growth factor at which "
                                "another grown ball swallows them; 1: never",
                     .group = LayerGroup::scale_axis,
                     .scalar = "1 - 1/s",
                     .style = {.color = palette::orange, .point_size_px = 5, .color_map = "viridis"},
                     .kinds = {PrimitiveKind::point}},
                    {&delaunay, &dates},
                    faces_part({PrimitiveKind::point}, delaunay, dates.changes(), [&](FaceSlot face, Instance& out) {
                      if (dates.has_date(face)) out.point(delaunay.circumcenter(face), 1.0 - 1.0 / dates.date(face));
                    }));
}

}  // namespace mes
