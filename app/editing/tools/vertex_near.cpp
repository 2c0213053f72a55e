// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/editing/tools/vertex_near.h"

#include <algorithm>
#include <cstdint>
#include <numeric>
#include <vector>

#include "core/kernel/circumcircle.h"

namespace mes {
namespace {

constexpr std::size_t kBorder = SIZE_MAX;

/// A corner of a cell, and the site beyond the side that begins there.
struct Corner {
  Vec2 at{};
  std::size_t beyond = kBorder;
};

/// Cuts off the part of a convex cell that is nearer to `other` than to `own`; points are relative to a nearby one.
void cut(std::vector<Corner>& cell, std::vector<Corner>& out, Vec2 own, Vec2 other, std::size_t name) {
  const Vec2 normal = other - own;
  const Vec2 middle = 0.5 * (own + other);
  const auto height = [&](Vec2 at) { return dot(at - middle, normal); };
  if (std::ranges::none_of(cell, [&](const Corner& corner) { return height(corner.at) > 0.0; })) return;
  out.clear();
  for (std::size_t i = 0; i < cell.size(); ++i) {
    const Corner& from = cell[i];
    const Corner& to = cell[(i + 1) % cell.size()];
    const double at_from = height(from.at);
    const double at_to = height(to.at);
    if (at_from <= 0.0) out.push_back(from);
    if ((at_from <= 0.0) == (at_to <= 0.0)) continue;
    const Vec2 crossing = from.at + (at_from / (at_from - at_to)) * (to.at - from.at);
    out.push_back({crossing, at_from <= 0.0 ? name : from.beyond});
  }
  cell.swap(out);
}

}  // namespace

std::optional<NearVertex> vertex_near(std::span<const Vec2> sites, Vec2 p, double reach) {
  std::vector<Vec2> places;
  for (const Vec2 site : sites) places.push_back(site - p);
  // Sorted by distance: the nearest sites cut off most.
  std::vector<std::size_t> order(sites.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::ranges::sort(order, {}, [&](std::size_t i) { return std::pair(length(places[i]), i); });
  std::optional<NearVertex> best;
  double nearest = reach;
  const auto offer = [&](std::array<std::size_t, 3> corners) {
    std::ranges::sort(corners);
    const Circle circle = circumcircle(sites[corners[0]], sites[corners[1]], sites[corners[2]]);
    const double away = distance(p, circle.center);
    if (!(away < nearest || (best && away == nearest && corners < best->corners))) return;
    // Cells were cut with rounding, so a site barely inside counts as on the circle.
    constexpr double kHair = 1.0 - 1e-9;
    if (std::ranges::any_of(sites, [&](Vec2 site) { return distance(site, circle.center) < kHair * circle.radius; }))
      return;
    nearest = away;
    best = NearVertex{corners, circle.center};
  };
  std::vector<Corner> cell;
  std::vector<Corner> cut_cell;
  for (const std::size_t own : order) {
    cell = {{{-reach, -reach}}, {{reach, -reach}}, {{reach, reach}}, {{-reach, reach}}};
    for (const std::size_t other : order) {
      if (other != own && places[other] != places[own]) cut(cell, cut_cell, places[own], places[other], other);
      if (cell.empty()) break;
    }
    for (std::size_t i = 0; i < cell.size(); ++i) {
      const std::size_t before = cell[(i + cell.size() - 1) % cell.size()].beyond;
      if (before != kBorder && cell[i].beyond != kBorder && before != cell[i].beyond)
        offer({own, before, cell[i].beyond});
    }
  }
  return best;
}

}  // namespace mes
