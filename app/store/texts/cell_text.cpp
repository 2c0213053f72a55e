// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/store/texts/cell_text.h"

#include <algorithm>
#include <array>
#include <utility>

#include "app/store/texts/internal/geo_text.h"
#include "app/store/texts/internal/line_areas.h"
#include "app/store/texts/internal/shapes_on_earth.h"
#include "app/store/texts/internal/straight_shapes.h"
#include "core/io/systems/map_conversion.h"
#include "core/io/text/text_numbers.h"

namespace mes {
namespace {

constexpr std::array<std::string_view, 4> kCellFormats{"geojson", "wkt", "gpkg", "fgb"};

double area_of(const LineArea& area) {
  double out = area_of(area.outer);
  for (const std::vector<Vec2>& hole : area.holes) out += area_of(hole);
  return out;
}

/// One ring is a whole area, even if some of its corners are one point but for rounding.
std::vector<LineArea> areas_of(const TextCell& cell) {
  if (cell.rings.size() != 1) return areas_of(cell.rings).areas;
  LineArea out{cell.rings.front(), {}};
  if (area_of(out.outer) < 0.0) std::ranges::reverse(out.outer);
  return {out};
}

/// Empty if some part of the cell is not on the Earth.
GeoParts geo_parts_of(const std::vector<LineArea>& areas, const MapConversion* conversion) {
  GeoParts out;
  for (const LineArea& area : areas) {
    const StraightShape shape{.kind = StraightKind::polygon, .corners = area.outer, .holes = area.holes};
    GeoParts converted = geo_parts_of(shape, conversion);
    if (converted.empty()) return {};
    for (GeoPart& part : converted) out.push_back(std::move(part));
  }
  return out;
}

void append_cell(std::string& out, const TextCell& cell, const CellColumns& columns, double area,
                 const GeoParts& parts, const std::optional<MapConversion>& conversion) {
  const Vec2 place = conversion ? conversion->from_plane(cell.place) : cell.place;
  out += R"({"type":"Feature",)";
  if (!cell.id.empty()) out += R"("id":)" + cell.id + ',';
  out += R"("properties":{)" + cell.properties;
  if (!cell.properties.empty()) out += ',';
  out += '"' + columns.sample + "\":" + std::to_string(cell.sample);
  out += ",\"" + columns.center + "\":[";
  append_number(out, place.x);
  out += ',';
  append_number(out, place.y);
  out += "],\"" + columns.area + "\":";
  append_measure(out, area);
  out += R"(},"geometry":)";
  append_geojson(out, StraightKind::polygon, parts);
  out += '}';
}

}  // namespace

std::span<const std::string_view> cell_formats() {
  return kCellFormats;
}

Expected<CellText> cell_text(std::span<const TextCell> cells, const std::optional<MapPlane>& map,
                             std::string_view format, const CellColumns& columns) {
  const bool is_json = format != "wkt";
  const bool is_by_gdal = format == "gpkg" || format == "fgb";
  const MapTarget target = is_json && !is_by_gdal ? MapTarget::wgs84 : MapTarget::own_system;
  std::optional<MapConversion> conversion;
  if (map && is_on_earth(*map)) {
    auto made = MapConversion::of(*map, target);
    if (!made) return std::unexpected(made.error());
    conversion = std::move(*made);
  }
  const MapConversion* const converted = conversion ? &*conversion : nullptr;
  const std::string srid = srid_of(map);
  CellText out;
  if (is_json) out.text = begin_of_features(map, target);
  bool is_first = true;
  for (const TextCell& cell : cells) {
    const std::vector<LineArea> areas = areas_of(cell);
    const GeoParts parts = geo_parts_of(areas, converted);
    if (parts.empty()) {
      ++out.off_earth;
    } else if (is_json) {
      out.text += is_first ? "\n" : ",\n";
      double area = 0.0;
      for (const LineArea& part : areas) area += area_of(part);
      append_cell(out.text, cell, columns, area, parts, conversion);
      is_first = false;
    } else {
      append_wkt(out.text, StraightKind::polygon, parts, srid);
    }
  }
  if (is_json) out.text += kEndOfFeatures;
  if (is_by_gdal) {
    auto file = map_file_of(out.text, format == "gpkg" ? kGeoPackage : kFlatGeobuf, map, target);
    if (!file) return std::unexpected(file.error());
    out.text = *std::move(file);
  }
  return out;
}

}  // namespace mes
