// SPDX-License-Identifier: GPL-3.0-or-later
// Layers of the samples and of their known curves.
#include <numbers>

#include "core/base/geometry/angle.h"
#include "core/layers/parts/helpers.h"
#include "core/structures/delaunay/last_change.h"
#include "core/structures/inputs/contours.h"
#include "core/structures/inputs/samples.h"

namespace mes {

// The picture is not geometry: the program that draws the layers draws it at the position of this layer.
Layer make_image_layer(const StructureSet& /*set*/) {
  return make_layer({.id = "image",
                     .name = "Image",
                     .tooltip = "A picture below the drawing, for tracing shapes",
                     .group = LayerGroup::samples,
                     .in_paper = true,
                     .in_fit_box = false},
                    {});
}

Layer make_points_layer(const StructureSet& set) {
  const auto& samples = set.get<Samples>();
  return make_layer({.id = "points",
                     .name = "Points",
                     .tooltip = "The sample points",
                     .group = LayerGroup::samples,
                     .data = LayerData::samples,
                     .in_paper = true,
                     .visible_at_start = true,
                     .scalar = "id",
                     .scalars_are_names = true,
                     .style = {.color = palette::black, .point_size_px = 5},
                     .kinds = {PrimitiveKind::point}},
                    {&samples},
                    table_part(
                        {PrimitiveKind::point}, [&samples] { return samples.row_count(); }, samples.changes(),
                        [&samples](SampleSlot row, Instance& out) {
                          if (samples.is_alive(row)) out.point(samples.position(row), samples.id(row).value);
                        },
                        ElementType{ElementKind::sample}));
}

// The program that draws the layers writes the numbers, because the space for them depends on the view.
Layer make_indices_layer(const StructureSet& set) {
  const auto& samples = set.get<Samples>();
  return make_layer({.id = "indices",
                     .name = "Indices",
                     .tooltip = "The indices of the samples, from 0; where they would overlap, only the rounder ones",
                     .group = LayerGroup::samples,
                     .points_as = PointsAs::numbers,
                     .style = {.color = palette::black, .point_size_px = 13},
                     .kinds = {PrimitiveKind::point}},
                    {&samples},
                    table_part(
                        {PrimitiveKind::point}, [&samples] { return samples.row_count(); }, samples.changes(),
                        [&samples](SampleSlot row, Instance& out) {
                          if (samples.is_alive(row)) out.point(samples.position(row));
                        },
                        ElementType{ElementKind::sample}));
}

Layer make_last_change_layer(const StructureSet& set) {
  const auto& delaunay = set.get<Delaunay>();
  const auto& last = set.get<LastChange>();
  return make_layer(
      {.id = "last-change",
       .name = "Last change",
       .tooltip = "Faces and edges touched by the last edit",
       .group = LayerGroup::diagnostics,
       .in_fit_box = false,
       .style = {.color = palette::yellow, .opacity = 0.3},
       .kinds = {PrimitiveKind::triangle, PrimitiveKind::segment}},
      {&delaunay, &last},
      faces_part({PrimitiveKind::triangle}, delaunay, last.face_changes(),
                 [&](FaceSlot face, Instance& out) {
                   if (!last.is_touched_face(face)) return;
                   const FaceRow& row = delaunay.face(face);
                   out.triangle(delaunay.site_position(row.v[0]), delaunay.site_position(row.v[1]),
                                delaunay.site_position(row.v[2]));
                 }),
      edges_part({PrimitiveKind::segment}, delaunay, last.edge_changes(), [&](EdgeSlot edge, Instance& out) {
        if (last.is_touched_edge(edge)) emit_edge(delaunay, edge, out);
      }));
}

Layer make_contours_layer(const StructureSet& set) {
  const auto& samples = set.get<Samples>();
  const auto& contours = set.get<Contours>();
  return make_layer(
      {.id = "contours",
       .name = "Contours",
       .tooltip = "The order of the samples along curves as the file gave it, or as it was edited; the "
                  "number is the direction from each sample to the next, counter-clockwise from the right",
       .group = LayerGroup::samples,
       .scalar = "direction in degrees",
       .style = {.color = palette::orange, .opacity = 0.7, .line_width_px = 3},
       .kinds = {PrimitiveKind::segment}},
      {&samples, &contours},
      table_part(
          {PrimitiveKind::segment}, [&contours] { return contours.row_count(); }, contours.changes(),
          [&samples, &contours](ContourSlot row, Instance& out) {
            if (!contours.has_link(row)) return;
            const auto [from, to] = contours.link(row);
            const Vec2 along = samples.position(to) - samples.position(from);
            out.segment(samples.position(from), samples.position(to), angle_of(along) * (180.0 / std::numbers::pi));
          },
          ElementType{ElementKind::contour_link, &contours}));
}

Layer make_curve_defects_layer(const StructureSet& set) {
  const auto& delaunay = set.get<Delaunay>();
  const auto& crust = set.get<OneStepCrust>();
  return make_layer(
      {.id = "curve-defects",
       .name = "Curve defects",
       .tooltip = "Samples with crust degree other than two",
       .group = LayerGroup::diagnostics,
       .scalar = "degree",
       .style = {.color = palette::vermilion, .point_size_px = 9},
       .kinds = {PrimitiveKind::point}},
      {&delaunay, &crust},
      sites_part({PrimitiveKind::point}, delaunay, crust.site_changes(), [&](SiteSlot site, Instance& out) {
        if (crust.degree(site) != 2) out.point(delaunay.site_position(site), crust.degree(site));
      }));
}

}  // namespace mes
