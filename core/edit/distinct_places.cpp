// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/edit/internal/distinct_places.h"

#include <algorithm>

namespace mes {

bool are_distinct(std::span<const Vec2> places) {
  std::vector<Vec2> sorted(places.begin(), places.end());
  std::ranges::sort(sorted, lexicographically_less);
  return std::ranges::adjacent_find(sorted) == sorted.end();
}

double largest_shift(std::span<const Vec2> from, std::span<const Vec2> to) {
  double out = 0.0;
  for (std::size_t i = 0; i < from.size(); ++i) out = std::max(out, distance(from[i], to[i]));
  return out;
}

}  // namespace mes
