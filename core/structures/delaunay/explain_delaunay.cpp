// SPDX-License-Identifier: GPL-3.0-or-later
// Explains rows of `Delaunay`: samples, their Voronoi cells, triangles with their Voronoi vertices, edges.
#include <fmt/core.h>

#include "core/structures/delaunay/explain_parts.h"

namespace mes {

ShapePlace place_of(const Delaunay& delaunay, SiteSlot site) {
  return {delaunay.site_position(site), {.samples = {delaunay.site_sample(site)}}};
}

Followed corners_of(const Delaunay& delaunay, FaceSlot face) {
  const auto& v = delaunay.face(face).v;
  return {.samples = {delaunay.site_sample(v[0]), delaunay.site_sample(v[1]), delaunay.site_sample(v[2])}};
}

void add_dual(ProvenanceShapes& shapes, const Delaunay& delaunay, EdgeSlot edge) {
  const EdgeRow& row = delaunay.edge(edge);
  const ShapePlace a = place_of(delaunay, row.v[0]);
  const ShapePlace b = place_of(delaunay, row.v[1]);
  if (row.f[0] == kNoSlot) return shapes.bisector(a, b);
  const bool left = delaunay.is_finite_face(row.f[0]);
  const bool right = delaunay.is_finite_face(row.f[1]);
  if (left && right) return shapes.segment(place_of(delaunay, row.f[0]), place_of(delaunay, row.f[1]));
  if (left) return shapes.ray_along_bisector(place_of(delaunay, row.f[0]), b, a);
  shapes.ray_along_bisector(place_of(delaunay, row.f[1]), a, b);
}

void add_triangle(ProvenanceShapes& shapes, const Delaunay& delaunay, FaceSlot face) {
  const auto& v = delaunay.face(face).v;
  shapes.triangle(place_of(delaunay, v[0]), place_of(delaunay, v[1]), place_of(delaunay, v[2]));
}

void say_samples_on_circle(Explanation& out, ProvenanceShapes& samples) {
  out.say_any(ProvenanceRole::origin, "sample on its circle", "samples on its circle", samples);
}

void say_triangles_on_circle(Explanation& out, ProvenanceShapes& triangles) {
  out.say_any(ProvenanceRole::origin, "Delaunay triangle", "Delaunay triangles on one circle", triangles);
}

namespace {

void explain_site(const Delaunay& delaunay, SiteSlot site, Explanation& out) {
  if (!delaunay.is_site(site)) return;
  ProvenanceShapes itself, cell;
  itself.point(place_of(delaunay, site));
  std::size_t copies = 0;
  for (SampleSlot s = delaunay.site_sample(site); s != kNoSlot; s = delaunay.next_duplicate(s)) ++copies;
  out.say_itself("Sample",
                 fmt::format(" at {}{}", place_text(delaunay.site_position(site)),
                             copies > 1 ? fmt::format(", {} times", copies) : ""),
                 itself);
  delaunay.for_each_edge_at(site, [&](EdgeSlot edge, SiteSlot, FaceSlot) { add_dual(cell, delaunay, edge); });
  out.say_any(ProvenanceRole::product, "side of its Voronoi cell", "sides of its Voronoi cell", cell);
}

void explain_voronoi_vertex(const Delaunay& delaunay, FaceSlot face, Explanation& out) {
  if (!delaunay.is_finite_face(face)) return;
  const Disk disk = circumdisk(delaunay, face);
  ProvenanceShapes itself, samples, triangles;
  itself.point(place_of(delaunay, face));
  itself.circle(disk, corners_of(delaunay, face));
  for (const SiteSlot site : delaunay.face(face).v) samples.point(place_of(delaunay, site));
  add_triangle(triangles, delaunay, face);
  out.say_itself("Voronoi vertex",
                 fmt::format(" at {}, radius {}", place_text(disk.center), number_text(disk.radius)), itself);
  say_samples_on_circle(out, samples);
  say_triangles_on_circle(out, triangles);
}

void explain_edge(const Delaunay& delaunay, EdgeSlot edge, Explanation& out) {
  if (!delaunay.edge(edge).is_alive()) return;
  const EdgeRow& row = delaunay.edge(edge);
  const ShapePlace a = place_of(delaunay, row.v[0]);
  const ShapePlace b = place_of(delaunay, row.v[1]);
  ProvenanceShapes itself, samples, triangles, balls;
  itself.segment(a, b);
  add_dual(itself, delaunay, edge);
  out.say_itself("Delaunay edge and its Voronoi edge", ", samples " + number_text(distance(a.at, b.at)) + " apart",
                 itself);
  samples.point(a);
  samples.point(b);
  out.say(ProvenanceRole::origin, "2 samples, both at equal distance all along the Voronoi edge", samples);
  for (const FaceSlot face : row.f) {
    if (face == kNoSlot || !delaunay.is_finite_face(face)) continue;
    add_triangle(triangles, delaunay, face);
    balls.circle(circumdisk(delaunay, face), corners_of(delaunay, face));
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
