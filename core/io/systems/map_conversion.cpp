// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/io/systems/map_conversion.h"

#include <fmt/core.h>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "core/io/systems/proj_library.h"

namespace mes {
namespace {

constexpr const char* kLongitudeAndLatitude = "OGC:CRS84";

Vec2 transformed(const ProjLibrary& proj, PJ* by, PJ_DIRECTION direction, Vec2 p) {
  PJ_COORD at{};
  at.xy = {p.x, p.y};
  at = proj.trans(by, direction, at);
  return {at.xy.x, at.xy.y};
}

std::unexpected<Error> no_conversion(const std::string& system) {
  return std::unexpected(
      Error{ErrorCode::bad_input, fmt::format("PROJ cannot convert {} to longitude and latitude", system)});
}

/// The smallest and the largest number of metres on the Earth in a metre of the plane.
std::pair<double, double> scales_at(const MapConversion& to_wgs84, Vec2 p, double unit) {
  constexpr double kRadians = std::numbers::pi / 180.0;
  constexpr double kMajorAxis = 6378137.0;
  constexpr double kSquaredEccentricity = 0.00669437999014;
  constexpr double kStep = 10.0;  // units, to each side
  const double sine = std::sin(to_wgs84.from_plane(p).y * kRadians);
  const double curved = std::sqrt(1.0 - kSquaredEccentricity * sine * sine);
  const double north = kRadians * kMajorAxis * (1.0 - kSquaredEccentricity) / (curved * curved * curved);
  const double east = kRadians * kMajorAxis / curved * std::sqrt(1.0 - sine * sine);
  const auto moved = [&](Vec2 step) {
    const Vec2 degrees = to_wgs84.from_plane(p + step) - to_wgs84.from_plane(p - step);
    const double size = 2.0 * kStep * unit;
    return Vec2{east * std::remainder(degrees.x, 360.0) / size, north * degrees.y / size};
  };
  const Vec2 u = moved({kStep, 0.0});
  const Vec2 v = moved({0.0, kStep});
  // The singular values of the matrix (u v).
  const double sum = std::hypot(u.x + v.y, u.y - v.x);
  const double difference = std::hypot(u.x - v.y, u.y + v.x);
  return {0.5 * std::abs(sum - difference), 0.5 * (sum + difference)};
}

}  // namespace

struct MapConversion::Impl {
  MapPlane plane{};
  CoordinateSystem system{};
  MapTarget target = MapTarget::own_system;
  const ProjLibrary* proj = nullptr;
  ProjContext context{};
  ProjObject azimuthal{};  // from radians to metres; null for the other projections
  ProjObject to_wgs84{};   // from the system; null if that is not needed

  /// Kilometres in a unit of longitude and of latitude, for the equirectangular projection.
  Vec2 kilometres() const {
    // Mean radius of the Earth by the International Union of Geodesy and Geophysics, in kilometres.
    constexpr double kEarthRadius = 6371.0088;
    const double north = kEarthRadius * system.unit_size;
    return {north * std::cos(plane.latitude * system.unit_size), north};
  }

  Vec2 system_of(Vec2 p) const {
    if (plane.projection == MapProjection::none) return p;
    if (plane.projection == MapProjection::equirectangular)
      return Vec2{plane.longitude, plane.latitude} + Vec2{p.x / kilometres().x, p.y / kilometres().y};
    return (1.0 / system.unit_size) * transformed(*proj, azimuthal.get(), PJ_INV, p);
  }

