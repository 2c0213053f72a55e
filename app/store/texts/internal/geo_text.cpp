// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/store/texts/internal/geo_text.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <span>
#include <system_error>

#include "core/io/maps/gdal.h"
#include "core/io/systems/map_conversion.h"
#include "core/io/text/text_numbers.h"

namespace mes {
namespace {

void append_list(std::string& out, std::span<const Vec2> corners, std::string_view open, std::string_view between,
                 std::string_view close) {
  bool is_first = true;
  for (const Vec2 p : corners) {
    if (!is_first) out += ',';
    is_first = false;
    out += open;
    append_number(out, p.x);
    out += between;
    append_number(out, p.y);
    out += close;
  }
}

}  // namespace

std::string begin_of_features(bool are_in_degrees) {
  std::string out = R"({"type":"FeatureCollection",)";
  if (are_in_degrees) out += R"("crs":{"type":"name","properties":{"name":"urn:ogc:def:crs:OGC:1.3:CRS84"}},)";
  return out + R"("features":[)";
}

std::string begin_of_features(const std::optional<MapPlane>& map, MapTarget target) {
  return begin_of_features(map && is_on_earth(*map) && (target == MapTarget::wgs84 || map->system.empty()));
}

void append_geojson(std::string& out, StraightKind kind, const GeoParts& parts) {
  out += parts.size() == 1 ? R"({"type":")" : R"({"type":"Multi)";
  switch (kind) {
    case StraightKind::point: out += R"(Point","coordinates":)"; break;
    case StraightKind::chain: out += R"(LineString","coordinates":)"; break;
    case StraightKind::polygon: out += R"(Polygon","coordinates":)"; break;
  }
  if (parts.size() > 1) out += '[';
  for (std::size_t i = 0; i < parts.size(); ++i) {
    if (i != 0) out += ',';
    out += kind == StraightKind::point ? "" : kind == StraightKind::chain ? "[" : "[[";
    append_list(out, parts[i].corners, "[", ",", "]");
    for (const std::vector<Vec2>& hole : parts[i].holes) {
      out += "],[";
      append_list(out, hole, "[", ",", "]");
    }
    out += kind == StraightKind::point ? "" : kind == StraightKind::chain ? "]" : "]]";
  }
  if (parts.size() > 1) out += ']';
  out += '}';
}

std::string srid_of(const std::optional<MapPlane>& map) {
  if (!map || !is_on_earth(*map)) return {};
  if (map->system.empty()) return "SRID=4326;";
  for (const std::string_view authority : {"EPSG:", "ESRI:"})
    if (map->system.starts_with(authority) && parse_count(map->system.substr(authority.size())))
      return "SRID=" + map->system.substr(authority.size()) + ';';
  return {};
}

void append_wkt(std::string& out, StraightKind kind, const GeoParts& parts, std::string_view srid) {
  out += srid;
  if (parts.size() > 1) out += "MULTI";
  switch (kind) {
    case StraightKind::point: out += "POINT "; break;
    case StraightKind::chain: out += "LINESTRING "; break;
    case StraightKind::polygon: out += "POLYGON "; break;
  }
  if (parts.size() > 1) out += '(';
  for (std::size_t i = 0; i < parts.size(); ++i) {
    if (i != 0) out += ", ";
    out += kind == StraightKind::polygon ? "((" : "(";
    append_list(out, parts[i].corners, "", " ", "");
    for (const std::vector<Vec2>& hole : parts[i].holes) {
      out += "), (";
      append_list(out, hole, "", " ", "");
    }
    out += kind == StraightKind::polygon ? "))" : ")";
  }
  out += parts.size() > 1 ? ")\n" : "\n";
}

void append_measure(std::string& out, double value) {
  if (!std::isfinite(value)) {
    out += "null";
    return;
  }
  const std::size_t begin = out.size();
  append_number(out, value);
  if (out.find_first_of(".eE", begin) == std::string::npos) out += ".0";
}

namespace {

/// JSON with whole numbers beyond 64 bits as strings.
std::string with_large_integers_as_text(std::string_view json) {
  std::string out;
  std::size_t copied = 0;
  for (std::size_t i = json.find_first_of("\"-0123456789"); i < json.size();) {
    std::size_t end = i + 1;
    if (json[i] == '"') {
      while (end < json.size() && json[end] != '"') end += json[end] == '\\' ? std::size_t{2} : 1;
      ++end;
    } else {
      end = std::min(json.find_first_not_of("0123456789+-.eE", i), json.size());
      const std::string_view number = json.substr(i, end - i);
      std::int64_t value = 0;
      const auto read = std::from_chars(number.data(), number.data() + number.size(), value);
      if (read.ec == std::errc::result_out_of_range && number.find_first_of(".eE") == std::string_view::npos) {
        out += json.substr(copied, i - copied);
        out += '"' + std::string(number) + '"';
        copied = end;
      }
    }
    i = json.find_first_of("\"-0123456789", end);
  }
  out += json.substr(copied);
  return out;
}

}  // namespace

Expected<std::string> map_file_of(std::string_view geojson, const char* driver, const std::optional<MapPlane>& map,
                                  MapTarget target) {
  std::optional<GdalSystem> system;
  if (map && is_on_earth(*map)) system = {map->system, target == MapTarget::own_system};
  return map_by_gdal(with_large_integers_as_text(geojson), driver, system);
}

}  // namespace mes
