// SPDX-License-Identifier: GPL-3.0-or-later
// Coordinate systems of maps, as PROJ knows them: by authority and code, as WKT, PROJJSON or a PROJ string.
#pragma once

#include <cmath>
#include <numbers>
#include <string>
#include <string_view>

#include "core/base/error.h"

namespace mes {

/// A horizontal coordinate system. Positions have x to the east or as longitude, and y to the north or as latitude,
/// whatever order of axes the authority defines.
struct CoordinateSystem {
  std::string id{};  ///< as `MapPlane::system`
  std::string name = "WGS 84";
  std::string unit = "degree";  ///< as `MapPlane::unit`
  bool is_geographic = true;    ///< longitude and latitude
  /// Size of a unit: in radians if the system is geographic, else in metres.
  double unit_size = std::numbers::pi / 180.0;
  double major_axis = 6378137.0;  ///< of the ellipsoid, in metres
  double minor_axis = 6356752.314245179;
  /// Where its authority means it to be used: longitudes from west to east and latitudes, in degrees; the Earth if it does
  /// not say.
  double west = -180.0, south = -90.0, east = 180.0, north = 90.0;

  /// Whether the place is near that area: within five degrees of latitude, ten of longitude.
  bool is_used_near(double longitude, double latitude) const;
  /// Half a turn of longitude: 180 for degrees. 0 if the system is not geographic.
  double half_turn() const { return is_geographic ? std::round(std::numbers::pi / unit_size) : 0.0; }
  /// "ETRS89 / UTM zone 32N (EPSG:25832)".
  std::string title() const;
  friend bool operator==(const CoordinateSystem&, const CoordinateSystem&) = default;
};

/// Finds a system by any text that PROJ understands; a name has to be whole. A system that an authority defines gets
/// its code, however it was described. The horizontal part is taken of a system with heights. The default members
/// describe longitude and latitude on WGS 84, for which neither PROJ nor its database is needed. Error: `bad_input`, if
/// PROJ does not know it, if it is not a system on the Earth's surface, or if the text has more than 65,536 bytes.
///
/// Cost: 50 ms for the first system, less for later ones; a hundred systems that were found are kept. Threads: any.
///
/// Smallest use:
///     const auto system = find_coordinate_system("EPSG:25832");
Expected<CoordinateSystem> find_coordinate_system(std::string_view text);

}  // namespace mes