  Vec2 plane_of(Vec2 p) const {
    if (plane.projection == MapProjection::none) return p;
    if (plane.projection == MapProjection::azimuthal)
      return transformed(*proj, azimuthal.get(), PJ_FWD, system.unit_size * p);
    const Vec2 from = p - Vec2{plane.longitude, plane.latitude};
    return {kilometres().x * from.x, kilometres().y * from.y};
  }
};

MapConversion::MapConversion(std::unique_ptr<Impl> impl) : impl_(std::move(impl)) {}
MapConversion::MapConversion(MapConversion&&) noexcept = default;
MapConversion& MapConversion::operator=(MapConversion&&) noexcept = default;
MapConversion::~MapConversion() = default;

Expected<MapConversion> MapConversion::of(const MapPlane& plane, MapTarget target) {
  auto impl = std::make_unique<Impl>();
  impl->plane = plane;
  impl->target = target;
  auto system = find_coordinate_system(plane.system);
  if (!system) return std::unexpected(system.error());
  impl->system = *std::move(system);
  const bool is_azimuthal = plane.projection == MapProjection::azimuthal;
  const bool changes_system = target == MapTarget::wgs84 && !plane.system.empty();
  if (!is_azimuthal && !changes_system) return MapConversion(std::move(impl));
  const auto proj = proj_library();
  if (!proj) return std::unexpected(proj.error());
  impl->proj = *proj;
  impl->context = new_context(**proj);
  const auto owned = [&](PJ* object) { return ProjObject(object, ProjDeleter{*proj}); };
  if (is_azimuthal) {
    const double degrees = impl->system.unit_size * 180.0 / std::numbers::pi;
    const std::string text = fmt::format("+proj=aeqd +lon_0={} +lat_0={} +a={} +b={}", degrees * plane.longitude,
                                         degrees * plane.latitude, impl->system.major_axis, impl->system.minor_axis);
    impl->azimuthal = owned((*proj)->create(impl->context.get(), text.c_str()));
    if (!impl->azimuthal) return no_conversion(impl->system.title());
  }
  if (changes_system) {
    const ProjObject raw =
        owned((*proj)->create_crs_to_crs(impl->context.get(), plane.system.c_str(), kLongitudeAndLatitude, nullptr));
    if (raw) impl->to_wgs84 = owned((*proj)->normalize_for_visualization(impl->context.get(), raw.get()));
    if (!impl->to_wgs84) return no_conversion(impl->system.title());
  }
  return MapConversion(std::move(impl));
}

Vec2 MapConversion::from_plane(Vec2 position) const {
  const Vec2 out = impl_->system_of(position);
  return impl_->to_wgs84 ? transformed(*impl_->proj, impl_->to_wgs84.get(), PJ_FWD, out) : out;
}

Vec2 MapConversion::to_plane(Vec2 position) const {
  if (impl_->to_wgs84) position = transformed(*impl_->proj, impl_->to_wgs84.get(), PJ_INV, position);
  return impl_->plane_of(position);
}

void MapConversion::from_plane(std::span<Vec2> positions) const {
  for (Vec2& p : positions) p = from_plane(p);
}

void MapConversion::to_plane(std::span<Vec2> positions) const {
  for (Vec2& p : positions) p = to_plane(p);
}

double MapConversion::half_turn() const {
  return impl_->target == MapTarget::wgs84 ? 180.0 : impl_->system.half_turn();
}

bool MapConversion::turns_longitudes() const {
  return half_turn() > 0.0 && (impl_->to_wgs84 || impl_->azimuthal);
}

Expected<WrittenPlane> WrittenPlane::of(const std::optional<MapPlane>& plane) {
  WrittenPlane out;
  if (!plane || !is_on_earth(*plane)) return out;
  auto conversion = MapConversion::of(*plane, MapTarget::own_system);
  if (!conversion) return std::unexpected(conversion.error());
  out.conversion_ = *std::move(conversion);
  out.size_ = plane->written_size();
  return out;
}

Expected<double> largest_scale_error(const MapPlane& plane, std::span<const Vec2> positions) {
  double out = 0.0;
  if (plane.projection == MapProjection::azimuthal) {
    double farthest = 0.0;
    for (const Vec2 p : positions) farthest = std::max(farthest, length(p));
    // The smallest radius of curvature of the Earth in metres. Lengths across the direction of the origin are stretched
    // as much as a circle of this radius on a sphere.
    constexpr double kRadius = 6.335e6;
    const double angle = farthest / kRadius;
    return angle == 0.0 ? 0.0 : angle / std::sin(angle) - 1.0;
  }
  const auto system = find_coordinate_system(plane.system);
  if (!system) return std::unexpected(system.error());
  if (system->is_geographic) return 0.0;
  const auto conversion = MapConversion::of(plane, MapTarget::wgs84);
  if (!conversion) return std::unexpected(conversion.error());
  for (const Vec2 p : positions) {
    const auto [shrunk, stretched] = scales_at(*conversion, p, system->unit_size);
    if (std::isfinite(shrunk) && shrunk > 0.0)
      out = std::max({out, std::abs(1.0 / shrunk - 1.0), std::abs(1.0 / stretched - 1.0)});
  }
  return out;
}

}  // namespace mes
