// SPDX-License-Identifier: GPL-3.0-or-later
// Converts positions between the plane of a document and coordinate systems of the Earth, with PROJ.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <span>

#include "core/base/error.h"
#include "core/base/geometry/vec2.h"
#include "core/document/map_plane.h"
#include "core/io/systems/coordinate_system.h"

namespace mes {

/// False for the plane of a drawing.
inline bool is_on_earth(const MapPlane& plane) {
  return !plane.is_of_drawing();
}

enum class MapTarget : std::uint8_t {
  own_system,  ///< the coordinate system of the map
  wgs84,       ///< longitude and latitude on WGS 84, in degrees
};

/// Converts in place. A position without an image becomes infinite or NaN.
///
/// Guarantees: there and back is within 2 mm on the same hemisphere. A plane without a projection converts to its own
/// system without any change.
///
/// Cost: 50 ms for the first of a process, which loads PROJ; then 0.1 ms for WGS 84, and up to 100 ms for another
/// system, unless an earlier conversion of this system is over: what it found is kept. A microsecond a position. Threads:
/// one at a time, and each with a conversion of its own.
///
/// Smallest use:
///     std::vector<Vec2> places = outline;
///     if (const auto conversion = MapConversion::of(plane, MapTarget::wgs84)) conversion->from_plane(places);
class MapConversion {
 public:
  /// Error: `bad_input`, if PROJ or the system of the plane is not there.
  static Expected<MapConversion> of(const MapPlane& plane, MapTarget target);
  MapConversion(MapConversion&&) noexcept;
  MapConversion& operator=(MapConversion&&) noexcept;
  ~MapConversion();

  void from_plane(std::span<Vec2> positions) const;
  void to_plane(std::span<Vec2> positions) const;
  Vec2 from_plane(Vec2 position) const;
  Vec2 to_plane(Vec2 position) const;
  /// Half a turn of longitude in the target: 180 for degrees; 0 if its positions are no longitudes and latitudes.
  double half_turn() const;
  /// Whether longitudes jump by a turn at the 180th meridian of the target, as they come from another system or
  /// projection. Otherwise neighbours on the plane have near longitudes, which may exceed half a turn.
  bool turns_longitudes() const;

 private:
  struct Impl;
  explicit MapConversion(std::unique_ptr<Impl> impl);
  std::unique_ptr<Impl> impl_;
};

/// Positions and lengths of the plane of a document as they are written: in the coordinate system and the unit of its
/// map, unchanged for a drawing and without a map.
class WrittenPlane {
 public:
  /// Error: as for `MapConversion::of`.
  static Expected<WrittenPlane> of(const std::optional<MapPlane>& plane);
  Vec2 position(Vec2 p) const { return conversion_ ? conversion_->from_plane(p) : p; }
  double length(double x) const { return x * size_; }

 private:
  std::optional<MapConversion> conversion_;
  double size_ = 1.0;
};

/// The largest relative error of short lengths in the plane, at these positions of it: an upper bound for the azimuthal
/// projection, to a hundredth of it for another system. 0 for degrees. Error: as for `MapConversion::of`.
Expected<double> largest_scale_error(const MapPlane& plane, std::span<const Vec2> positions);

}  // namespace mes
