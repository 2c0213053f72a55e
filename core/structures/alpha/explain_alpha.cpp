// SPDX-License-Identifier: GPL-3.0-or-later
// Explains rows of the alpha complex of the samples, and its part in rows of `Delaunay`.
#include <string>

#include "core/structures/alpha/alpha_complex.h"
#include "core/structures/delaunay/explain_parts.h"

namespace mes {
namespace {

std::string from_radius_on(double radius, bool is_held) {
  return "in the alpha complex from radius " + number_text(radius) + " on: " + (is_held ? "there" : "not yet");
}

}  // namespace

void AlphaComplex::explain_end(EdgeEndSlot row, Explanation& out) const {
  const EdgeSlot edge(row.index() / 2);
  if (edge.index() >= delaunay_.edge_rows() || !delaunay_.edge(edge).is_alive()) return;
  const auto drawn = arc(row);
  if (!drawn) return;
  const SiteSlot site = delaunay_.edge(edge).v[row.index() % 2];
  ProvenanceShapes itself, sample, first;
  itself.arc({drawn->center, drawn->radius}, drawn->from, drawn->to, place_of(delaunay_, site).follows);
  out.say(ProvenanceRole::itself,
          "Arc on the boundary of the union of the alpha disks, radius " + number_text(radius_), itself);
  sample.point(place_of(delaunay_, site));
  out.say(ProvenanceRole::origin, "the sample that it goes around", sample);
  const SiteSlot* const v = delaunay_.edge(edge).v;
  first.segment(place_of(delaunay_, v[0]), place_of(delaunay_, v[1]));
  out.say(ProvenanceRole::origin, "the edge whose two circles cross where it begins", first);
}

void AlphaComplex::explain_class(const AlphaFiltration::Class& one, Explanation& out) const {
  const bool stays = one.death == AlphaFiltration::kNever;
  const std::string birth = number_text(filtration_.radius(one.birth));
  const std::string death = stays ? std::string() : number_text(filtration_.radius(one.death));
  ProvenanceShapes itself, edge, triangle;
  if (one.edge != kNoSlot) {
    const SiteSlot* const v = delaunay_.edge(one.edge).v;
    edge.segment(place_of(delaunay_, v[0]), place_of(delaunay_, v[1]));
  }
  if (one.is_hole) {
    itself.circle(circumdisk(delaunay_, one.face), corners_of(delaunay_, one.face));
    out.say(ProvenanceRole::itself, "Hole of the alpha complex, closed at radius " + birth + ", filled at " + death,
            itself);
    out.say(ProvenanceRole::origin, "the edge that closes it", edge);
    add_triangle(triangle, delaunay_, one.face);
    out.say(ProvenanceRole::product, "the triangle that fills it", triangle);
    return;
  }
  itself.point(place_of(delaunay_, one.site));
  out.say(ProvenanceRole::itself,
          "Component of the alpha complex, born at radius " + birth + (stays ? ", stays" : ", joined at " + death),
          itself);
  if (!stays) out.say(ProvenanceRole::product, "the edge that joins it to an older one", edge);
}

void AlphaComplex::explain(ElementKind kind, RowNumber row, Explanation& out) const {
  ProvenanceShapes shapes;
  switch (kind) {
    case ElementKind::site: {
      const SiteSlot site(row);
      if (!delaunay_.is_site(site) || !(radius_ > 0.0)) return;
      shapes.circle({delaunay_.site_position(site), radius_}, place_of(delaunay_, site).follows);
      return out.say(
          ProvenanceRole::product,
          "its alpha disk has radius " + number_text(radius_) + (is_alone_[site] != 0 ? ", and meets no other" : ""),
          shapes);
    }
    case ElementKind::delaunay_edge: {
      const EdgeSlot edge(row);
      if (!delaunay_.edge(edge).is_alive()) return;
      const SiteSlot* const v = delaunay_.edge(edge).v;
      if (holds(edge)) shapes.segment(place_of(delaunay_, v[0]), place_of(delaunay_, v[1]));
      return out.say(ProvenanceRole::product, from_radius_on(filtration_.radius(filtration_.rank(edge)), holds(edge)),
                     shapes);
    }
    case ElementKind::voronoi_vertex: {
      const FaceSlot face(row);
      if (!delaunay_.is_finite_face(face)) return;
      if (holds(face)) add_triangle(shapes, delaunay_, face);
      return out.say(ProvenanceRole::product,
                     "its triangle is " + from_radius_on(filtration_.radius(filtration_.rank(face)), holds(face)),
                     shapes);
    }
    case ElementKind::alpha_end: return explain_end(EdgeEndSlot(row), out);
    case ElementKind::alpha_class:
      if (row < filtration_.classes().size()) explain_class(filtration_.classes()[row], out);
      return;
    default: return;
  }
}

}  // namespace mes
