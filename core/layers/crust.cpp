// SPDX-License-Identifier: GPL-3.0-or-later
// Curves reconstructed from the samples.
#include "core/layers/parts/family.h"
#include "core/layers/parts/helpers.h"
#include "core/structures/crust/curve.h"
#include "core/structures/crust/labels.h"
#include "core/structures/poles/polar_diagram.h"

namespace mes {

Layer make_curve_layer(const StructureSet& set) {
  const auto& delaunay = set.get<Delaunay>();
  const auto& crust = set.get<OneStepCrust>();
  return make_layer(
      {.id = "curve",
       .name = "Curve",
       .tooltip = "Delaunay edges accepted by the one-step crust test",
       .group = LayerGroup::crust_axis,
       .data = LayerData::curve,
       .visible_at_start = true,
       .scalar = "confidence",
       .style = {.color = palette::blue, .line_width_px = 2},
       .kinds = {PrimitiveKind::segment}},
      {&delaunay, &crust},
      edges_part({PrimitiveKind::segment}, delaunay, delaunay.edge_changes(), [&](EdgeSlot edge, Instance& out) {
        if (crust.is_crust(edge)) emit_edge(delaunay, edge, out, out.wants_scalar() ? crust.confidence(edge) : 0.0);
      }));
}

// Normals are twice as long as the spacing of the samples, so that they stay distinguishable at any density.
Layer make_curve_normals_layer(const StructureSet& set) {
  const auto& delaunay = set.get<Delaunay>();
  const auto& curve = set.get<Curve>();
  return make_layer(
      {.id = "curve-normals",
       .name = "Curve normals",
       .tooltip = "Normal vector at every ordered curve sample",
       .group = LayerGroup::crust_axis,
       .data = LayerData::curve_normals,
       .style = {.color = palette::blue, .opacity = 0.6},
       .kinds = {PrimitiveKind::segment}},
      {&delaunay, &curve},
      sites_part({PrimitiveKind::segment}, delaunay, curve.site_changes(), [&](SiteSlot site, Instance& out) {
        if (!curve.has_normal(site)) return;
        const Vec2 p = delaunay.site_position(site);
        out.segment(p, p + 2.0 * curve.spacing(site) * curve.normal(site));
      }));
}

Layer make_anti_crust_edges_layer(const StructureSet& set) {
  const auto& crust = set.get<PowerCrust>();
  const auto& diagram = crust.diagram();
  return make_layer({.id = "anti-crust-edges",
                     .name = "Anti crust edges",
                     .tooltip = "Edges of the polar triangulation whose dual is not in the power crust",
                     .group = LayerGroup::poles,
                     .in_fit_box = false,
                     .style = {.color = palette::green, .opacity = 0.6},
                     .kinds = {PrimitiveKind::segment}},
                    {&crust, &diagram},
                    table_part(
                        {PrimitiveKind::segment}, [&diagram] { return diagram.edges().size(); }, crust.changes(),
                        [&](PowerEdgeSlot row, Instance& out) {
                          const PowerEdge& edge = diagram.edges()[row];
                          if (crust.is_crust(row) || diagram.is_far(edge.ball[0]) || diagram.is_far(edge.ball[1]))
                            return;
                          emit_centers(diagram, edge, out);
                        },
                        ElementType{ElementKind::power_edge, &diagram}));
}

Layer make_voronoi_crust_layer(const StructureSet& set) {
  const auto& delaunay = set.get<Delaunay>();
  const auto& labels = set.get<Labels>();
  return make_layer(
      {.id = "voronoi-crust",
       .name = "Voronoi crust",
       .tooltip = "Delaunay edges between an inside and an outside Voronoi vertex",
       .group = LayerGroup::crust_axis,
       .in_paper = true,
       .style = {.color = palette::blue, .opacity = 0.8, .line_width_px = 2},
       .kinds = {PrimitiveKind::segment}},
      {&delaunay, &labels},
      edges_part({PrimitiveKind::segment}, delaunay, labels.edge_changes(), [&](EdgeSlot edge, Instance& out) {
        const EdgeRow& row = delaunay.edge(edge);
        if (row.f[0] == kNoSlot) return;
        if (labels.is_inside(row.f[0]) != labels.is_inside(row.f[1])) emit_edge(delaunay, edge, out);
      }));
}

Layer make_power_crust_layer(const StructureSet& set) {
  const auto& crust = set.get<PowerCrust>();
  const auto& diagram = crust.diagram();
  return make_layer({.id = "power-crust",
                     .name = "Power crust",
                     .tooltip = "Edges of the polar power diagram between inner and outer poles",
                     .group = LayerGroup::poles,
                     .in_paper = true,
                     .style = {.color = palette::blue, .line_width_px = 2},
                     .kinds = {PrimitiveKind::line, PrimitiveKind::ray, PrimitiveKind::segment}},
                    {&crust, &diagram},
                    table_part(
                        {PrimitiveKind::line, PrimitiveKind::ray, PrimitiveKind::segment},
                        [&diagram] { return diagram.edges().size(); }, crust.changes(),
                        [&](PowerEdgeSlot edge, Instance& out) {
                          if (crust.is_crust(edge)) emit_power_edge(diagram.edges()[edge], out);
                        },
                        ElementType{ElementKind::power_edge, &diagram}));
}

Layer make_label_conflicts_layer(const StructureSet& set) {
  const auto& delaunay = set.get<Delaunay>();
  const auto& crust = set.get<OneStepCrust>();
  const auto& labels = set.get<Labels>();
  return make_layer(
      {.id = "label-conflicts",
       .name = "Label conflicts",
       .tooltip = "Edges whose two labels contradict their crust bit",
       .group = LayerGroup::diagnostics,
       .scalar = "confidence",
       .style = {.color = palette::vermilion, .line_width_px = 4, .dashed = true},
       .kinds = {PrimitiveKind::segment}},
      {&delaunay, &crust, &labels},
      edges_part({PrimitiveKind::segment}, delaunay, labels.edge_changes(), [&](EdgeSlot edge, Instance& out) {
        if (labels.is_conflict(edge)) emit_edge(delaunay, edge, out, crust.confidence(edge));
      }));
}

}  // namespace mes
