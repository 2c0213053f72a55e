// SPDX-License-Identifier: GPL-3.0-or-later
// Explains of which samples a Voronoi vertex is a pole, and the poles of a sample.
#include "core/structures/delaunay/explain_parts.h"
#include "core/structures/poles/poles.h"

namespace mes {

void Poles::explain(ElementKind kind, RowNumber row, Explanation& out) const {
  if (kind == ElementKind::site) explain_site(SiteSlot(row), out);
  if (kind == ElementKind::voronoi_vertex) explain_vertex(FaceSlot(row), out);
}

void Poles::explain_site(SiteSlot site, Explanation& out) const {
  if (delaunay_.dimension() != 2 || !delaunay_.is_site(site)) return;
  ProvenanceShapes poles;
  for (const FaceSlot pole : {plus(site), minus(site)})
    if (pole != kNoSlot && pole != kInfinitePole) poles.point(place_of(delaunay_, pole));
  const bool is_hull = plus(site) == kInfinitePole;
  out.say_any(ProvenanceRole::product, is_hull ? "pole, and one at infinity" : "pole", "poles", poles);
}

void Poles::explain_vertex(FaceSlot face, Explanation& out) const {
  if (!delaunay_.is_finite_face(face)) return;
  const FaceSlot vertex = vertices_.vertex(face);
  if (!is_pole(vertex)) return;
  std::vector<SiteSlot> sites;
  vertices_.append_sites(face, sites);
  ProvenanceShapes of;
  for (const SiteSlot site : sites)
    if (plus(site) == vertex || minus(site) == vertex) of.point(place_of(delaunay_, site));
  out.say_any(ProvenanceRole::product, "sample has it as a pole", "samples have it as a pole", of);
}

}  // namespace mes
