// SPDX-License-Identifier: GPL-3.0-or-later
// GeoJSON (RFC 7946), as one text or several in sequence (newline-delimited, or with the record separators of RFC
// 8142), and plain lists of rings or points in JSON.
//
// Positions are longitude and latitude, projected or kept (core/io/maps/map_shapes.h), unless a member `crs` names
// another system. They are plane coordinates in plain lists, and in exports of plane data by this program, which have no
// `crs`.
#include <fmt/core.h>
#include <algorithm>
#include <array>
#include <cstdint>
#include <optional>

#include "core/base/geometry/coordinate_range.h"
#include "core/io/format_spec.h"
#include "core/io/maps/map_shapes.h"
#include "core/io/session/json_text.h"
#include "core/io/session/json_view.h"
#include "core/io/text/text_numbers.h"

namespace mes {
namespace {

enum class GeoJsonShape : std::uint8_t { point, line, ring };

/// The coordinates are `depth` lists around a position.
struct GeoJsonType {
  std::string_view name;
  int depth;
  GeoJsonShape shape;
};
constexpr std::array<GeoJsonType, 6> kGeoJsonTypes{{{"Point", 0, GeoJsonShape::point},
                                                    {"MultiPoint", 1, GeoJsonShape::point},
                                                    {"LineString", 1, GeoJsonShape::line},
                                                    {"MultiLineString", 2, GeoJsonShape::line},
                                                    {"Polygon", 2, GeoJsonShape::ring},
                                                    {"MultiPolygon", 3, GeoJsonShape::ring}}};
constexpr std::array<std::string_view, 3> kContainers{"GeometryCollection", "Feature", "FeatureCollection"};

class GeoJsonReader {
 public:
  GeoJsonReader(std::string_view text, const std::string& name, const ReadRequest& request, ReadJob& job)
      : text_(text), name_(name), job_(job), shapes_(request) {
    shapes_.assume_degrees();
  }

  Expected<LoadedFile> read() {
    std::string_view ahead = text_;
    const JsonView first = JsonView::whole(take_json_text(ahead));
    if (first.is_list()) {
      shapes_.assume_plane();
      if (auto done = read_list(first); !done) return std::unexpected(done.error());
    }
    for (std::string_view rest = first.is_list() ? std::string_view{} : text_, record = take_json_text(rest);
         !record.empty(); record = take_json_text(rest)) {
      const JsonView whole = JsonView::whole(record);
      if (auto done = read_system(whole); !done) return std::unexpected(done.error());
      if (auto done = read_object(whole); !done) return std::unexpected(done.error());
    }
    auto file = std::move(shapes_).load(name_, job_);
    if (file && first_height_)
      file->warnings.push_back(refuse(first_height_, "heights are left out").error().message());
    return file;
  }

 private:
  std::unexpected<Error> refuse(JsonView at, std::string text) const {
    return bad_json(text_, at ? at.offset_in(text_) : 0, std::move(text), name_);
  }

  /// Reads the `crs` member of earlier versions of GeoJSON. A name without an authority that is no WKT either is that of
  /// a plane.
  Expected<void> read_system(JsonView whole) {
    const JsonView system = whole.find("crs").find("properties").find("name");
    constexpr std::size_t kLongest = std::size_t{1} << 16U;
    has_system_ = system.is_text() && system.text_length() <= kLongest;
    if (!has_system_) return {};
    const std::string text = system.text();
    if (!text.contains(':') && !text.contains('[')) {
      shapes_.assume_plane();
      return {};
    }
    if (auto done = shapes_.name_system(text); !done) return refuse(system, done.error().text);
    return {};
  }

  Expected<void> read_object(JsonView object) {
    if (!object.is_object()) return refuse(object, "expected an object of GeoJSON");
    const auto [type, coordinates, geometry, geometries, features, properties] = object.pick(
        std::array<std::string_view, 6>{"type", "coordinates", "geometry", "geometries", "features", "properties"});
    if (!type.is_text()) return refuse(object, "expected an object with a \"type\"");
    constexpr std::size_t kLongest = 256;
    const std::string name = type.text_length() <= kLongest ? type.text() : std::string();
    if (name == "FeatureCollection") return read_all(features, object, "features");
    if (name == "GeometryCollection") return read_all(geometries, object, "geometries");
    if (name == "Feature") return read_feature(geometry, properties);
    const auto known = std::ranges::find(kGeoJsonTypes, name, &GeoJsonType::name);
    if (known == kGeoJsonTypes.end()) return refuse(type, in_quotes(name) + " is not a type of GeoJSON");
    if (!coordinates.is_list()) return refuse(object, "expected a list of \"coordinates\"");
    return read_coordinates(coordinates, known->depth, known->shape);
  }

  Expected<void> read_all(JsonView list, JsonView object, std::string_view key) {
    if (!list.is_list()) return refuse(object, fmt::format("expected a list of \"{}\"", key));
    for (const JsonView element : list.elements())
      if (auto done = read_object(element); !done) return done;
    return {};
  }

  Expected<void> read_feature(JsonView geometry, JsonView properties) {
    // This program exports layers of the plane in this form.
    if (!has_system_ && properties.find("layer").is_text() && properties.find("kind").is_text())
      shapes_.assume_plane();
    const bool is_null = geometry && !geometry.is_object();
    return !geometry || is_null ? Expected<void>{} : read_object(geometry);
  }

