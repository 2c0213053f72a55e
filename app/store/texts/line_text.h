// SPDX-License-Identifier: GPL-3.0-or-later
// Writes lines as text for other programs.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/base/error.h"
#include "core/base/geometry/vec2.h"
#include "core/document/map_plane.h"

namespace mes {

/// A number that describes a line, as a property of a feature.
struct TextNumber {
  std::string name;
  double value = 0.0;
  bool is_count = false;  ///< otherwise a measure, which has a decimal point even if it is whole
};

struct TextLine {
  std::vector<Vec2> points;  ///< two or more; a closed line repeats the first at its end
  bool is_closed = false;
  std::vector<double> radii{};  ///< of the largest disks about the points, in units of the plane; empty: unknown
  std::vector<TextNumber> numbers{};
  std::string id{};               ///< JSON of the id of a feature; empty: none
  std::string properties{};       ///< JSON members of a feature, before the numbers
  std::optional<MapPlane> map{};  ///< nothing: the line is in no map
};

struct LineText {
  std::string text;
  std::uint64_t off_earth = 0;  ///< lines that reach beyond a pole or around the Earth; left out
};

/// A format. All formats write numbers in shortest round-trip form; equal lines give equal bytes.
struct LineTextFormat {
  std::string_view name;        ///< its name on the command line; without a hyphen also the extension of its files
  std::string_view help;        ///< one line
  bool is_of_features = false;  ///< holds ids and properties
  /// Error: as for `MapConversion::of` (core/io/systems/map_conversion.h).
  Expected<LineText> (*write)(std::span<const TextLine> lines) = nullptr;
};

/// Lines of a map are in longitude and latitude on WGS 84 in GeoJSON, in the plane in SVG and dxf-3d, and in the
/// coordinate system of the map in all other formats. GeoJSON and WKT are cut at the 180th meridian. CSV has a row for
/// each point. DXF has polylines of release 12, and dxf-3d polylines in space, whose heights are the radii; the header
/// names the unit. SVG has y downwards, and the page and unit of the drawing that the lines are of.
std::span<const LineTextFormat> line_text_formats();
/// The format of this name, or null.
const LineTextFormat* find_line_text_format(std::string_view name);

}  // namespace mes
