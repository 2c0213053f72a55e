// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/editing/places/neighborhood.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace mes {

Box2 neighborhood_of(const Document& document, Vec2 place) {
  constexpr std::size_t kNeighbors = 20;
  std::vector<double> distances;
  distances.reserve(document.sample_count() + document.ball_count());
  for (const SampleSlot slot : slots_below<SampleSlot>(document.slot_count()))
    if (document.is_alive(slot)) distances.push_back(distance(document.position(slot), place));
  for (const BallSlot slot : slots_below<BallSlot>(document.ball_slot_count())) {
    if (!document.is_ball_alive(slot)) continue;
    const Disk& disk = document.disk(slot);
    const double to_center = distance(disk.center, place);
    distances.push_back(std::min(to_center, std::abs(to_center - disk.radius)));
  }
  double reach = 0.0;
  if (!distances.empty()) {
    const std::size_t last = std::min(kNeighbors, distances.size()) - 1;
    const auto farthest = distances.begin() + static_cast<std::ptrdiff_t>(last);
    std::ranges::nth_element(distances, farthest);
    reach = *farthest;
  }
  return {{place.x - reach, place.y - reach}, {place.x + reach, place.y + reach}};
}

}  // namespace mes
