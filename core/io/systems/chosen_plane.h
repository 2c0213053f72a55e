// SPDX-License-Identifier: GPL-3.0-or-later
// Chooses the plane in which a map is computed.
#pragma once

#include <string>
#include <vector>

#include "core/base/error.h"
#include "core/base/geometry/vec2.h"
#include "core/document/map_plane.h"
#include "core/io/systems/coordinate_system.h"

namespace mes {

/// How lines and rings of a map lie around the Earth.
struct SidesOnEarth {
  bool are_long = false;    ///< one, such as a frame of the world, leads from the 180th meridian around to itself
  bool cross_zero = false;  ///< one crosses the meridian from which longitudes count
};

struct ChosenPlane {
  MapPlane plane{};
  std::string remark{};    ///< one line: projection and system, with the largest error of lengths
  bool is_choice = false;  ///< whether there is another plane that `MapDegrees` chooses
};

/// A system that is not geographic is its own plane, unless its lengths differ from those on the Earth by more than 5 %,
/// as in web maps: then positions are projected from longitude and latitude on WGS 84, if they are on one hemisphere.
/// Longitudes and latitudes, and such positions, are kept where that is wanted. Else they are projected to metres,
/// azimuthal equidistant about the middle of the map, or about a pole that the map surrounds;
/// if the map does not fit on a hemisphere, equirectangular in kilometres. A map across the 180th meridian is joined
/// there: positions west of it move a turn to the east, unless that would tear sides of a map of the world. Error: as for `MapConversion::of`.
///
/// Smallest use:
///     auto chosen = choose_plane(positions, *find_coordinate_system("EPSG:4258"), MapDegrees::projected);
Expected<ChosenPlane> choose_plane(std::vector<Vec2>& positions, const CoordinateSystem& system, MapDegrees degrees,
                                   SidesOnEarth sides = {});

}  // namespace mes
