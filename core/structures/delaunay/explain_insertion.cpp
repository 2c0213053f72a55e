// SPDX-License-Identifier: GPL-3.0-or-later
// Changes that a new sample would make in the Delaunay triangulation and the Voronoi diagram.
#include <optional>

#include "core/base/counted.h"
#include "core/kernel/circumcircle.h"
#include "core/structures/delaunay/explain_parts.h"
#include "core/structures/delaunay/insertion_zone.h"

namespace mes {
namespace {

// Adds the Voronoi edge between the new sample and the corner after a side; one of the two faces may be infinite.
void add_cell_edge(ProvenanceShapes& cell, const Delaunay& delaunay, Vec2 at, const InsertionZone::Side& before,
                   const InsertionZone::Side& after) {
  const Vec2 corner = delaunay.site_position(before.to);
  const auto center = [&](const InsertionZone::Side& side) -> std::optional<Vec2> {
    if (side.from == kInfiniteSite || side.to == kInfiniteSite) return std::nullopt;
    return circumcircle(at, delaunay.site_position(side.from), delaunay.site_position(side.to)).center;
  };
  const auto right = center(before);
  const auto left = center(after);
  if (left && right) cell.segment(*right, *left);
  if (left && !right) cell.ray(*left, -perpendicular(corner - at));
  if (right && !left) cell.ray(*right, perpendicular(corner - at));
}

}  // namespace

void Delaunay::explain_insertion(Vec2 at, Explanation& out) const {
  if (dimension() < 2) return;
  const InsertionZone zone(*this, at, out);
  if (!zone.is_free()) return;
  ProvenanceShapes itself, triangles, edges;
  itself.point(at);
  const auto& sides = zone.sides();
  std::size_t neighbours = 0;
  for (std::size_t i = 0; i < sides.size(); ++i) {
    if (sides[i].to == kInfiniteSite) continue;
    add_cell_edge(itself, *this, at, sides[i], sides[(i + 1) % sides.size()]);
    edges.segment(at, site_position(sides[i].to));
    ++neighbours;
  }
  std::size_t finite = 0;
  for (const FaceSlot face : zone.faces()) {
    if (!is_finite_face(face)) continue;
    add_triangle(triangles, *this, face);
    ++finite;
  }
  out.say(ProvenanceRole::itself, "Sample at " + place_text(at) + ", with its Voronoi cell", itself);
  if (finite != 0)
    out.say(ProvenanceRole::origin, counted(finite, "Delaunay triangle removed", "Delaunay triangles removed"),
            triangles);
  out.say(ProvenanceRole::product, counted(neighbours, "Delaunay edge added", "Delaunay edges added"), edges);
}

}  // namespace mes
