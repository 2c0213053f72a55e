// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/layers/parts/helpers.h"
#include "core/structures/certificate/axis_certificate.h"

namespace mes {

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

}  // namespace mes
