// SPDX-License-Identifier: GPL-3.0-or-later
// Explains the part of inner balls and axis in the rows that they share with `Delaunay`.
#include <algorithm>
#include <vector>

#include "core/structures/axis/inner_balls.h"
#include "core/structures/axis/medial_axis.h"
#include "core/structures/delaunay/explain_parts.h"

namespace mes {

void InnerBalls::explain(ElementKind kind, RowNumber row, Explanation& out) const {
  const SiteSlot site(row);
  if (kind != ElementKind::site || !delaunay_.is_site(site)) return;
  ProvenanceShapes balls;
  std::vector<FaceSlot> seen;
  delaunay_.for_each_edge_at(site, [&](EdgeSlot, SiteSlot, FaceSlot left) {
    if (left == kNoSlot || !is_ball(left) || std::ranges::find(seen, ball(left)) != seen.end()) return;
    seen.push_back(ball(left));
    balls.circle(circumdisk(delaunay_, ball(left)), corners_of(delaunay_, ball(left)));
  });
  out.say_any(ProvenanceRole::product, "inner Voronoi ball touches it", "inner Voronoi balls touch it", balls);
}

void MedialAxis::explain(ElementKind kind, RowNumber row, Explanation& out) const {
  if (kind == ElementKind::delaunay_edge) {
    const EdgeSlot edge(row);
    if (delaunay_.edge(edge).is_alive() && is_axis_edge(edge) && !crust_.is_crust(edge))
      out.rename("Medial axis edge");
  }
  const FaceSlot face(row);
  if (kind != ElementKind::voronoi_vertex || !delaunay_.is_finite_face(face)) return;
  std::vector<FaceSlot> faces{face};
  if (const auto* together = balls_.group(face)) faces = *together;
  ProvenanceShapes edges;
  for (const FaceSlot member : faces)
    for (const EdgeSlot edge : delaunay_.face(member).e)
      if (edge != kNoSlot && is_axis_edge(edge) && !is_zero_length(edge)) add_dual(edges, delaunay_, edge);
  out.say_any(ProvenanceRole::product, "medial axis edge ends here", "medial axis edges end here", edges);
}

}  // namespace mes
