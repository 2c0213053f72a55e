// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/core.h>
#include <algorithm>
#include <cmath>
#include <optional>

#include "core/edit/degenerate_places.h"
#include "core/edit/internal/common_grid.h"
#include "core/edit/internal/distinct_places.h"
#include "core/kernel/circumcircle.h"

namespace mes {
namespace {

/// Direction of the least-squares line through the mean, as a unit vector. The points must not all be equal.
Vec2 direction_of(std::span<const Vec2> places, Vec2 mean, double scale) {
  double xx = 0.0;
  double xy = 0.0;
  double yy = 0.0;
  for (const Vec2 p : places) {
    const Vec2 d = (1.0 / scale) * (p - mean);
    xx += d.x * d.x;
    xy += d.x * d.y;
    yy += d.y * d.y;
  }
  const double angle = 0.5 * std::atan2(2.0 * xy, xx - yy);
  return {std::cos(angle), std::sin(angle)};
}

/// Integer points A + t d nearest to the given ones; nothing if they leave the grid.
std::optional<std::vector<Vec2>> along(std::span<const GridPoint> points, GridPoint a, GridPoint d,
                                       const CommonGrid& grid) {
  const auto dx = static_cast<long double>(d.x);
  const auto dy = static_cast<long double>(d.y);
  const long double square = dx * dx + dy * dy;
  std::vector<Vec2> out;
  out.reserve(points.size());
  for (const GridPoint p : points) {
    const long double along_d =
        (static_cast<long double>(p.x - a.x) * dx + static_cast<long double>(p.y - a.y) * dy) / square;
    const std::int64_t t = std::llround(along_d);
    const GridPoint q{a.x + t * d.x, a.y + t * d.y};
    if (!grid.holds(q)) return std::nullopt;
    out.push_back(grid.place(q));
  }
  return out;
}

/// Integer directions that approximate a unit vector ever better: the convergents of its slope.
std::vector<GridPoint> convergents(Vec2 direction) {
  constexpr double kMostSteps = 1e9;
  const bool is_steep = std::abs(direction.y) > std::abs(direction.x);
  double rest = is_steep ? direction.x / direction.y : direction.y / direction.x;
  const double sign = rest < 0.0 ? -1.0 : 1.0;
  rest = std::abs(rest);
  // Numerators and denominators of this convergent and the previous one.
  double p0 = 1.0;
  double q0 = 0.0;
  double p = 0.0;
  double q = 1.0;
  std::vector<GridPoint> out;
  for (;;) {
    const auto minor = static_cast<std::int64_t>(sign * p);
    const auto major = static_cast<std::int64_t>(q);
    out.push_back(is_steep ? GridPoint{minor, major} : GridPoint{major, minor});
    if (rest <= 0.0 || 1.0 / rest > kMostSteps) return out;
    const double next = std::floor(1.0 / rest);
    rest = 1.0 / rest - next;
    const double p1 = next * p + p0;
    const double q1 = next * q + q0;
    if (q1 > kMostSteps) return out;
    p0 = p;
    q0 = q;
    p = p1;
    q = q1;
  }
}

/// Decides collinearity exactly.
bool are_collinear(std::span<const Vec2> places) {
  return std::ranges::all_of(places.subspan(2),
                             [&](Vec2 p) { return !std::isfinite(circumcircle(places[0], places[1], p).radius); });
}

}  // namespace

Expected<DegeneratePlaces> on_one_line(std::span<const Vec2> places) {
  if (const auto twice = repeated_place(places)) return refuse_repeated(*twice);
  if (places.size() < 3 || are_collinear(places)) return DegeneratePlaces{{places.begin(), places.end()}, 0.0};
  const Vec2 mean = mean_of(places);
  double extent = 0.0;
  for (const Vec2 p : places) extent = std::max(extent, distance(p, mean));
  const CommonGrid grid(largest_magnitude(places));
  std::vector<GridPoint> points;
  points.reserve(places.size());
  for (const Vec2 p : places) points.push_back(grid.rounded(p));
  // Also tries a line through one of the points, so that points already on a line stay.
  const Vec2 direction = direction_of(places, mean, extent);
  const auto off = [&](Vec2 p) { return std::abs(cross(direction, p - mean)); };
  const Vec2 nearest = *std::ranges::min_element(places, {}, off);
  std::optional<DegeneratePlaces> best;
  for (const Vec2 from : {nearest, mean}) {
    for (const GridPoint d : convergents(direction)) {
      auto moved = along(points, grid.rounded(from), d, grid);
      if (!moved || !are_distinct(*moved)) continue;
      const double shift = largest_shift(places, *moved);
      if (!best || shift < best->largest_shift) best = DegeneratePlaces{std::move(*moved), shift};
    }
  }
  if (!best) {
    const double farthest = off(*std::ranges::max_element(places, {}, off));
    return std::unexpected(Error{ErrorCode::bad_input,
                                 fmt::format("two of the places would become the same, being too near to each other "
                                             "along the line; they stay within {:.3g} of the nearest line",
                                             farthest)});
  }
  return *std::move(best);
}

}  // namespace mes
