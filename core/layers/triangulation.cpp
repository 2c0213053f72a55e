// SPDX-License-Identifier: GPL-3.0-or-later
// The Delaunay triangulation, the Voronoi diagram, and those of balls.
#include "core/layers/parts/family.h"
#include "core/layers/parts/helpers.h"
#include "core/structures/balls/ball_diagrams.h"
#include "core/structures/poles/polar_diagram.h"

namespace mes {

Layer make_delaunay_layer(const StructureSet& set) {
  const auto& delaunay = set.get<Delaunay>();
  return make_layer({.id = "delaunay",
                     .name = "Delaunay",
                     .tooltip = "Edges of the Delaunay triangulation of the samples",
                     .group = LayerGroup::delaunay_voronoi,
                     .in_paper = true,
                     .style = {.color = palette::grey, .opacity = 0.6},
                     .kinds = {PrimitiveKind::segment}},
                    {&delaunay},
                    edges_part({PrimitiveKind::segment}, delaunay, delaunay.edge_changes(),
                               [&delaunay](EdgeSlot edge, Instance& out) { emit_edge(delaunay, edge, out); }));
}

Layer make_voronoi_layer(const StructureSet& set) {
  const auto& delaunay = set.get<Delaunay>();
  const auto& crust = set.get<OneStepCrust>();
  return make_layer(
      {.id = "voronoi",
       .name = "Voronoi",
       .tooltip = "Edges of the Voronoi diagram of the samples",
       .group = LayerGroup::delaunay_voronoi,
       .in_paper = true,
       .in_fit_box = false,
       .style = {.color = palette::sky, .opacity = 0.8},
       .kinds = {PrimitiveKind::segment, PrimitiveKind::ray, PrimitiveKind::line}},
      {&delaunay, &crust},
      edges_part({PrimitiveKind::segment, PrimitiveKind::ray, PrimitiveKind::line}, delaunay, delaunay.edge_changes(),
                 [&](EdgeSlot edge, Instance& out) { emit_dual(delaunay, crust, edge, out); }));
}

Layer make_a_regular_triangulation_layer(const StructureSet& set) {
  const auto& diagram = set.get<VoronoiBallDiagram>();
  return make_layer({.id = "a-regular-triangulation",
                     .name = "Regular triangulation of the Voronoi balls",
                     .tooltip = "Regular triangulation of all finite Voronoi balls",
                     .group = LayerGroup::delaunay_voronoi,
                     .in_paper = true,
                     .in_fit_box = false,
                     .style = {.color = palette::grey, .opacity = 0.6},
                     .kinds = {PrimitiveKind::segment}},
                    {&diagram},
                    power_part({PrimitiveKind::segment}, diagram, [&diagram](const PowerEdge& edge, Instance& out) {
                      emit_centers(diagram, edge, out);
                    }));
}

Layer make_a_power_diagram_layer(const StructureSet& set) {
  const auto& diagram = set.get<VoronoiBallDiagram>();
  return make_layer({.id = "a-power-diagram",
                     .name = "Power diagram of the Voronoi balls",
                     .tooltip = "Power diagram of all finite Voronoi balls",
                     .group = LayerGroup::delaunay_voronoi,
                     .in_paper = true,
                     .in_fit_box = false,
                     .style = {.color = palette::sky, .opacity = 0.6},
                     .kinds = {PrimitiveKind::line, PrimitiveKind::ray, PrimitiveKind::segment}},
                    {&diagram},
                    power_part({PrimitiveKind::line, PrimitiveKind::ray, PrimitiveKind::segment}, diagram,
                               [](const PowerEdge& edge, Instance& out) { emit_power_edge(edge, out); }));
}

Layer make_polar_triangulation_layer(const StructureSet& set) {
  const auto& diagram = set.get<PolarDiagram>();
  return make_layer({.id = "polar-triangulation",
                     .name = "Polar triangulation",
                     .tooltip = "Regular triangulation of all polar balls",
                     .group = LayerGroup::poles,
                     .in_paper = true,
                     .in_fit_box = false,
                     .style = {.color = palette::grey, .opacity = 0.5},
                     .kinds = {PrimitiveKind::segment}},
                    {&diagram},
                    power_part({PrimitiveKind::segment}, diagram, [&diagram](const PowerEdge& edge, Instance& out) {
                      if (diagram.is_far(edge.ball[0]) || diagram.is_far(edge.ball[1])) return;
                      emit_centers(diagram, edge, out);
                    }));
}

Layer make_polar_power_diagram_layer(const StructureSet& set) {
  const auto& diagram = set.get<PolarDiagram>();
  return make_layer({.id = "polar-power-diagram",
                     .name = "Polar power diagram",
                     .tooltip = "Power diagram of all polar balls, with half planes for the poles at infinity",
                     .group = LayerGroup::poles,
                     .in_paper = true,
                     .in_fit_box = false,
                     .style = {.color = palette::sky, .opacity = 0.5},
                     .kinds = {PrimitiveKind::line, PrimitiveKind::ray, PrimitiveKind::segment}},
                    {&diagram},
                    power_part({PrimitiveKind::line, PrimitiveKind::ray, PrimitiveKind::segment}, diagram,
                               [&diagram](const PowerEdge& edge, Instance& out) {
                                 if (!diagram.is_far(edge.ball[0]) || !diagram.is_far(edge.ball[1]))
                                   emit_power_edge(edge, out);
                               }));
}

}  // namespace mes
