// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/io/systems/map_conversion.h"

#include <fmt/core.h>
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <mutex>
#include <numbers>
#include <optional>
#include <string>
#include <utility>
#include <vector>

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

/// The way from a system to longitude and latitude on WGS 84. PROJ takes up to 100 ms to find one, so those that are no
/// longer in use are kept for the next who asks: a town has thousands of maps of one house.
class WayToWgs84 {
 public:
  static Expected<WayToWgs84> of(const ProjLibrary& proj, const std::string& system, const std::string& title) {
    if (auto kept = taken(system)) return *std::move(kept);
    WayToWgs84 out;
    out.system_ = system;
    out.context_ = new_context(proj);
    const auto owned = [&](PJ* object) { return ProjObject(object, ProjDeleter{&proj}); };
    const ProjObject raw =
        owned(proj.create_crs_to_crs(out.context_.get(), system.c_str(), kLongitudeAndLatitude, nullptr));
    if (raw) out.object_ = owned(proj.normalize_for_visualization(out.context_.get(), raw.get()));
    if (!out.object_) return no_conversion(title);
    return out;
  }
  WayToWgs84() = default;
  WayToWgs84(WayToWgs84&&) noexcept = default;
  WayToWgs84& operator=(WayToWgs84&&) noexcept = default;
  ~WayToWgs84() {
    if (!object_) return;
    const std::scoped_lock lock(mutex());
    constexpr std::size_t kMostKept = 32;
    if (kept().size() < kMostKept) kept().push_back(std::move(*this));
  }

  PJ* get() const { return object_.get(); }
  explicit operator bool() const { return object_ != nullptr; }

 private:
  static std::mutex& mutex() {
    static std::mutex one;
    return one;
  }
  /// Not destroyed: at the end of the process the library may be gone before.
  static std::vector<WayToWgs84>& kept() {
    static auto* const one = new std::vector<WayToWgs84>;
    return *one;
  }
  static std::optional<WayToWgs84> taken(const std::string& system) {
    const std::scoped_lock lock(mutex());
    const auto at = std::ranges::find(kept(), system, &WayToWgs84::system_);
    if (at == kept().end()) return std::nullopt;
    std::swap(*at, kept().back());
    std::optional<WayToWgs84> out = std::move(kept().back());
    kept().pop_back();
    return out;
  }

  std::string system_;
  ProjContext context_{};
  ProjObject object_{};
};

struct MapConversion::Impl {
  MapPlane plane{};
  CoordinateSystem system{};
  MapTarget target = MapTarget::own_system;
  const ProjLibrary* proj = nullptr;
  ProjContext context{};
  ProjObject azimuthal{};  // from radians to metres; null for the other projections
  WayToWgs84 to_wgs84{};   // empty if that is not needed
  // Direction of `to_wgs84` that leads to the target: the inverse one from WGS 84 to a system with a plane.
  PJ_DIRECTION direction = PJ_FWD;

  /// Kilometres in a unit of longitude and of latitude, for the equirectangular projection.
  Vec2 kilometres() const {
    // Mean radius of the Earth by the International Union of Geodesy and Geophysics, in kilometres.
    constexpr double kEarthRadius = 6371.0088;
    const double north = kEarthRadius * system.unit_size;
    return {north * std::cos(plane.latitude * system.unit_size), north};
  }

  /// The system whose longitudes and latitudes are projected.
  const CoordinateSystem& projected() const {
    static const CoordinateSystem wgs84;
    return system.is_geographic ? system : wgs84;
  }

  Vec2 projected_of(Vec2 p) const {
    if (plane.projection == MapProjection::none) return p;
    if (plane.projection == MapProjection::equirectangular)
      return Vec2{plane.longitude, plane.latitude} + Vec2{p.x / kilometres().x, p.y / kilometres().y};
    return (1.0 / projected().unit_size) * transformed(*proj, azimuthal.get(), PJ_INV, p);
  }

  Vec2 plane_of(Vec2 p) const {
    if (plane.projection == MapProjection::none) return p;
    if (plane.projection == MapProjection::azimuthal)
      return transformed(*proj, azimuthal.get(), PJ_FWD, projected().unit_size * p);
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
  const bool is_wgs84_projected = is_azimuthal && !impl->system.is_geographic;
  const bool changes_system =
      is_wgs84_projected ? target == MapTarget::own_system : target == MapTarget::wgs84 && !plane.system.empty();
  if (is_wgs84_projected) impl->direction = PJ_INV;
  if (!is_azimuthal && !changes_system) return MapConversion(std::move(impl));
  const auto proj = proj_library();
  if (!proj) return std::unexpected(proj.error());
  impl->proj = *proj;
  if (is_azimuthal) {
    impl->context = new_context(**proj);
    const CoordinateSystem& projected = impl->projected();
    const double degrees = projected.unit_size * 180.0 / std::numbers::pi;
    const std::string text = fmt::format("+proj=aeqd +lon_0={} +lat_0={} +a={} +b={}", degrees * plane.longitude,
                                         degrees * plane.latitude, projected.major_axis, projected.minor_axis);
    impl->azimuthal = ProjObject((*proj)->create(impl->context.get(), text.c_str()), ProjDeleter{*proj});
    if (!impl->azimuthal) return no_conversion(impl->system.title());
  }
  if (changes_system) {
    auto to_wgs84 = WayToWgs84::of(**proj, plane.system, impl->system.title());
    if (!to_wgs84) return std::unexpected(to_wgs84.error());
    impl->to_wgs84 = *std::move(to_wgs84);
  }
  return MapConversion(std::move(impl));
}

Vec2 MapConversion::from_plane(Vec2 position) const {
  const Vec2 out = impl_->projected_of(position);
  return impl_->to_wgs84 ? transformed(*impl_->proj, impl_->to_wgs84.get(), impl_->direction, out) : out;
}

Vec2 MapConversion::to_plane(Vec2 position) const {
  const PJ_DIRECTION back = impl_->direction == PJ_FWD ? PJ_INV : PJ_FWD;
  if (impl_->to_wgs84) position = transformed(*impl_->proj, impl_->to_wgs84.get(), back, position);
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
