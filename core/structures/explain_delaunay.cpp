// SPDX-License-Identifier: GPL-3.0-or-later
// What rows of `Delaunay` are. Sites, edges and Voronoi vertices are what crust, labels, balls and axis are about, so
// that is explained here too, which is why this file lies above their rooms.
#include <algorithm>
#include <string>
#include <vector>

#include "core/graph/explain.h"
#include "core/structures/axis/inner_balls.h"
#include "core/structures/axis/medial_axis.h"
#include "core/structures/crust/labels.h"
#include "core/structures/crust/one_step_crust.h"
#include "core/structures/crust/voronoi_vertices.h"
#include "core/structures/delaunay/delaunay.h"

namespace mes {
namespace {

// The Voronoi edge; one that leads to infinity as a ray.
void add_dual(ProvenanceShapes& shapes, const Delaunay& delaunay, EdgeSlot edge) {
  const EdgeRow& row = delaunay.edge(edge);
  const Vec2 a = delaunay.site_position(row.v[0]);
  const Vec2 b = delaunay.site_position(row.v[1]);
  if (row.f[0] == kNoSlot) return shapes.line(0.5 * (a + b), perpendicular(b - a));
  const bool left = delaunay.is_finite_face(row.f[0]);
  const bool right = delaunay.is_finite_face(row.f[1]);
  if (left && right) return shapes.segment(delaunay.circumcenter(row.f[0]), delaunay.circumcenter(row.f[1]));
  if (left) return shapes.ray(delaunay.circumcenter(row.f[0]), -perpendicular(b - a));
  shapes.ray(delaunay.circumcenter(row.f[1]), perpendicular(b - a));
}
void add_triangle(ProvenanceShapes& shapes, const Delaunay& delaunay, FaceSlot face) {
  const auto& v = delaunay.face(face).v;
  shapes.triangle(delaunay.site_position(v[0]), delaunay.site_position(v[1]), delaunay.site_position(v[2]));
}
Disk disk_of(const Delaunay& delaunay, FaceSlot face) {
  return {delaunay.circumcenter(face), delaunay.circumradius(face)};
}

void explain_site(const Delaunay& delaunay, SiteSlot site, Explanation& out) {
  if (!delaunay.is_site(site)) return;
  ProvenanceShapes shapes;
  shapes.point(delaunay.site_position(site));
  std::size_t copies = 0;
  for (SampleSlot s = delaunay.site_sample(site); s != kNoSlot; s = delaunay.next_duplicate(s)) ++copies;
  out.say(ProvenanceRole::itself,
          "Sample at " + place_text(delaunay.site_position(site)) +
              (copies > 1 ? ", " + std::to_string(copies) + " times" : ""),
          shapes);
  ProvenanceShapes cell, curve, balls;
  const auto* crust = out.current<OneStepCrust>();
  const auto* inner = out.current<InnerBalls>();
  std::vector<FaceSlot> seen;
  delaunay.for_each_edge_at(site, [&](EdgeSlot edge, SiteSlot other, FaceSlot left) {
    add_dual(cell, delaunay, edge);
    if (crust != nullptr && crust->is_crust(edge))
      curve.segment(delaunay.site_position(site), delaunay.site_position(other));
    if (inner == nullptr || left == kNoSlot || !delaunay.is_finite_face(left) || !inner->is_ball(left)) return;
    if (std::ranges::find(seen, inner->ball(left)) != seen.end()) return;
    seen.push_back(inner->ball(left));
    balls.circle(disk_of(delaunay, inner->ball(left)));
  });
  out.say_any(ProvenanceRole::product, "side of its Voronoi cell", "sides of its Voronoi cell", cell);
  out.say_any(ProvenanceRole::product, "curve edge", "curve edges", curve);
  out.say_any(ProvenanceRole::product, "inner Voronoi ball touches it", "inner Voronoi balls touch it", balls);
}

void explain_voronoi_vertex(const Delaunay& delaunay, FaceSlot face, Explanation& out) {
  if (!delaunay.is_finite_face(face)) return;
  const auto* vertices = out.current<VoronoiVertices>();
  const FaceSlot vertex = vertices != nullptr ? vertices->vertex(face) : face;
  const Disk disk = disk_of(delaunay, vertex);
  const auto* labels = out.current<Labels>();
  const bool is_inside = labels != nullptr && labels->is_inside(face);
  ProvenanceShapes itself, samples, triangles, edges, axis;
  itself.point(disk.center);
  itself.circle(disk);
  out.say(
      ProvenanceRole::itself,
      std::string(labels == nullptr ? "Voronoi vertex" : (is_inside ? "Inner Voronoi ball" : "Outer Voronoi ball")) +
          " at " + place_text(disk.center) + ", radius " + number_text(disk.radius),
      itself);
  std::vector<SiteSlot> sites;
  std::vector<FaceSlot> faces{face};
  if (vertices != nullptr) {
    vertices->append_sites(face, sites);
    if (const auto* group = vertices->group(face)) faces = *group;
  } else {
    sites.assign(std::begin(delaunay.face(face).v), std::end(delaunay.face(face).v));
  }
  for (const SiteSlot site : sites) samples.point(delaunay.site_position(site));
  out.say(ProvenanceRole::origin, "touches " + count_text(sites.size(), "sample", "samples"), samples);
  const auto* crust = out.current<OneStepCrust>();
  const auto* medial = out.current<MedialAxis>();
  for (const FaceSlot f : faces) {
    add_triangle(triangles, delaunay, f);
    for (const EdgeSlot edge : delaunay.face(f).e) {
      if (edge == kNoSlot || (crust != nullptr && crust->is_cocircular(edge))) continue;
      add_dual(medial != nullptr && medial->is_axis_edge(edge) ? axis : edges, delaunay, edge);
    }
  }
  out.say_any(ProvenanceRole::origin, "Delaunay triangle", "Delaunay triangles on one circle", triangles);
  out.say_any(ProvenanceRole::product, "medial axis edge ends here", "medial axis edges end here", axis);
  out.say_any(ProvenanceRole::product, "other Voronoi edge", "other Voronoi edges", edges);
}

void explain_edge(const Delaunay& delaunay, EdgeSlot edge, Explanation& out) {
  if (!delaunay.edge(edge).is_alive()) return;
  const EdgeRow& row = delaunay.edge(edge);
  const Vec2 a = delaunay.site_position(row.v[0]);
  const Vec2 b = delaunay.site_position(row.v[1]);
  const auto* crust = out.current<OneStepCrust>();
  const auto* medial = out.current<MedialAxis>();
  const bool is_axis = medial != nullptr && medial->is_axis_edge(edge);
  std::string what = "Delaunay edge and its Voronoi edge";
  if (crust != nullptr)
    what = crust->is_crust(edge) ? "Curve edge" : (is_axis ? "Medial axis edge" : "Skeleton edge");
  ProvenanceShapes itself, samples, triangles, balls;
  itself.segment(a, b);
  add_dual(itself, delaunay, edge);
  out.say(ProvenanceRole::itself, what + ", samples " + number_text(distance(a, b)) + " apart", itself);
  samples.point(a);
  samples.point(b);
  out.say(ProvenanceRole::origin, "2 samples, both at equal distance all along the Voronoi edge", samples);
  for (const FaceSlot face : row.f) {
    if (face == kNoSlot || !delaunay.is_finite_face(face)) continue;
    add_triangle(triangles, delaunay, face);
    balls.circle(disk_of(delaunay, face));
  }
  out.say_any(ProvenanceRole::origin, "Delaunay triangle at it", "Delaunay triangles at it", triangles);
  out.say_any(ProvenanceRole::product, "Voronoi ball at its one end", "Voronoi balls at its ends", balls);
}

}  // namespace

void Delaunay::explain(ElementKind kind, RowNumber row, Explanation& out) const {
  switch (kind) {
    case ElementKind::sample:
      if (const SiteSlot site = site_of_sample(SampleSlot(row)); site != kNoSlot) out.about(ElementKind::site, site);
      return;
    case ElementKind::site: return explain_site(*this, SiteSlot(row), out);
    case ElementKind::voronoi_vertex: return explain_voronoi_vertex(*this, FaceSlot(row), out);
    case ElementKind::delaunay_edge: return explain_edge(*this, EdgeSlot(row), out);
    default: return;
  }
}

}  // namespace mes
