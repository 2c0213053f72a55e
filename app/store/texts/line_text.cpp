// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/store/texts/line_text.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "app/store/texts/internal/dxf_text.h"
#include "app/store/texts/internal/geo_text.h"
#include "app/store/texts/internal/shapes_on_earth.h"
#include "core/base/geometry/box2.h"
#include "core/io/systems/map_conversion.h"
#include "core/io/text/text_numbers.h"

namespace mes {
namespace {

bool is_of_map(const TextLine& line) {
  return line.map && is_on_earth(*line.map);
}

/// Converts lines of maps. Most lines have the map of the line before them.
class LineConversions {
 public:
  explicit LineConversions(MapTarget target) : target_(target) {}

  /// Null for a line in no map.
  Expected<const MapConversion*> of(const TextLine& line) {
    if (!is_of_map(line)) return nullptr;
    if (!conversion_ || *line.map != plane_) {
      auto conversion = MapConversion::of(*line.map, target_);
      if (!conversion) return std::unexpected(conversion.error());
      conversion_ = *std::move(conversion);
      plane_ = *line.map;
    }
    return &*conversion_;
  }
  Expected<std::vector<Vec2>> points_of(const TextLine& line) {
    const auto conversion = of(line);
    if (!conversion) return std::unexpected(conversion.error());
    std::vector<Vec2> out = line.points;
    if (*conversion != nullptr) (*conversion)->from_plane(out);
    return out;
  }
  Expected<GeoParts> parts_of(const TextLine& line) {
    const auto conversion = of(line);
    if (!conversion) return std::unexpected(conversion.error());
    const StraightShape shape{.kind = StraightKind::chain, .of = PrimitiveKind::segment, .corners = line.points};
    return geo_parts_of(shape, *conversion);
  }

