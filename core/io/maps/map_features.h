// SPDX-License-Identifier: GPL-3.0-or-later
// The features of a map, each as a map of its own in the same format, with its attributes.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/error.h"

namespace mes {

struct MapFeature {
  std::string text{};               ///< file with this feature alone, in the coordinate system of the map
  std::string id{};                 ///< JSON; empty: none
  std::string properties{};         ///< JSON members without the braces
  std::vector<std::string> keys{};  ///< names of the properties
};

/// The placemarks of a KML. Name, description, address, telephone number and times are properties, and so is all of
/// `ExtendedData`; numbers and flags of a schema are those of JSON, other values are text. A name that is taken gets a
/// number. Text that is not UTF-8 is read as Latin-1. Error: `bad_input` with line and column for text that is not XML.
Expected<std::vector<MapFeature>> kml_features(std::string_view bytes, const std::string& name);

/// The geometries of WKT, which have neither ids nor properties. Never fails: a feature ends where its parentheses are
/// closed. Other text is a feature up to the end of its line, which the reader of WKT refuses.
std::vector<MapFeature> wkt_features(std::string_view bytes);

/// The records of a table with a column of geometries. The other columns are properties; columns without a name are
/// called `field_1`, `field_2` and so on. A column of numbers has numbers, all others have texts; empty fields are null. The
/// result is empty if the bytes are not such a table. Never fails: faults are left to the reader of the geometry.
std::vector<MapFeature> geometry_table_features(std::string_view bytes);

/// Whether a text begins as WKT does: with the name of a geometry and what can follow it, or a code.
bool begins_wkt(std::string_view text);
/// The code at the beginning of WKT, such as `SRID=25832;`, or nothing.
std::string_view srid_of_wkt(std::string_view text);
/// Whether a text is a geometry of WKB in hexadecimal digits; only the beginning decides which.
bool is_hexadecimal_wkb(std::string_view text);

/// Checks what GDAL does not say, or says in words of its own, of the shapefile at `path`. Returns a remark on its
/// coordinate system, which may be empty. `has_system`: the system is chosen, so that its `.prj` does not count. Error:
/// `bad_input`, if it ends before the end that its header tells, has no `.shx` beside it, or a `.prj` that is no
/// coordinate system.
Expected<std::string> check_shapefile(std::string_view bytes, const std::string& name,
                                      const std::filesystem::path& path, bool has_system);

}  // namespace mes
