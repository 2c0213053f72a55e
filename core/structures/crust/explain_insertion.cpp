// SPDX-License-Identifier: GPL-3.0-or-later
// Changes that a new sample would make in the one-step crust.
#include <optional>

#include "core/base/counted.h"
#include "core/structures/crust/one_step_crust.h"
#include "core/structures/delaunay/insertion_zone.h"

namespace mes {

void OneStepCrust::explain_insertion(Vec2 at, Explanation& out) const {
  if (delaunay_.dimension() < 2) return;
  const InsertionZone zone(delaunay_, at, out);
  ProvenanceShapes gone, come;
  std::size_t goes = 0, comes = 0;
  const auto position = [&](SiteSlot site) { return delaunay_.site_position(site); };
  const auto apex = [&](SiteSlot site) {
    return site == kInfiniteSite ? std::nullopt : std::optional(position(site));
  };
  FilterCounts counts;
  // Puts a finite apex on the left.
  const auto is_curve = [&](Vec2 from, Vec2 to, std::optional<Vec2> left, std::optional<Vec2> right) {
    if (!left) return right && classify_edge({*right, to, from, {}}, counts).is_crust;
    return classify_edge({*left, from, to, right}, counts).is_crust;
  };
  for (const EdgeSlot edge : zone.inner_edges()) {
    if (!is_crust(edge)) continue;
    gone.segment(position(delaunay_.edge(edge).v[0]), position(delaunay_.edge(edge).v[1]));
    ++goes;
  }
  const auto& sides = zone.sides();
  for (std::size_t i = 0; i < sides.size(); ++i) {
    const InsertionZone::Side& side = sides[i];
    const InsertionZone::Side& after = sides[(i + 1) % sides.size()];
    if (side.to != kInfiniteSite && is_curve(at, position(side.to), apex(after.to), apex(side.from))) {
      come.segment(at, position(side.to));
      ++comes;
    }
    if (side.edge == kNoSlot) continue;
    const Vec2 from = position(side.from);
    const Vec2 to = position(side.to);
    const bool was = is_crust(side.edge);
    const bool is = is_curve(from, to, at, apex(delaunay_.apex(side.beyond, side.edge)));
    if (was && !is) {
      gone.segment(from, to);
      ++goes;
    }
    if (is && !was) {
      come.segment(from, to);
      ++comes;
    }
  }
  if (goes != 0)
    out.say(ProvenanceRole::origin, counted(goes, "edge of the curve removed", "edges of the curve removed"), gone,
            true);
  if (comes != 0)
    out.say(ProvenanceRole::product, counted(comes, "edge of the curve added", "edges of the curve added"), come,
            true);
}

}  // namespace mes
