// SPDX-License-Identifier: GPL-3.0-or-later
// Layers that judge the results: densities, proofs, differences.
#include "core/layers/parts/helpers.h"
#include "core/structures/balls/axis_difference.h"
#include "core/structures/balls/precision_difference.h"
#include "core/structures/certificate/axis_certificate.h"
#include "core/structures/density/feature_size.h"
#include "core/structures/outline/axis_deviation.h"

namespace mes {

Layer make_feature_size_layer(const StructureSet& set) {
  const auto& delaunay = set.get<Delaunay>();
  const auto& sizes = set.get<FeatureSize>();
  return make_layer(
      {.id = "feature-size",
       .name = "Feature size",
       .tooltip = "Samples with their distance to the axis on both sides, which estimates the local "
                  "feature size",
       .group = LayerGroup::samples,
       .scalar = "local feature size",
       .style = {.color = palette::black, .point_size_px = 7, .color_map = "cividis"},
       .kinds = {PrimitiveKind::point}},
      {&delaunay, &sizes},
      sites_part({PrimitiveKind::point}, delaunay, sizes.site_changes(), [&](SiteSlot site, Instance& out) {
        if (sizes.has_size(site)) out.point(delaunay.site_position(site), sizes.size(site));
      }));
}

Layer make_sampling_epsilon_layer(const StructureSet& set) {
  const auto& delaunay = set.get<Delaunay>();
  const auto& sizes = set.get<FeatureSize>();
  return make_layer(
      {.id = "sampling-epsilon",
       .name = "Sampling epsilon",
       .tooltip =
           "Curve edges by half their length divided by the feature size at their ends; above 0.25 the samples "
           "are sparse",
       .group = LayerGroup::crust_axis,
       .scalar = "epsilon",
       .style = {.color = palette::blue, .line_width_px = 4.0, .color_map = "inferno"},
       .kinds = {PrimitiveKind::segment}},
      {&delaunay, &sizes},
      edges_part({PrimitiveKind::segment}, delaunay, sizes.edge_changes(), [&](EdgeSlot edge, Instance& out) {
        if (sizes.has_epsilon(edge)) emit_edge(delaunay, edge, out, sizes.epsilon(edge));
      }));
}

Layer make_theorem_check_layer(const StructureSet& set) {
  const auto& delaunay = set.get<Delaunay>();
  const auto& certificate = set.get<AxisCertificate>();
  return make_layer(
      {.id = "theorem-check",
       .name = "Theorem check",
       .tooltip =
           "Curve edges that another inner ball protrudes beyond, and samples that balls touch from several sides",
       .group = LayerGroup::diagnostics,
       .style = {.color = palette::vermilion, .point_size_px = 9, .line_width_px = 5},
       .kinds = {PrimitiveKind::segment, PrimitiveKind::point}},
      {&delaunay, &certificate},
      edges_part({PrimitiveKind::segment}, delaunay, certificate.edge_changes(),
                 [&](EdgeSlot edge, Instance& out) {
                   if (certificate.is_bad_edge(edge)) emit_edge(delaunay, edge, out);
                 }),
      sites_part({PrimitiveKind::point}, delaunay, certificate.site_changes(), [&](SiteSlot site, Instance& out) {
        if (certificate.is_bad_site(site)) out.point(delaunay.site_position(site));
      }));
}

Layer make_axis_difference_layer(const StructureSet& set) {
  const auto& difference = set.get<AxisDifference>();
  return make_layer(
      {.id = "axis-difference",
       .name = "Axis difference",
       .tooltip = "Pieces of the medial axis or of that of the union of its balls, but not of both",
       .group = LayerGroup::diagnostics,
       .scalar = "1: only in the one-step axis, 2: only in that of the union",
       .style = {.color = palette::vermilion, .line_width_px = 4},
       .kinds = {PrimitiveKind::segment}},
      {&difference},
      table_part(
          {PrimitiveKind::segment}, [&difference] { return difference.pieces().size(); }, difference.changes(),
          [&difference](AxisDifference::PieceSlot row, Instance& out) {
            const AxisDifference::Piece& piece = difference.pieces()[row];
            out.segment(piece.a, piece.b, piece.only_one_step ? 1.0 : 2.0);
          }));
}

Layer make_axis_deviation_layer(const StructureSet& set) {
  const auto& deviation = set.get<AxisDeviation>();
  return make_layer(
      {.id = "axis-deviation",
       .name = "Deviation of the axis",
       .tooltip =
           "The medial axis of the samples and the axis of the outline, with the distance of each from the other",
       .group = LayerGroup::diagnostics,
       .scalar = "distance from the other axis",
       .style = {.color = palette::vermilion, .line_width_px = 2.5, .color_map = "cividis"},
       .kinds = {PrimitiveKind::segment}},
      {&deviation},
      table_part(
          {PrimitiveKind::segment}, [&deviation] { return deviation.pieces().size(); }, deviation.changes(),
          [&deviation](AxisDeviation::PieceSlot row, Instance& out) {
            const AxisDeviation::Piece& piece = deviation.pieces()[row];
            out.segment(piece.from, piece.to, piece.distance);
          }));
}

namespace {

// First the rows of A, then those of B: a layer has one part of a kind.
using DifferenceSlot = Slot<struct DifferenceTag>;

void emit_face(const PrecisionDifference& difference, std::size_t row, Instance& out) {
  const PrecisionDifference::Face& face = difference.faces()[row];
  const BallFamily& family = difference.balls().family();
  out.triangle(family.disk(face.ball[0]).center, family.disk(face.ball[1]).center, family.disk(face.ball[2]).center,
               face.is_exact ? 1.0 : 2.0);
}
void emit_edge(const PrecisionDifference& difference, std::size_t row, Instance& out) {
  const PrecisionDifference::Edge& edge = difference.edges()[row];
  const BallFamily& family = difference.balls().family();
  out.segment(family.disk(edge.ball[0]).center, family.disk(edge.ball[1]).center,
              edge.chosen < 0 ? 1.0 : (edge.exact < 0 ? 2.0 : 3.0));
}

}  // namespace

Layer make_precision_difference_layer(const StructureSet& set) {
  const auto& a = set.get<APrecisionDifference>();
  const auto& b = set.get<BPrecisionDifference>();
  return make_layer(
      {.id = "precision-difference",
       .name = "Precision difference",
       .tooltip = "Dual edges and triangles of the unions of inner and own balls that the number type and exact "
                  "arithmetic judge differently",
       .group = LayerGroup::diagnostics,
       .scalar = "1: missed, 2: invented, 3: of another class",
       .style = {.color = palette::vermilion, .opacity = 0.7, .line_width_px = 3},
       .kinds = {PrimitiveKind::triangle, PrimitiveKind::segment}},
      {&a, &b},
      table_part(
          {PrimitiveKind::triangle}, [&] { return a.faces().size() + b.faces().size(); },
          no_changes<DifferenceSlot>(),
          [&](DifferenceSlot row, Instance& out) {
            const std::size_t of_a = a.faces().size();
            row.index() < of_a ? emit_face(a, row.index(), out) : emit_face(b, row.index() - of_a, out);
          }),
      table_part(
          {PrimitiveKind::segment}, [&] { return a.edges().size() + b.edges().size(); }, no_changes<DifferenceSlot>(),
          [&](DifferenceSlot row, Instance& out) {
            const std::size_t of_a = a.edges().size();
            row.index() < of_a ? emit_edge(a, row.index(), out) : emit_edge(b, row.index() - of_a, out);
          }));
}

}  // namespace mes
