// SPDX-License-Identifier: GPL-3.0-or-later
// Unit of the plane of a document, and its relation to the Earth for data from a map. Plain data.
#pragma once

#include <array>
#include <cmath>
#include <cstdint>
#include <string>
#include <string_view>

#include "core/base/geometry/vec2.h"

namespace mes {

/// Treatment of longitude and latitude.
enum class MapDegrees : std::uint8_t {
  projected,  ///< projected to metres about the middle of the map
  kept,       ///< used as coordinates of the plane, in degrees
};

/// How coordinates of the plane arise from those of the coordinate system of the map.
enum class MapProjection : std::uint8_t {
  none,             ///< they are the same
  azimuthal,        ///< azimuthal equidistant about an origin, in metres
  equirectangular,  ///< about an origin, on a sphere, in kilometres; for maps wider than a hemisphere, and old files
};

/// Their names in files, in order.
inline constexpr std::array<std::string_view, 3> kMapProjections{"none", "azimuthal", "equirectangular"};

/// The unit of a drawing, or the coordinate system of a map and the plane in which the program computes with it.
/// `MapConversion` (core/io/systems/map_conversion.h) converts between the latter two.
struct MapPlane {
  MapProjection projection = MapProjection::none;
  /// Origin of the projection, in units of the system, or in degrees on WGS 84 if that is a plane itself. May exceed 180
  /// degrees.
  double longitude = 0.0;
  double latitude = 0.0;
  /// An authority and its code ("EPSG:25832"), or WKT in one line; empty: longitude and latitude on WGS 84.
  std::string system{};
  /// Unit of the system, as PROJ names it: "degree", "metre". Not set for a projection, which determines that of the
  /// plane. Without a system and a projection any other unit than "degree" is that of a drawing: "mm", "px".
  std::string unit = "degree";
  /// Width and height of the page of a drawing, whose lower left corner is the origin; zero: it has none.
  Vec2 page{};

  /// Whether it is the plane of a drawing, which lies nowhere on the Earth.
  bool is_of_drawing() const { return projection == MapProjection::none && system.empty() && unit != "degree"; }
  /// Symbol or name of the unit of lengths in the plane.
  std::string_view plane_unit() const {
    if (projection == MapProjection::azimuthal || unit == "metre") return "m";
    if (projection == MapProjection::equirectangular || unit == "kilometre") return "km";
    return unit == "degree" ? "degrees" : std::string_view(unit);
  }
  /// Lengths of a map in degrees are written in metres, also if the plane has kilometres: so many for one of the plane.
  double written_size() const { return projection == MapProjection::equirectangular ? 1000.0 : 1.0; }
  std::string_view written_unit() const {
    return projection == MapProjection::equirectangular ? std::string_view("m") : plane_unit();
  }
  friend bool operator==(const MapPlane&, const MapPlane&) = default;
};

/// Whether the origin can be that of this plane. In systems other than WGS 84 a right angle may have 100 units.
inline bool is_origin_of_map(double longitude, double latitude, const MapPlane& plane) {
  const double quarter = plane.system.empty() ? 90.0 : 100.0;
  return std::abs(longitude) <= 4.0 * quarter && std::abs(latitude) <= quarter;
}

}  // namespace mes
