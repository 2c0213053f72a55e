// SPDX-License-Identifier: GPL-3.0-or-later
// Writes the cells of samples as text for other programs.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/error.h"
#include "core/base/geometry/vec2.h"
#include "core/document/map_plane.h"

namespace mes {

struct TextCell {
  std::uint64_t sample = 0;  ///< number in the file, from 0
  Vec2 place{};              ///< of the sample
  std::string id{};          ///< JSON of the id of its feature; empty: none
  std::string properties{};  ///< JSON members of the feature
  std::vector<std::vector<Vec2>>
      rings;  ///< closed, the first point repeated; the cell is inside an odd number of them
};

/// Names of the columns of a cell.
struct CellColumns {
  std::string sample = "sample";
  std::string center = "center";
  std::string area = "area";
};

struct CellText {
  std::string text;
  std::uint64_t without_cell = 0;  ///< samples that lie on others, whose cells they share
  std::uint64_t off_earth = 0;     ///< cells that reach beyond a pole or around the Earth; left out
};

/// The formats that hold polygons: "geojson", "wkt", "gpkg" and "fgb".
std::span<const std::string_view> cell_formats();

/// `format` is one of them. Features have the columns after the properties of their cells: the number of the sample,
/// its position, and the area in units of the plane. Numbers are in shortest round-trip form. Error: as for
/// `MapConversion::of` (core/io/systems/map_conversion.h).
Expected<CellText> cell_text(std::span<const TextCell> cells, const std::optional<MapPlane>& map,
                             std::string_view format, const CellColumns& columns = {});

}  // namespace mes