 private:
  MapTarget target_;
  MapPlane plane_{};
  std::optional<MapConversion> conversion_{};
};

Expected<LineText> features_of_lines(std::span<const TextLine> lines, MapTarget target) {
  LineConversions conversions(target);
  const auto of_map = std::ranges::find_if(lines, is_of_map);
  LineText out{begin_of_features(of_map == lines.end() ? std::nullopt : of_map->map, target)};
  bool is_first = true;
  for (const TextLine& line : lines) {
    const auto parts = conversions.parts_of(line);
    if (!parts) return std::unexpected(parts.error());
    if (parts->empty()) {
      ++out.off_earth;
      continue;
    }
    out.text += is_first ? "\n" : ",\n";
    is_first = false;
    out.text += R"({"type":"Feature",)";
    if (!line.id.empty()) out.text += R"("id":)" + line.id + ',';
    out.text += R"("properties":{)" + line.properties;
    bool is_next = !line.properties.empty();
    for (const TextNumber& number : line.numbers) {
      if (is_next) out.text += ',';
      is_next = true;
      out.text += '"' + number.name + "\":";
      if (number.is_count)
        append_number(out.text, number.value);
      else
        append_measure(out.text, number.value);
    }
    out.text += R"(},"geometry":)";
    append_geojson(out.text, StraightKind::chain, *parts);
    out.text += '}';
  }
  out.text += kEndOfFeatures;
  return out;
}

Expected<LineText> lines_as_geojson(std::span<const TextLine> lines) {
  return features_of_lines(lines, MapTarget::wgs84);
}

Expected<LineText> lines_as_wkt(std::span<const TextLine> lines) {
  LineConversions conversions(MapTarget::own_system);
  LineText out;
  for (const TextLine& line : lines) {
    const auto parts = conversions.parts_of(line);
    if (!parts) return std::unexpected(parts.error());
    if (parts->empty())
      ++out.off_earth;
    else
      append_wkt(out.text, StraightKind::chain, *parts, srid_of(line.map));
  }
  return out;
}

Expected<LineText> lines_as_csv(std::span<const TextLine> lines) {
  LineConversions conversions(MapTarget::own_system);
  LineText out{"line,x,y\n"};
  for (std::size_t i = 0; i < lines.size(); ++i) {
    const auto points = conversions.points_of(lines[i]);
    if (!points) return std::unexpected(points.error());
    for (const Vec2 p : *points) {
      out.text += std::to_string(i + 1);
      append_number(out.text += ',', p.x);
      append_number(out.text += ',', p.y);
      out.text += '\n';
    }
  }
  return out;
}

void append_pair(std::string& out, double x, double y) {
  append_number(out, x);
  append_number(out += ' ', y);
}

/// On the page of the drawing that the lines belong to, so that they lie on it; else on one around them.
Expected<LineText> lines_as_svg(std::span<const TextLine> lines) {
  const MapPlane plane = lines.empty() || !lines.front().map ? MapPlane{.unit = {}} : *lines.front().map;
  Box2 page{{0.0, -plane.page.y}, {plane.page.x, 0.0}};  // y down
  if (plane.page == Vec2{}) {
    page = {};
    for (const TextLine& line : lines)
      for (const Vec2 p : line.points) page.add(Vec2{p.x, -p.y});
    const double margin = 0.02 * std::max(page.width(), page.height());
    page = {page.low - Vec2{margin, margin}, page.high + Vec2{margin, margin}};
  }
  const double top = plane.page.y;  // of the page, from which its y counts
  const auto down = [top](double y) { return y == top ? 0.0 : top - y; };
  LineText out{R"(<svg xmlns="http://www.w3.org/2000/svg" )"};
  constexpr std::array<std::string_view, 6> kUnits{"px", "mm", "cm", "in", "pt", "pc"};
  if (std::ranges::find(kUnits, plane.unit) != kUnits.end()) {
    append_number(out.text += R"(width=")", page.width());
    append_number(out.text.append(plane.unit) += R"(" height=")", page.height());
    out.text.append(plane.unit) += R"(" )";
  }
  append_pair(out.text += R"(viewBox=")", page.low.x, page.low.y + top);
  append_pair(out.text += ' ', page.width(), page.height());
  const double size = std::max(page.width(), page.height());
  out.text += R"(" fill="none" stroke="black" stroke-linejoin="round" stroke-linecap="round" stroke-width=")";
  append_number(out.text, 0.002 * size);
  out.text += "\">\n";
  for (std::size_t i = 0; i < lines.size(); ++i) {
    const TextLine& line = lines[i];
    out.text += R"(<path id="line-)" + std::to_string(i + 1) + R"(" d=")";
    const std::size_t n = line.points.size() - (line.is_closed ? 1 : 0);
    for (std::size_t k = 0; k < n; ++k) {
      const Vec2 p = line.points[k];
      append_pair(out.text += k == 0 ? "M " : " L ", p.x, down(p.y));
    }
    out.text += line.is_closed ? " Z\"/>\n" : "\"/>\n";
  }
  out.text += "</svg>\n";
  return out;
}

template <bool kHasHeights>
Expected<LineText> lines_as_dxf(std::span<const TextLine> lines) {
  LineConversions conversions(MapTarget::own_system);
  // Radii are lengths of the plane, so that lines with radii are in the plane as well, and not in degrees.
  const auto is_of_plane = [](const TextLine& line) {
    return !line.map || kHasHeights || line.map->projection == MapProjection::none;
  };
  const bool has_unit = !lines.empty() && lines.front().map && is_of_plane(lines.front());
  LineText out{DxfText::beginning(has_unit ? lines.front().map->plane_unit() : "")};
  DxfText dxf(out.text, "centerline");
  for (const TextLine& line : lines) {
    const auto points = is_of_plane(line) ? Expected<std::vector<Vec2>>(line.points) : conversions.points_of(line);
    if (!points) return std::unexpected(points.error());
    const std::size_t count = points->size() - (line.is_closed ? 1 : 0);
    const std::vector<double> unknown(kHasHeights && line.radii.empty() ? count : 0, 0.0);
    const std::span<const double> heights = line.radii.empty() ? unknown : line.radii;
    dxf.polyline(std::span(*points).first(count), line.is_closed, heights.first(kHasHeights ? count : 0));
  }
  out.text += DxfText::kEnd;
  return out;
}

template <const char* const& kDriver>
Expected<LineText> lines_by_gdal(std::span<const TextLine> lines) {
  const std::optional<MapPlane> map = lines.empty() ? std::nullopt : lines.front().map;
  const bool is_one_system = std::ranges::all_of(lines, [&](const TextLine& line) {
    return is_of_map(line) == is_of_map(lines.front()) && (!is_of_map(line) || line.map->system == map->system);
  });
  // From WGS 84 GDAL comes back by an operation of its own choice, in New York to a place a metre away.
  const MapTarget target = is_one_system ? MapTarget::own_system : MapTarget::wgs84;
  auto out = features_of_lines(lines, target);
  if (!out) return out;
  auto file = map_file_of(out->text, kDriver, map, target);
  if (!file) return std::unexpected(file.error());
  out->text = *std::move(file);
  return out;
}

// One line per format.
constexpr std::array<LineTextFormat, 8> kLineFormats{{
    {"geojson", "features with numbers as properties", true, lines_as_geojson},
    {"wkt", "well-known text, a line string a line", false, lines_as_wkt},
    {"csv", "a point of a line in each row", false, lines_as_csv},
    {"svg", "a path for each line, upright", false, lines_as_svg},
    {"dxf", "a polyline for each line", false, lines_as_dxf<false>},
    {"dxf-3d", "the same in space and in the plane: the height is the radius of the largest disk, for V-shaped bits",
     false, lines_as_dxf<true>},
    {"gpkg", "a GeoPackage with the same features as geojson, by GDAL", true, lines_by_gdal<kGeoPackage>},
    {"fgb", "a FlatGeobuf with the same, by GDAL", true, lines_by_gdal<kFlatGeobuf>},
}};

}  // namespace

std::span<const LineTextFormat> line_text_formats() {
  return kLineFormats;
}

const LineTextFormat* find_line_text_format(std::string_view name) {
  const auto found = std::ranges::find(kLineFormats, name, &LineTextFormat::name);
  return found == kLineFormats.end() ? nullptr : &*found;
}

}  // namespace mes
