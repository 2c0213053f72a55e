// SPDX-License-Identifier: GPL-3.0-or-later
// Relation of the plane of a document to the Earth, for data from a map in degrees. Plain data.
#pragma once

#include <cmath>
#include <cstdint>
#include <numbers>

#include "core/base/vec2.h"

namespace mes {

/// Treatment of longitude and latitude.
enum class MapDegrees : std::uint8_t {
  projected,  ///< projected to kilometres about the middle of the map
  kept,       ///< used as coordinates of the plane, in degrees
};

/// Conversion of degrees to coordinates of the plane: equirectangular about an origin, true to scale there and along
/// meridians; or the identity.
///
/// Guarantees: converting to the plane and back has an error below 1e-12 degrees for positions on the Earth.
struct MapPlane {
  MapDegrees degrees = MapDegrees::projected;
  double longitude = 0.0;  ///< origin of the plane, in degrees, may exceed 180; ignored if degrees are kept
  double latitude = 0.0;   ///< between -90 and 90

  /// Kilometres in a degree of longitude and of latitude.
  Vec2 scale() const {
    // Mean radius of the Earth by the International Union of Geodesy and Geophysics, in kilometres.
    constexpr double kEarthRadius = 6371.0088;
    constexpr double kRadian = std::numbers::pi / 180.0;
    if (degrees == MapDegrees::kept) return {1.0, 1.0};
    const double north = kEarthRadius * kRadian;
    return {north * std::cos(latitude * kRadian), north};
  }
  Vec2 origin() const { return degrees == MapDegrees::kept ? Vec2{} : Vec2{longitude, latitude}; }
  Vec2 plane_of(Vec2 place) const {
    const Vec2 from = place - origin();
    return {scale().x * from.x, scale().y * from.y};
  }
  /// Longitude and latitude of a point of the plane; not on the Earth if they exceed 180 or 90 degrees.
  Vec2 degrees_of(Vec2 place) const { return origin() + Vec2{place.x / scale().x, place.y / scale().y}; }
  /// Converts a point from the plane of another map, the shorter way around the Earth.
  Vec2 plane_of(const MapPlane& other, Vec2 place) const {
    Vec2 there = other.degrees_of(place);
    if (degrees == MapDegrees::projected) there.x = longitude + std::remainder(there.x - longitude, 360.0);
    return plane_of(there);
  }
  friend bool operator==(const MapPlane&, const MapPlane&) = default;
};

}  // namespace mes
