// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/edit/internal/distinct_places.h"

#include <fmt/core.h>
#include <algorithm>
#include <vector>

namespace mes {

std::optional<Vec2> repeated_place(std::span<const Vec2> places) {
  std::vector<Vec2> sorted(places.begin(), places.end());
  std::ranges::sort(sorted, lexicographically_less);
  const auto twice = std::ranges::adjacent_find(sorted);
  return twice == sorted.end() ? std::nullopt : std::optional(*twice);
}

std::unexpected<Error> refuse_repeated(Vec2 place) {
  return std::unexpected(
      Error{ErrorCode::bad_input, fmt::format("two of the places are the same: {}, {}", place.x, place.y)});
}

double largest_shift(std::span<const Vec2> from, std::span<const Vec2> to) {
  double out = 0.0;
  for (std::size_t i = 0; i < from.size(); ++i) out = std::max(out, distance(from[i], to[i]));
  return out;
}

}  // namespace mes
