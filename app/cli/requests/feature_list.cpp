// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/requests/feature_list.h"

#include <fmt/core.h>
#include <unistd.h>

#include <array>
#include <filesystem>
#include <string_view>
#include <system_error>
#include <utility>

#include "core/io/files/read_file.h"
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

void add_feature(JsonView feature, const std::string& crs, std::string_view text, const std::string& file,
                 FeatureList& out) {
  const auto [id, geometry, properties] =
      feature.pick(std::array<std::string_view, 3>{"id", "geometry", "properties"});
  Feature& added = out.features.emplace_back();
  added.id = id.is_text() || id.is_number() ? written(id, text) : std::string();
  added.name = fmt::format("{}: feature {}", file, out.features.size());
  if (!added.id.empty()) added.name += ", id " + printable(added.id);
  if (properties.is_object()) {
    const std::string object = written(properties, text);
    const std::size_t first = object.find_first_not_of(kBlanks, 1);
    const std::size_t last = object.find_last_not_of(kBlanks, object.size() - 2);
    if (first <= last) added.properties = object.substr(first, last + 1 - first);
    for (const auto& [key, value] : properties.members()) added.keys.push_back(key.text());
  }
  added.text = R"({"type":"FeatureCollection",)" + crs + R"("features":[)" + written(feature, text) + "]}";
}

}  // namespace

Expected<FeatureList> read_features(const std::string& file) {
  auto bytes = file == "-" ? read_whole(STDIN_FILENO, file) : read_whole(file);
  if (!bytes) return std::unexpected(bytes.error());
  FeatureList out;
  std::error_code error;
  if (file != "-" && std::filesystem::is_regular_file(file, error))
    out.sources.push_back({file, fingerprint_of(*bytes)});
  const std::size_t begin = without_bom(*bytes).find_first_not_of(kBlanks);
  if (is_for_gdal(*bytes)) {
    const std::filesystem::path path = file;
    bytes = geojson_by_gdal(*bytes, file, file == "-" ? nullptr : &path, nullptr);
    if (!bytes) return std::unexpected(bytes.error());
  } else if (begin == std::string_view::npos || without_bom(*bytes)[begin] != '{') {
    return std::unexpected(Error{ErrorCode::bad_input,
                                 "--each reads features of GeoJSON, shapefiles, GeoPackages and FlatGeobufs", file});
  }
  const std::string_view text = without_bom(*bytes);
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
  if (out.features.empty())
    return std::unexpected(Error{ErrorCode::bad_input, "there are no features of GeoJSON", file});
  return out;
}

}  // namespace mes::cli
