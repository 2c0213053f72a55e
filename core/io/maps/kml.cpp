// SPDX-License-Identifier: GPL-3.0-or-later
// KML (OGC 12-007r2): points, lines, rings and tracks in longitude and latitude, projected or kept
// (core/io/maps/map_shapes.h). Heights are left out, and elements without their own geometry: overlays, links and models.
#include <fmt/core.h>
#include <algorithm>
#include <array>
#include <optional>

#include "core/io/format_spec.h"
#include "core/io/maps/map_shapes.h"
#include "core/io/text/text_numbers.h"
#include "core/io/xml/xml_source.h"

namespace mes {
namespace {

using pugi::xml_node;

constexpr std::string_view kBlanks = " \t\r\n";

class KmlReader {
 public:
  KmlReader(std::string_view bytes, const std::string& name, const ReadRequest& request, ReadJob& job)
      : source_(bytes, name), name_(name), job_(job), shapes_(request) {
    shapes_.require_degrees();
  }

  Expected<LoadedFile> read() {
    const auto root = source_.parse(job_);
    if (!root) return std::unexpected(root.error());
    job_.begin(source_.bytes());
    for (xml_node node = *root; node; node = next_in_document(node, *root)) {
      if (node.type() != pugi::node_element) continue;
      if (auto done = read_element(node); !done) return std::unexpected(done.error());
    }
    auto file = std::move(shapes_).load(name_, job_);
    if (!file) return file;
    if (first_height_) file->warnings.push_back(source_.error_at(*first_height_, "heights are left out").message());
    std::ranges::copy(source_.messages(), std::back_inserter(file->warnings));
    return file;
  }

 private:
  Expected<void> read_element(xml_node node) {
    job_.passed(source_.bytes().data() + source_.place_of(node));
    const std::string_view kind = local_name(node.name());
    if (kind == "Point" || kind == "LineString" || kind == "LinearRing") {
      for (const xml_node child : node.children()) {
        if (local_name(child.name()) != "coordinates") continue;
        if (auto done = read_tuples(child); !done) return done;
      }
      end(kind);
    } else if (kind == "Polygon") {
      shapes_.begin_polygon();
    } else if (kind == "Track") {
      for (const xml_node child : node.children()) {
        if (local_name(child.name()) != "coord") continue;
        if (auto done = read_numbers(child, child.child_value(), kBlanks); !done) return done;
      }
      shapes_.end_line();
    } else {
      constexpr std::array<std::string_view, 5> kLeftOut{"GroundOverlay", "ScreenOverlay", "PhotoOverlay",
                                                         "NetworkLink", "Model"};
      if (std::ranges::find(kLeftOut, kind) != kLeftOut.end())
        source_.remarks.add(fmt::format("{} is left out", kind), fmt::format("{}s are left out", kind),
                            source_.place_of(node));
    }
    return {};
  }

  void end(std::string_view kind) {
    if (kind == "Point") return shapes_.end_points();
    if (kind == "LinearRing") return shapes_.end_ring();
    shapes_.end_line();
  }

  /// "longitude,latitude,height" between blanks. Some files have a blank after a comma; it separates nothing.
  Expected<void> read_tuples(xml_node node) {
    const std::string_view text = node.child_value();
    for (std::size_t at = text.find_first_not_of(kBlanks); at != std::string_view::npos;
         at = text.find_first_not_of(kBlanks, at)) {
      std::size_t end = at;
      for (;;) {
        end = std::min(text.find_first_of(" \t\r\n,", end), text.size());
        const std::size_t next = std::min(text.find_first_not_of(kBlanks, end), text.size());
        if (next == text.size() || text[next] != ',') break;
        end = std::min(text.find_first_not_of(kBlanks, next + 1), text.size());
      }
      if (auto done = read_numbers(node, text.substr(at, end - at), " \t\r\n,"); !done) return done;
      at = end;
    }
    return {};
  }

  /// Reads two or three numbers, separated by any of `separators`.
  Expected<void> read_numbers(xml_node node, std::string_view text, std::string_view separators) {
    std::array<double, 2> numbers{};
    std::size_t count = 0;
    for (std::size_t at = text.find_first_not_of(separators); at < text.size();
         at = text.find_first_not_of(separators, at)) {
      const std::string_view word = text.substr(at, text.find_first_of(separators, at) - at);
      const std::size_t place = source_.place_of(node, word, 0);
      if (count < 2) {
        auto value = coordinates_.read(word);
        if (!value) return source_.refuse(place, std::move(value.error()));
        numbers[count] = *value;
      } else if (const auto height = parse_number(word); !height || *height != 0.0) {
        if (!height && height.error() == NumberFault::not_a_number)
          return source_.refuse(place, describe(height.error(), word));
        if (!first_height_) first_height_ = place;
      }
      constexpr std::size_t kMost = 3;
      if (++count > kMost) return source_.refuse(place, "expected longitude, latitude and height, found more");
      at += word.size();
    }
    if (count < 2) return source_.refuse(source_.place_of(node, text, 0), "expected longitude and latitude");
    shapes_.add({numbers[0], numbers[1]});
    return {};
  }

  XmlSource source_;
  const std::string& name_;
  ReadJob& job_;
  MapShapes shapes_;
  CoordinateReader coordinates_;
  std::optional<std::size_t> first_height_;
};

Match match_kml(std::string_view bytes) {
  return xml_root_name(bytes) == "kml" ? Match::surely : Match::no;
}

Expected<LoadedFile> read_kml(std::string_view bytes, const std::string& name, const ReadRequest& request,
                              const std::filesystem::path*, ReadJob& job) {
  return KmlReader(without_bom(bytes), name, request, job).read();
}

}  // namespace

Format kml_format() {
  return {.descriptor = {.id = "kml", .name = "KML", .extensions = {".kml"}, .can_read = true, .is_map = true},
          .match = match_kml,
          .read_map = read_kml,
          .may_look_foreign = true};
}

}  // namespace mes
