// SPDX-License-Identifier: GPL-3.0-or-later
// Files of samples and balls.
#include "tests/fuzz/sample_files.h"

#include <array>

#include "core/io/maps/map_features.h"

namespace mes::fuzz {
namespace {

/// A few bytes of `use`, or of blocks, may draw much; what they draw has bounds of its own.
constexpr std::size_t kMostMemoryOfDrawing = std::size_t{2} << 30U;
constexpr std::size_t kFewSamples = 10'000;

/// A drawing or a map. Where bytes have no lines, places in them are in the messages.
void check_drawing(std::string_view bytes, const std::string& name, std::string_view format, bool has_lines) {
  const auto file = read_sample_bytes(bytes, name, format);
  require(peak_bytes() <= kMostMemoryOfDrawing, "bounded memory: " + std::to_string(peak_bytes()));
  require_little_work(bytes.size(), kCurveWork);
  if (!file) return has_lines ? require_error_with_place(file.error(), bytes) : require_error(file.error(), bytes);
  for (const std::string& warning : file->warnings) require_message(warning);
  if (file->data.positions.size() <= kFewSamples) require_round_trip(file->data);
}

}  // namespace

void run_geojson(std::string_view bytes) {
  check_sample_file(bytes, "a.geojson", "geojson", kCurveWork, kMemoryOfProj);
}
void run_gpx(std::string_view bytes) {
  check_sample_file(bytes, "a.gpx", "gpx", kCurveWork);
}
void run_kml(std::string_view bytes) {
  check_sample_file(bytes, "a.kml", "kml", kCurveWork);
}
void run_poff(std::string_view bytes) {
  check_sample_file(bytes, "a.poff", "poff");
}
void run_wkt(std::string_view bytes) {
  check_sample_file(bytes, "a.wkt", "wkt", kCurveWork, kMemoryOfProj);
}
void run_wpoff(std::string_view bytes) {
  check_sample_file(bytes, "a.wpoff", "wpoff");
}

void run_dxf(std::string_view bytes) {
  check_drawing(bytes, "a", "dxf", true);
}
void run_ipe(std::string_view bytes) {
  check_drawing(bytes, "a", "ipe", true);
}
void run_svg(std::string_view bytes) {
  check_drawing(bytes, "a.svg", "svg", true);
}
void run_shapefile(std::string_view bytes) {
  check_drawing(bytes, "a", "shapefile", false);
}
void run_wkb(std::string_view bytes) {
  check_drawing(bytes, "a", "wkb", false);
}

/// Tables of coordinates, as each of the formats and as what they look like. The first byte says which.
void run_table(std::string_view bytes) {
  constexpr std::array<std::string_view, 5> kFormats{"", "csv", "tsv", "xyz", "pairs"};
  if (bytes.empty()) return;
  geometry_table_features(bytes.substr(1));
  check_sample_file(bytes.substr(1), "a.txt", kFormats[first_byte(bytes) % kFormats.size()], kCurveWork);
}

/// Vertices with segments and faces, as each of their formats. The first byte says which.
void run_mesh(std::string_view bytes) {
  constexpr std::array<std::string_view, 5> kFormats{"triangle", "edg", "obj", "off", "ply"};
  if (bytes.empty()) return;
  const std::string_view text = bytes.substr(1);
  const auto file = read_sample_bytes(text, "a", kFormats[first_byte(bytes) % kFormats.size()]);
  require_little_memory(text.size(), 600);
  require_little_work(text.size(), kCurveWork);
  // A PLY may be binary after its header: then the place is in the message.
  if (!file) return require_error(file.error(), text);
  for (const std::string& warning : file->warnings) require_message(warning);
  require_round_trip(file->data);
}

}  // namespace mes::fuzz
