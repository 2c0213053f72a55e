// SPDX-License-Identifier: GPL-3.0-or-later
// Explains rows of the additively grown balls of a family.
#include <algorithm>
#include <array>
#include <string>

#include "core/structures/balls/grown_complex.h"
#include "core/structures/balls/internal/ball_places.h"

namespace mes {
namespace {

std::string from_growth_on(double growth) {
  return growth < 0.0 ? "there before balls grow" : "there from growth " + number_text(growth) + " on";
}

}  // namespace

void GrownComplex::explain_corner(GrownCornerSlot corner, Explanation& out) const {
  const BallFamily& family = filtration_.family();
  const FamilySlot ball = filtration_.ball(corner);
  const BallPlaces places(family, out);
  ProvenanceShapes itself, plain;
  itself.circle(disk(corner), places.follows(ball));
  out.say(ProvenanceRole::itself,
          "Ball of radius " + number_text(filtration_.disk(corner).radius) + ", grown additively to " +
              number_text(disk(corner).radius) + (is_alone(corner) ? ", which meets no other" : ""),
          itself);
  places.add_circle(plain, ball);
  out.say(ProvenanceRole::origin, "the ball as it is", plain);
}

void GrownComplex::explain_edge(GrownEdgeSlot edge, Explanation& out) const {
  const BallBirths::Edge& row = filtration_.edges()[edge];
  const BallPlaces places(filtration_.family(), out);
  ProvenanceShapes itself, circles;
  const auto center = [&](std::size_t i) { return places.center(filtration_.ball(row.v[i])); };
  itself.segment(center(0), center(1));
  out.say(ProvenanceRole::itself,
          "Edge of the dual complex of the grown balls, " + from_growth_on(filtration_.growth(row.rank)), itself);
  for (const GrownCornerSlot corner : row.v) circles.circle(disk(corner), places.follows(filtration_.ball(corner)));
  out.say(ProvenanceRole::origin, "2 balls that meet within their power cells", circles);
}

void GrownComplex::explain_triangle(GrownTriangleSlot triangle, Explanation& out) const {
  const BallBirths::Triangle& row = filtration_.triangles()[triangle];
  const BallPlaces places(filtration_.family(), out);
  ProvenanceShapes itself, circles;
  const auto center = [&](std::size_t i) { return places.center(filtration_.ball(row.v[i])); };
  itself.triangle(center(0), center(1), center(2));
  out.say(ProvenanceRole::itself,
          "Triangle of the dual complex of the grown balls, " + from_growth_on(filtration_.growth(row.rank)), itself);
  for (const GrownCornerSlot corner : row.v) circles.circle(disk(corner), places.follows(filtration_.ball(corner)));
  out.say(ProvenanceRole::origin, "3 balls that have a point in common", circles);
}

void GrownComplex::explain_end(GrownEndSlot end, Explanation& out) const {
  const auto drawn = this->drawn(end);
  if (!drawn) return;
  const BallBirths::Edge& edge = filtration_.edges()[GrownEdgeSlot(end.index() / 2)];
  const BallPlaces places(filtration_.family(), out);
  ProvenanceShapes itself, ball, first;
  const FamilySlot around = filtration_.ball(edge.v[end.index() % 2]);
  itself.arc({drawn->center, drawn->radius}, drawn->from, drawn->to, places.follows(around));
  out.say(ProvenanceRole::itself,
          "Arc on the boundary of the union of the grown balls, radius " + number_text(drawn->radius), itself);
  places.add_circle(ball, around);
  out.say(ProvenanceRole::origin, "its ball before it grew", ball);
  first.segment(places.center(filtration_.ball(edge.v[0])), places.center(filtration_.ball(edge.v[1])));
  out.say(ProvenanceRole::origin, "the edge whose two circles cross where it begins", first);
}

void GrownComplex::explain_class(const BallFiltration::Class& one, Explanation& out) const {
  const bool stays = one.death == BallFiltration::kNever;
  const auto at = [this](std::uint32_t rank) {
    const double growth = filtration_.growth(rank);
    return growth < 0.0 ? "before balls grow" : "at growth " + number_text(growth);
  };
  const BallPlaces places(filtration_.family(), out);
  const auto center = [&](GrownCornerSlot corner) { return places.center(filtration_.ball(corner)); };
  ProvenanceShapes itself, edge, triangle;
  if (one.edge != kNoSlot) {
    const auto& v = filtration_.edges()[one.edge].v;
    edge.segment(center(v[0]), center(v[1]));
  }
  if (one.is_hole) {
    const BallBirths::Triangle& row = filtration_.triangles()[one.triangle];
    itself.circle({row.center, std::max(0.0, filtration_.growth(one.death))});
    out.say(ProvenanceRole::itself,
            "Hole between the grown balls, closed " + at(one.birth) + ", filled " + at(one.death), itself);
    out.say(ProvenanceRole::origin, "the edge that closes it", edge);
    triangle.triangle(center(row.v[0]), center(row.v[1]), center(row.v[2]));
    return out.say(ProvenanceRole::product, "the triangle that fills it", triangle);
  }
  itself.point(center(one.corner));
  out.say(ProvenanceRole::itself,
          "Component of the grown balls, born " + at(one.birth) + (stays ? ", stays" : ", joined " + at(one.death)),
          itself);
  if (!stays) out.say(ProvenanceRole::product, "the edge that joins it to an older one", edge);
}

void GrownComplex::explain(ElementKind kind, RowNumber row, Explanation& out) const {
  switch (kind) {
    case ElementKind::alpha_corner:
      if (const GrownCornerSlot corner(row); filtration_.corners().has(corner)) explain_corner(corner, out);
      return;
    case ElementKind::alpha_edge:
      if (const GrownEdgeSlot edge(row); filtration_.edges().has(edge) && holds(edge)) explain_edge(edge, out);
      return;
    case ElementKind::alpha_triangle:
      if (const GrownTriangleSlot triangle(row); filtration_.triangles().has(triangle) && holds(triangle))
        explain_triangle(triangle, out);
      return;
    case ElementKind::alpha_end:
      if (filtration_.edges().has(GrownEdgeSlot(row / 2))) explain_end(GrownEndSlot(row), out);
      return;
    case ElementKind::alpha_class:
      if (row < filtration_.classes().size()) explain_class(filtration_.classes()[row], out);
      return;
    default: return;
  }
}

}  // namespace mes
