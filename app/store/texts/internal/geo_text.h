// SPDX-License-Identifier: GPL-3.0-or-later
// Geometries in GeoJSON and well-known text.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "app/store/texts/internal/straight_shapes.h"
#include "core/base/error.h"
#include "core/document/map_plane.h"
#include "core/io/systems/map_conversion.h"

namespace mes {

/// A part of a shape as it is written; in the plane a shape is one part.
struct GeoPart {
  std::vector<Vec2> corners;
  std::vector<std::vector<Vec2>> holes{};
};
using GeoParts = std::vector<GeoPart>;

/// Begins and ends a collection of features. Readers that follow RFC 7946 ignore the name of the system of degrees;
/// without it this program reads features as lying in the plane. The second function is for positions on the map as
/// `target` says, or in the plane without a map.
std::string begin_of_features(bool are_in_degrees);
std::string begin_of_features(const std::optional<MapPlane>& map, MapTarget target);
inline constexpr std::string_view kEndOfFeatures = "\n]}\n";

/// A measure as JSON, always with a decimal point or an exponent, since readers take the type of a column from its
/// values; `null` if it is not finite.
void append_measure(std::string& out, double value);
void append_geojson(std::string& out, StraightKind kind, const GeoParts& parts);
/// `srid`: as `srid_of` gives it.
void append_wkt(std::string& out, StraightKind kind, const GeoParts& parts, std::string_view srid);
/// "SRID=25832;" for positions in the system of the map; empty without a map, or if no number is known for its system.
std::string srid_of(const std::optional<MapPlane>& map);

/// Names of the drivers of GDAL.
inline constexpr const char* kGeoPackage = "GPKG";
inline constexpr const char* kFlatGeobuf = "FlatGeobuf";
/// The features of GeoJSON, with positions as `target` says, in a file by a driver, in the coordinate system of the map.
/// Error: as for `map_by_gdal` (core/io/maps/gdal.h). Whole numbers beyond 64 bits, which GDAL would clamp, become
/// strings.
Expected<std::string> map_file_of(std::string_view geojson, const char* driver, const std::optional<MapPlane>& map,
                                  MapTarget target);

}  // namespace mes
