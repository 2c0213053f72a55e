// SPDX-License-Identifier: GPL-3.0-or-later
// GPX (GPX 1.1 schema documentation): track segments and routes as lines, waypoints as points, in longitude and
// latitude, projected or kept (core/io/maps/map_shapes.h). Heights and times are left out.
#include <fmt/core.h>
#include <array>
#include <optional>

#include "core/io/format_spec.h"
#include "core/io/maps/map_shapes.h"
#include "core/io/text/text_numbers.h"
#include "core/io/xml/xml_source.h"

namespace mes {
namespace {

using pugi::xml_node;

class GpxReader {
 public:
  GpxReader(std::string_view bytes, const std::string& name, const ReadRequest& request, ReadJob& job)
      : source_(bytes, name), name_(name), job_(job), shapes_(request) {
    shapes_.require_degrees();
  }

  Expected<LoadedFile> read() {
    const auto root = source_.parse(job_);
    if (!root) return std::unexpected(root.error());
    job_.begin(source_.bytes());
    for (const xml_node node : root->children()) {
      const std::string_view kind = local_name(node.name());
      auto done = kind == "wpt"   ? read_position(node)
                  : kind == "rte" ? read_line(node, "rtept")
                  : kind == "trk" ? read_track(node)
                                  : Expected<void>{};
      if (!done) return std::unexpected(done.error());
      if (kind == "wpt") shapes_.end_points();
    }
    auto file = std::move(shapes_).load(name_, job_);
    if (file && first_height_)
      file->warnings.push_back(source_.error_at(*first_height_, "heights are left out").message());
    return file;
  }

 private:
  Expected<void> read_track(xml_node track) {
    for (const xml_node node : track.children()) {
      if (local_name(node.name()) != "trkseg") continue;
      if (auto done = read_line(node, "trkpt"); !done) return done;
    }
    return {};
  }

  Expected<void> read_line(xml_node line, std::string_view positions) {
    for (const xml_node node : line.children()) {
      if (local_name(node.name()) != positions) continue;
      if (auto done = read_position(node); !done) return done;
    }
    shapes_.end_line();
    return {};
  }

  Expected<void> read_position(xml_node node) {
    const std::size_t place = source_.place_of(node);
    job_.passed(source_.bytes().data() + place);
    std::array<double, 2> numbers{};
    constexpr std::array<const char*, 2> kNames{"lon", "lat"};
    for (std::size_t i = 0; i < 2; ++i) {
      const std::string_view text = node.attribute(kNames[i]).value();
      if (text.empty()) return source_.refuse(place, fmt::format("{} has no {}", node.name(), kNames[i]));
      auto value = coordinates_.read(text);
      if (!value) return source_.refuse(source_.place_of(node, text, 0), std::move(value.error()));
      numbers[i] = *value;
    }
    if (!first_height_)
      for (const xml_node child : node.children())
        if (local_name(child.name()) == "ele") first_height_ = source_.place_of(child);
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

Match match_gpx(std::string_view bytes) {
  return xml_root_name(bytes) == "gpx" ? Match::surely : Match::no;
}

Expected<LoadedFile> read_gpx(std::string_view bytes, const std::string& name, const ReadRequest& request,
                              const std::filesystem::path*, ReadJob& job) {
  return GpxReader(without_bom(bytes), name, request, job).read();
}

}  // namespace

Format gpx_format() {
  return {.descriptor = {.id = "gpx", .name = "GPX", .extensions = {".gpx"}, .can_read = true, .is_map = true},
          .match = match_gpx,
          .read_map = read_gpx,
          .may_look_foreign = true};
}

}  // namespace mes
