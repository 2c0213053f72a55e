// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/store/internal/shapes_on_earth.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace mes {
namespace {

constexpr double kHalfTurn = 180.0;
constexpr double kTurn = 360.0;
constexpr double kPole = 90.0;

using Corners = std::vector<Vec2>;

Vec2 crossing(Vec2 from, Vec2 to, double longitude) {
  const double t = (longitude - from.x) / (to.x - from.x);
  return {longitude, from.y + t * (to.y - from.y)};
}

/// Adds a corner where a side crosses the meridian without ending on it.
template <class Use>
void for_each_with_crossings(const Corners& corners, double longitude, Use use) {
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const bool crosses = i != 0 && (corners[i - 1].x - longitude) * (corners[i].x - longitude) < 0.0;
    if (crosses) use(crossing(corners[i - 1], corners[i], longitude));
    use(corners[i]);
  }
}

/// Cuts the chain into pieces that each lie on one side.
std::vector<Corners> cut_chain(const Corners& corners, double longitude) {
  std::vector<Corners> out(1);
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
Corners cut_ring(const Corners& corners, double longitude, double sign) {
  Corners out;
  for_each_with_crossings(corners, longitude, [&](Vec2 p) {
    if (sign * (p.x - longitude) >= 0.0 && (out.empty() || out.back() != p)) out.push_back(p);
  });
  if (!out.empty() && out.front() != out.back()) out.push_back(out.front());
  constexpr std::size_t kTriangleAndRepetition = 4;
  if (out.size() < kTriangleAndRepetition) out.clear();
  return out;
}

void shift(Corners& corners, double longitude) {
  for (Vec2& p : corners) p.x += longitude;
}

}  // namespace

std::vector<std::vector<Vec2>> parts_on_earth(const StraightShape& shape, const MapPlane& map) {
  Corners corners;
  corners.reserve(shape.corners.size());
  for (const Vec2 p : shape.corners) corners.push_back(map.degrees_of(p));
  // Degrees that were kept as coordinates may lie beyond the poles; such a shape is not on the Earth.
  const auto is_beyond = [](Vec2 p) { return !(std::abs(p.y) <= kPole) || !std::isfinite(p.x); };
  if (corners.empty() || std::ranges::any_of(corners, is_beyond)) return {};
  const auto [low, high] = std::ranges::minmax(corners, {}, &Vec2::x);
  if (high.x - low.x > kTurn) return {};
  const double turns = std::ceil((high.x - kHalfTurn) / kTurn);
  if (turns != 0.0) shift(corners, -kTurn * turns);
  if (low.x - kTurn * turns >= -kHalfTurn) return {std::move(corners)};
  // The shape now reaches from west of -180 degrees to at most 180.
  std::vector<Corners> out;
  if (shape.kind == StraightKind::polygon)
    out = {cut_ring(corners, -kHalfTurn, 1.0), cut_ring(corners, -kHalfTurn, -1.0)};
  else
    out = cut_chain(corners, -kHalfTurn);
  std::erase_if(out, [](const Corners& part) { return part.size() < 2; });
  for (Corners& part : out)
    if (std::ranges::any_of(part, [](Vec2 p) { return p.x < -kHalfTurn; })) shift(part, kTurn);
  return out;
}

}  // namespace mes