  /// Reads `depth` nested lists around a list of positions. An empty list is a geometry without positions.
  Expected<void> read_coordinates(JsonView list, int depth, GeoJsonShape shape) {
    if (depth == 0) {
      if (list.size() == 0) return {};
      if (auto done = read_position(list); !done) return done;
      shapes_.end_points();
      return {};
    }
    if (depth == 2 && shape == GeoJsonShape::ring) shapes_.begin_polygon();
    for (const JsonView element : list.elements()) {
      if (!element.is_list()) return refuse(element, "expected a list of coordinates");
      auto done = depth == 1 ? read_position(element) : read_coordinates(element, depth - 1, shape);
      if (!done) return done;
    }
    if (depth > 1) return {};
    switch (shape) {
      case GeoJsonShape::point: shapes_.end_points(); break;
      case GeoJsonShape::line: shapes_.end_line(); break;
      case GeoJsonShape::ring: shapes_.end_ring(); break;
    }
    return {};
  }

  Expected<void> read_position(JsonView list) {
    job_.passed(text_.data() + list.offset_in(text_));
    std::array<double, 2> numbers{};
    std::size_t count = 0;
    for (const JsonView element : list.elements()) {
      if (!element.is_number()) return refuse(element, "expected a number");
      if (count >= 2) {
        if (!first_height_) first_height_ = element;
      } else {
        numbers[count] = element.number();
        if (const auto fault = seen_.fault_of(numbers[count]))
          return refuse(element, describe(*fault, numbers[count], seen_));
        seen_.add(numbers[count]);
      }
      ++count;
    }
    if (count < 2) return refuse(list, "expected a position of two numbers");
    shapes_.add({numbers[0], numbers[1]});
    return {};
  }

  /// Lists of lists of positions are rings; one list of positions is a set of points.
  Expected<void> read_list(JsonView list) {
    const auto first_of = [](JsonView view) -> JsonView {
      for (const JsonView element : view.elements()) return element;
      return {};
    };
    int depth = 0;
    for (JsonView inner = first_of(list); inner.is_list(); inner = first_of(inner)) ++depth;
    if (depth == 0) return refuse(list, "expected lists of positions");
    if (depth > 1) return read_coordinates(list, depth, GeoJsonShape::ring);
    return read_coordinates(list, depth, GeoJsonShape::point);
  }

  std::string_view text_;
  const std::string& name_;
  ReadJob& job_;
  MapShapes shapes_;
  bool has_system_ = false;
  Magnitudes seen_;
  JsonView first_height_;
};

/// Whether a key "type" near the beginning has a value of GeoJSON.
bool names_a_type(std::string_view bytes) {
  constexpr std::size_t kLookedAt = std::size_t{1} << 16U;
  constexpr std::string_view kKey = "\"type\"";
  const std::string_view begin = bytes.substr(0, kLookedAt);
  for (std::size_t at = begin.find(kKey); at != std::string_view::npos; at = begin.find(kKey, at + 1)) {
    const std::size_t value = begin.find_first_not_of(" \t\r\n:", at + kKey.size());
    if (value == std::string_view::npos || begin[value] != '"') continue;
    const std::string_view rest = begin.substr(value + 1);
    const std::string_view word = rest.substr(0, rest.find('"'));
    if (std::ranges::find(kContainers, word) != kContainers.end()) return true;
    if (std::ranges::find(kGeoJsonTypes, word, &GeoJsonType::name) != kGeoJsonTypes.end()) return true;
  }
  return false;
}

Match match_geojson(std::string_view bytes) {
  constexpr std::string_view kBlanks = " \t\r\n\x1e";
  bytes = without_bom(bytes);
  const std::size_t begin = bytes.find_first_not_of(kBlanks);
  if (begin == std::string_view::npos) return Match::no;
  if (bytes[begin] == '{') return names_a_type(bytes) ? Match::surely : Match::no;
  const std::size_t next = bytes.find_first_not_of(kBlanks, begin + 1);
  const bool is_list_of_lists = bytes[begin] == '[' && next != std::string_view::npos && bytes[next] == '[';
  return is_list_of_lists ? Match::surely : Match::no;
}

/// Checks the whole text, or each of several objects in sequence.
Expected<void> check_texts(std::string_view text, const std::string& name, ReadJob& job) {
  std::string_view rest = text;
  const std::string_view first = take_json_text(rest);
  std::string_view others = rest;
  const bool is_separated = text.substr(0, text.find('{')).contains('\x1e');
  if (!is_separated && !take_json_text(others).starts_with('{')) return check_json(text, name, &job);
  for (std::string_view record = first; !record.empty(); record = take_json_text(rest)) {
    if (auto good = check_json(record, name, &job); !good) {
      Error error = std::move(good.error());
      const std::string_view before = text.substr(0, static_cast<std::size_t>(record.data() - text.data()));
      const auto lines = static_cast<std::uint64_t>(std::ranges::count(before, '\n'));
      if (error.line == 1) error.column += before.size() - (before.rfind('\n') + 1);
      error.line += lines;
      return std::unexpected(std::move(error));
    }
  }
  return {};
}

Expected<LoadedFile> read_geojson(std::string_view bytes, const std::string& name, const ReadRequest& request,
                                  const std::filesystem::path*, ReadJob& job) {
  const std::string_view text = without_bom(bytes);
  constexpr double kChecked = 0.4;  // share of the reading time
  job.begin(text, kChecked);
  if (auto good = check_texts(text, name, job); !good) return std::unexpected(good.error());
  job.begin(text);
  return GeoJsonReader(text, name, request, job).read();
}

}  // namespace

Format geojson_format() {
  return {.descriptor = {.id = "geojson",
                         .name = "GeoJSON, or lists of positions in JSON",
                         .extensions = {".geojson", ".geojsonl"},
                         .can_read = true,
                         .is_map = true},
          .match = match_geojson,
          .read_map = read_geojson};
}

}  // namespace mes
