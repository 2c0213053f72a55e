// SPDX-License-Identifier: GPL-3.0-or-later
// Explains the part of crust, labels and Voronoi vertices in rows that they share with `Delaunay`.
#include <algorithm>
#include <vector>

#include "core/structures/crust/labels.h"
#include "core/structures/crust/one_step_crust.h"
#include "core/structures/crust/voronoi_vertices.h"
#include "core/structures/delaunay/explain_parts.h"

namespace mes {

void OneStepCrust::explain(ElementKind kind, RowNumber row, Explanation& out) const {
  if (kind == ElementKind::delaunay_edge) {
    const EdgeSlot edge(row);
    if (delaunay_.edge(edge).is_alive()) out.rename(is_crust(edge) ? "Curve edge" : "Skeleton edge");
  }
  if (kind != ElementKind::site || !delaunay_.is_site(SiteSlot(row))) return;
  const SiteSlot site(row);
  ProvenanceShapes curve;
  delaunay_.for_each_edge_at(site, [&](EdgeSlot edge, SiteSlot other, FaceSlot) {
    if (is_crust(edge)) curve.segment(place_of(delaunay_, site), place_of(delaunay_, other));
  });
  out.say_any(ProvenanceRole::product, "curve edge", "curve edges", curve);
}

void Labels::explain(ElementKind kind, RowNumber row, Explanation& out) const {
  const FaceSlot face(row);
  if (kind == ElementKind::voronoi_vertex && delaunay_.is_finite_face(face))
    out.rename(is_inside(face) ? "Inner Voronoi ball" : "Outer Voronoi ball");
}

// `Delaunay` explains the face itself. This adds the other faces on its circle, and which Voronoi edges have positive
// length.
void VoronoiVertices::explain(ElementKind kind, RowNumber row, Explanation& out) const {
  const FaceSlot face(row);
  if (kind != ElementKind::voronoi_vertex || !delaunay_.is_finite_face(face)) return;
  const FaceRow& own = delaunay_.face(face);
  std::vector<SiteSlot> sites;
  append_sites(face, sites);
  std::vector<FaceSlot> faces{face};
  if (const auto* together = group(face)) faces = *together;
  ProvenanceShapes samples, triangles, edges;
  for (const SiteSlot site : sites)
    if (std::ranges::find(own.v, site) == std::end(own.v)) samples.point(place_of(delaunay_, site));
  for (const FaceSlot member : faces) {
    if (member != face) add_triangle(triangles, delaunay_, member);
    for (const EdgeSlot edge : delaunay_.face(member).e)
      if (edge != kNoSlot && !crust_.is_cocircular(edge)) add_dual(edges, delaunay_, edge);
  }
  say_samples_on_circle(out, samples);
  say_triangles_on_circle(out, triangles);
  out.say_any(ProvenanceRole::product, "Voronoi edge ends here", "Voronoi edges end here", edges);
}

}  // namespace mes
