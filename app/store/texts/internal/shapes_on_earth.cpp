// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/store/texts/internal/shapes_on_earth.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

namespace mes {
namespace {

using Places = std::vector<Vec2>;

Vec2 crossing(Vec2 from, Vec2 to, double longitude) {
  const double t = (longitude - from.x) / (to.x - from.x);
  return {longitude, from.y + t * (to.y - from.y)};
}

/// Adds a corner where a side crosses the meridian without ending on it.
template <class Use>
void for_each_with_crossings(const Places& corners, double longitude, Use use) {
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const bool crosses = i != 0 && (corners[i - 1].x - longitude) * (corners[i].x - longitude) < 0.0;
    if (crosses) use(crossing(corners[i - 1], corners[i], longitude));
    use(corners[i]);
  }
}

/// Cuts the chain into pieces that each lie on one side.
std::vector<Places> cut_chain(const Places& corners, double longitude) {
  std::vector<Places> out(1);
  double side = 0.0;
  for_each_with_crossings(corners, longitude, [&](Vec2 p) {
    const double here = p.x - longitude;
    if (here * side < 0.0) {
      // The previous corner lies on the meridian.
      const Vec2 on = out.back().back();
      out.push_back({on});
    }
    if (here != 0.0) side = here;
    out.back().push_back(p);
  });
  return out;
}

/// The part of the ring on one side, `sign` times east of the meridian. A ring that crosses it several times gives a
/// ring that touches itself there.
Places cut_ring(const Places& corners, double longitude, double sign) {
  Places out;
  for_each_with_crossings(corners, longitude, [&](Vec2 p) {
    if (sign * (p.x - longitude) >= 0.0 && (out.empty() || out.back() != p)) out.push_back(p);
  });
  if (!out.empty() && out.front() != out.back()) out.push_back(out.front());
  constexpr std::size_t kTriangleAndRepetition = 4;
  if (out.size() < kTriangleAndRepetition) out.clear();
  return out;
}

void shift(Places& corners, double longitude) {
  for (Vec2& p : corners) p.x += longitude;
}

/// Cuts a chain from any longitude up to half a turn at each 180th meridian, and moves the pieces there.
std::vector<Places> chain_in_turn(const Places& corners, double half_turn) {
  const double turn = 2.0 * half_turn;
  const double low = std::ranges::min_element(corners, {}, &Vec2::x)->x;
  std::vector<Places> out{corners};
  for (double meridian = -half_turn; low < meridian; meridian -= turn) {
    std::vector<Places> pieces;
    for (const Places& part : out) std::ranges::move(cut_chain(part, meridian), std::back_inserter(pieces));
    out = std::move(pieces);
  }
  for (Places& part : out) {
    const auto [least, most] = std::ranges::minmax(part, {}, &Vec2::x);
    shift(part, -turn * std::round(0.5 * (least.x + most.x) / turn));
  }
  return out;
}

}  // namespace

std::vector<std::vector<Vec2>> parts_on_earth(const StraightShape& shape, const MapConversion& conversion) {
  Places corners = shape.corners;
  conversion.from_plane(corners);
  if (corners.empty() || std::ranges::any_of(corners, [](Vec2 p) { return !is_finite(p); })) return {};
  const double half_turn = conversion.half_turn();
  if (half_turn == 0.0) return {std::move(corners)};
  const double turn = 2.0 * half_turn;
  // Degrees that were kept as coordinates may lie beyond the poles; such a shape is not on the Earth.
  if (std::ranges::any_of(corners, [&](Vec2 p) { return std::abs(p.y) > 0.5 * half_turn; })) return {};
  if (conversion.turns_longitudes()) {
    // Longitudes jump by a turn where the shape crosses the 180th meridian.
    for (std::size_t i = 1; i < corners.size(); ++i)
      corners[i].x = corners[i - 1].x + std::remainder(corners[i].x - corners[i - 1].x, turn);
    const bool is_closed = shape.corners.front() == shape.corners.back();
    const bool is_around = is_closed && std::abs(corners.back().x - corners.front().x) > half_turn;
    if (is_around && shape.kind == StraightKind::polygon) return {};
    if (is_closed && !is_around) corners.back() = corners.front();
  }
  constexpr double kMostTurns = 8.0;  // of a chain; a spiral at a pole may have any number
  const auto [low, high] = std::ranges::minmax(corners, {}, &Vec2::x);
  if (high.x - low.x > turn * (shape.kind == StraightKind::polygon ? 1.0 : kMostTurns)) return {};
  const double turns = std::ceil((high.x - half_turn) / turn);
  if (turns != 0.0) shift(corners, -turn * turns);
  if (low.x - turn * turns >= -half_turn) return {std::move(corners)};
  // The shape now reaches from west of -180 degrees to at most 180.
  std::vector<Places> out;
  if (shape.kind == StraightKind::polygon)
    out = {cut_ring(corners, -half_turn, 1.0), cut_ring(corners, -half_turn, -1.0)};
  else
    out = chain_in_turn(corners, half_turn);
  std::erase_if(out, [](const Places& part) { return part.size() < 2; });
  for (Places& part : out)
    if (std::ranges::any_of(part, [&](Vec2 p) { return p.x < -half_turn; })) shift(part, turn);
  return out;
}

GeoParts geo_parts_of(const StraightShape& shape, const MapConversion* conversion) {
  if (conversion == nullptr) return {{shape.corners, shape.holes}};
  GeoParts out;
  for (Places& part : parts_on_earth(shape, *conversion)) out.push_back({std::move(part)});
  // Parts are cut along meridians, so longitudes tell which one is around a hole.
  const auto is_around = [](const Places& part, const Places& hole) {
    const auto [low, high] = std::ranges::minmax(part, {}, &Vec2::x);
    const auto [first, last] = std::ranges::minmax(hole, {}, &Vec2::x);
    return low.x <= first.x && last.x <= high.x;
  };
  for (const Places& hole : shape.holes) {
    for (Places& part : parts_on_earth({.kind = shape.kind, .of = shape.of, .corners = hole}, *conversion)) {
      const auto around = std::ranges::find_if(out, [&](const GeoPart& one) { return is_around(one.corners, part); });
      if (around != out.end()) around->holes.push_back(std::move(part));
    }
  }
  return out;
}

}  // namespace mes
