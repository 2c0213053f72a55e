// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/io/systems/chosen_plane.h"

#include <fmt/core.h>
#include <algorithm>
#include <cmath>
#include <optional>
#include <span>
#include <utility>

#include "core/base/geometry/box2.h"
#include "core/io/systems/map_conversion.h"

namespace mes {
namespace {

Box2 box_around(std::span<const Vec2> positions) {
  Box2 box;
  for (const Vec2 p : positions) box.add(p);
  return box;
}

/// Adds a full turn to longitudes west of 0, so that longitudes increase across the 180th meridian.
Vec2 eastern(Vec2 p, double half_turn) {
  return p.x < 0.0 ? Vec2{p.x + 2.0 * half_turn, p.y} : p;
}

double eastern_width(std::span<const Vec2> positions, double half_turn) {
  Box2 box;
  for (const Vec2 p : positions) box.add(eastern(p, half_turn));
  return box.width();
}

// From a pole to the equator in metres, on an ellipsoid of the Earth.
constexpr double kQuarterOfEarth = 10.003e6;

struct ProjectedPlane {
  MapPlane plane{};
  double farthest = 0.0;  ///< distance of a position from the origin, in metres
};

/// Projects about the middle of the map, or about the pole that it surrounds.
Expected<ProjectedPlane> projected_plane(std::vector<Vec2>& positions, const CoordinateSystem& system,
                                         SidesOnEarth sides) {
  const double half_turn = system.half_turn();
  Box2 box = box_around(positions);
  const double turned = sides.are_long ? box.width() : eastern_width(positions, half_turn);
  // A map on one hemisphere that is wider than half a turn, wherever it is cut, surrounds a pole.
  const bool is_around = std::min(box.width(), turned) > half_turn;
  const bool is_polar = is_around && !sides.are_long && (box.low.y >= 0.0 || box.high.y <= 0.0);
  if (!is_polar && turned < box.width() && !(is_around && sides.cross_zero)) {
    for (Vec2& p : positions) p = eastern(p, half_turn);
    box = box_around(positions);
  }
  MapPlane plane{.projection = MapProjection::azimuthal, .system = system.id};
  const Vec2 middle{0.5 * (box.low.x + box.high.x), 0.5 * (box.low.y + box.high.y)};
  plane.longitude = is_polar ? 0.0 : middle.x;
  plane.latitude = is_polar ? std::copysign(0.5 * half_turn, middle.y) : middle.y;
  const auto conversion = MapConversion::of(plane, MapTarget::own_system);
  if (!conversion) return std::unexpected(conversion.error());
  double farthest = 0.0;
  for (const Vec2 p : positions) farthest = std::max(farthest, length(conversion->to_plane(p)));
  if ((is_around && !is_polar) || farthest > kQuarterOfEarth) {
    plane.projection = MapProjection::equirectangular;
    plane.longitude = middle.x;
    plane.latitude = middle.y;
  }
  return ProjectedPlane{std::move(plane), farthest};
}

/// Projects positions of another plane about the middle of the map; nothing if it does not fit on a hemisphere.
Expected<std::optional<ProjectedPlane>> better_plane(std::span<const Vec2> positions,
                                                     const CoordinateSystem& system) {
  const auto to_wgs84 = MapConversion::of({.system = system.id, .unit = system.unit}, MapTarget::wgs84);
  if (!to_wgs84) return std::unexpected(to_wgs84.error());
  const Box2 box = box_around(positions);
  const Vec2 middle = to_wgs84->from_plane(0.5 * box.low + 0.5 * box.high);
  ProjectedPlane out{
      .plane = {
          .projection = MapProjection::azimuthal, .longitude = middle.x, .latitude = middle.y, .system = system.id}};
  if (!is_finite(middle) || !is_origin_of_map(middle.x, middle.y, MapPlane{})) return std::nullopt;
  const auto conversion = MapConversion::of(out.plane, MapTarget::own_system);
  if (!conversion) return std::unexpected(conversion.error());
  for (const Vec2 p : positions) {
    const double from_middle = length(conversion->to_plane(p));
    if (!(from_middle <= kQuarterOfEarth)) return std::nullopt;
    out.farthest = std::max(out.farthest, from_middle);
  }
  return out;
}

std::string in_degrees(double value, char positive, char negative) {
  return value == 0.0 ? "0" : fmt::format("{:.4g} {}", std::abs(value), value < 0.0 ? negative : positive);
}

std::string percentage(double error) {
  constexpr double kPercent = 100.0;
  constexpr double kLeast = 1e-4;
  const double percent = kPercent * error;
  if (percent < kLeast) return "0.0001 %";
  constexpr double kWithoutFraction = 10.0;
  return percent < kWithoutFraction ? fmt::format("{:.2g} %", percent) : fmt::format("{:.0f} %", percent);
}

/// Lengths with such an error are no lengths on the Earth, as in web maps far from the equator.
constexpr double kFar = 0.05;

std::string remark_of(const MapPlane& plane, const CoordinateSystem& system, double error) {
  const std::string of = system.id.empty() ? "" : " of " + system.title();
  if (plane.projection == MapProjection::none && system.is_geographic)
    return fmt::format("degrees{} are kept as coordinates of the plane", of);
  if (plane.projection == MapProjection::none)
    return fmt::format("coordinates are those of {}, in {}; {} {}", system.title(), plane.plane_unit(),
                       error < kFar ? "lengths are right to" : "lengths differ from those on the Earth by up to",
                       percentage(error));
  const double half_turn = system.is_geographic ? system.half_turn() : 180.0;
  const double size = 180.0 / half_turn;
  const double east = size * std::remainder(plane.longitude, 2.0 * half_turn);
  const std::string about = in_degrees(east, 'E', 'W') + ", " + in_degrees(size * plane.latitude, 'N', 'S');
  if (plane.projection == MapProjection::equirectangular)
    return fmt::format(
        "degrees{} are projected to kilometres about {}: equirectangular, since the map is wider than a "
        "hemisphere; lengths are right only at that latitude and along meridians",
        of, about);
  return fmt::format("{}{} are projected to metres about {}: azimuthal equidistant, lengths are right to {}",
                     system.is_geographic ? "degrees" : "coordinates", of, about, percentage(error));
}

}  // namespace

Expected<ChosenPlane> choose_plane(std::vector<Vec2>& positions, const CoordinateSystem& system, MapDegrees degrees,
                                   SidesOnEarth sides) {
  ChosenPlane out{.plane = {.system = system.id, .unit = system.unit}};
  std::vector<Vec2> extremes;
  if (system.is_geographic && degrees == MapDegrees::projected && !positions.empty()) {
    auto projected = projected_plane(positions, system, sides);
    if (!projected) return std::unexpected(projected.error());
    out.plane = std::move(projected->plane);
    extremes = {{projected->farthest, 0.0}};
  } else if (!positions.empty()) {
    // The error of a national grid grows from its middle to its edge.
    const Box2 box = box_around(positions);
    extremes = {box.low, box.high, {box.low.x, box.high.y}, {box.high.x, box.low.y}, 0.5 * (box.low + box.high)};
  }
  auto error = largest_scale_error(out.plane, extremes);
  if (!error) return std::unexpected(error.error());
  out.is_choice = system.is_geographic;
  if (!system.is_geographic && *error >= kFar) {
    auto better = better_plane(positions, system);
    if (!better) return std::unexpected(better.error());
    out.is_choice = better->has_value();
    if (*better && degrees == MapDegrees::projected) {
      out.plane = std::move((*better)->plane);
      error = largest_scale_error(out.plane, std::vector<Vec2>{{(*better)->farthest, 0.0}});
      if (!error) return std::unexpected(error.error());
    }
  }
  out.remark = remark_of(out.plane, system, *error);
  if (!system.is_geographic && !extremes.empty()) {
    const auto conversion = MapConversion::of({.system = system.id, .unit = system.unit}, MapTarget::wgs84);
    if (!conversion) return std::unexpected(conversion.error());
    const Vec2 middle = conversion->from_plane(extremes.back());
    if (!system.is_used_near(middle.x, middle.y))
      out.remark += fmt::format("; they lie about {}, {}, where that system is not used",
                                in_degrees(middle.x, 'E', 'W'), in_degrees(middle.y, 'N', 'S'));
  }
  return out;
}

}  // namespace mes
