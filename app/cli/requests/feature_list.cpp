// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/requests/feature_list.h"

#include <fmt/core.h>
#include <unistd.h>

#include <array>
#include <filesystem>
#include <string_view>
#include <system_error>
#include <utility>

#include "app/cli/console/messages.h"
#include "core/graph/registry.h"
#include "core/io/files/read_file.h"
#include "core/io/format.h"
#include "core/io/format_spec.h"
#include "core/io/maps/gdal.h"
#include "core/io/session/json_text.h"
#include "core/io/session/json_view.h"
#include "core/io/text/text_numbers.h"

namespace mes::cli {
namespace {

constexpr std::string_view kBlanks = " \t\r\n\x1e";

/// The value as it is written in the text: a view has no end of its own, so it is taken off the rest.
std::string written(JsonView value, std::string_view text) {
  if (!value) return {};
  const std::string_view rest = text.substr(value.offset_in(text));
  std::size_t depth = 0;
  bool is_in_text = false;
  for (std::size_t i = 0; i < rest.size(); ++i) {
    const char c = rest[i];
    if (is_in_text) {
      if (c == '\\') ++i;
      if (c == '"') is_in_text = false;
      if (c == '"' && depth == 0) return std::string(rest.substr(0, i + 1));
      continue;
    }
    if (c == '"') is_in_text = true;
    if (c == '{' || c == '[') ++depth;
    if (depth == 0 && (c == ',' || c == '}' || c == ']' || c == ' ' || c == '\n' || c == '\r' || c == '\t'))
      return std::string(rest.substr(0, i));
    if ((c == '}' || c == ']') && --depth == 0) return std::string(rest.substr(0, i + 1));
  }
  return std::string(rest);
}

void add_named(MapFeature feature, std::string format, const std::string& file, FeatureList& out) {
  const std::size_t number = out.features.size() + 1;
  std::string name = fmt::format("{}: feature {}", file, number);
  if (!feature.id.empty())
    name += ", id " + printable(feature.id);
  else if (format != "geojson")
    feature.id = std::to_string(number);
  out.features.push_back({std::move(feature), std::move(name), std::move(format)});
}

void add_feature(JsonView feature, const std::string& crs, std::string_view text, const std::string& file,
                 FeatureList& out) {
  const auto [id, geometry, properties] =
      feature.pick(std::array<std::string_view, 3>{"id", "geometry", "properties"});
  MapFeature added;
  added.id = id.is_text() || id.is_number() ? written(id, text) : std::string();
  if (properties.is_object()) {
    const std::string object = written(properties, text);
    const std::size_t first = object.find_first_not_of(kBlanks, 1);
    const std::size_t last = object.find_last_not_of(kBlanks, object.size() - 2);
    if (first <= last) added.properties = object.substr(first, last + 1 - first);
    for (const auto& [key, value] : properties.members()) added.keys.push_back(key.text());
  }
  added.text = R"({"type":"FeatureCollection",)" + crs + R"("features":[)" + written(feature, text) + "]}";
  add_named(std::move(added), "geojson", file, out);
}

Expected<void> add_geojson(std::string_view text, const std::string& file, FeatureList& out) {
  std::string_view rest = text;
  for (std::string_view record = take_json_text(rest); !record.empty(); record = take_json_text(rest)) {
    if (auto good = check_json(record, file); !good) return std::unexpected(good.error());
    const JsonView whole = JsonView::whole(record);
    const auto [type, features, system] = whole.pick(std::array<std::string_view, 3>{"type", "features", "crs"});
    const std::string crs = system ? R"("crs":)" + written(system, record) + ',' : std::string();
    const std::string kind = type.is_text() && type.text_length() < 64 ? type.text() : std::string();
    if (kind == "FeatureCollection" && features.is_list())
      for (const JsonView feature : features.elements()) add_feature(feature, crs, record, file, out);
    else if (kind == "Feature")
      add_feature(whole, crs, record, file, out);
    else
      return bad_json(record, 0, "--each expects features of GeoJSON", file);
  }
  return {};
}

/// The error of the reader of whole files, if there is one, since that knows more than this one.
Error better_reason(const Registry& registry, std::string_view bytes, const std::string& file, Error error) {
  const auto whole = read_sample_bytes(bytes, file, {}, {.keeps_vertices = true, .formats = &registry.formats()});
  return whole ? std::move(error) : whole.error();
}

std::string in_lower_case(std::string name) {
  for (char& c : name)
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  return name;
}

}  // namespace

PropertyNames::PropertyNames(std::span<const Feature> features) {
  for (const Feature& feature : features)
    for (const std::string& key : feature.keys) taken_.insert(in_lower_case(key));
}

std::string PropertyNames::free_name(std::string name, std::string_view prefix) const {
  while (taken_.contains(name)) name.insert(0, prefix);
  return name;
}

std::span<const std::string_view> feature_formats() {
  static constexpr std::array<std::string_view, 7> kFormats{"geojson",   "kml",        "wkt",       "geometry-table",
                                                            "shapefile", "geopackage", "flatgeobuf"};
  return kFormats;
}

Expected<FeatureList> read_features(const Registry& registry, const std::string& file, std::string_view format,
                                    bool has_system) {
  auto bytes = file == "-" ? read_whole(STDIN_FILENO, file) : read_whole(file);
  if (!bytes) return std::unexpected(bytes.error());
  FeatureList out;
  std::error_code error;
  if (file != "-" && std::filesystem::is_regular_file(file, error))
    out.sources.push_back({file, fingerprint_of(*bytes)});
  const auto begins_as = [&](std::string_view id) {
    const auto known = registry.formats().find(id);
    return known != nullptr && known->match(*bytes) == Match::surely;
  };
  const auto is_in = [&](std::string_view id) { return format.empty() ? begins_as(id) : format == id; };
  if (is_in("kml")) {
    auto features = kml_features(*bytes, file);
    if (!features) return std::unexpected(features.error());
    for (MapFeature& feature : *features) add_named(std::move(feature), "kml", file, out);
  } else if (is_in("wkt")) {
    // Each line of anything else would be a feature that is wrong.
    if (begins_as("wkt"))
      for (MapFeature& feature : wkt_features(*bytes)) add_named(std::move(feature), "wkt", file, out);
  } else if (is_in("geometry-table")) {
    for (MapFeature& feature : geometry_table_features(*bytes)) {
      const bool is_wkt = begins_wkt(feature.text);
      add_named(std::move(feature), is_wkt ? "wkt" : "wkb", file, out);
    }
  } else {
    const std::size_t begin = without_bom(*bytes).find_first_not_of(kBlanks);
    if (is_for_gdal(*bytes)) {
      const std::filesystem::path path = file;
      if (is_in("shapefile") && file == "-")
        return std::unexpected(Error{
            ErrorCode::bad_input, "the attributes of a shapefile lie in files beside it, which are not there", file});
      if (is_in("shapefile")) {
        const auto remark = check_shapefile(*bytes, file, path, has_system);
        if (!remark) return std::unexpected(remark.error());
        if (!remark->empty()) say(*remark);
      }
      bytes = geojson_by_gdal(*bytes, file, file == "-" ? nullptr : &path, nullptr);
      if (!bytes) return std::unexpected(bytes.error());
    } else if (begin == std::string_view::npos || without_bom(*bytes)[begin] != '{') {
      Error other{ErrorCode::bad_input,
                  "--each reads features of GeoJSON, KML, WKT, tables with a column of geometries, shapefiles, "
                  "GeoPackages and FlatGeobufs",
                  file};
      return std::unexpected(better_reason(registry, *bytes, file, std::move(other)));
    }
    if (auto done = add_geojson(without_bom(*bytes), file, out); !done)
      return std::unexpected(better_reason(registry, *bytes, file, done.error()));
  }
  if (out.features.empty()) return std::unexpected(Error{ErrorCode::bad_input, "there are no features", file});
  return out;
}

}  // namespace mes::cli
