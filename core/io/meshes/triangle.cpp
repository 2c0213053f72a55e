// SPDX-License-Identifier: GPL-3.0-or-later
// The vertices (.node) and planar straight line graphs (.poly) of Triangle, as its documentation describes them: "n 2
// attributes markers", then "number x y ..." for each vertex; "segments markers", then "number from to ..." for each
// segment; "holes", then points in holes. If a .poly file announces no vertices, they are in the .node file beside it.
// `#` begins a comment.
#include <fmt/core.h>
#include <system_error>

#include "core/io/files/read_file.h"
#include "core/io/format_spec.h"
#include "core/io/meshes/vertex_graph.h"
#include "core/io/text/line_words.h"

namespace mes {
namespace {

/// Error text with "12 of 30 vertices".
std::unexpected<Error> ends_early(const LineWords& lines, std::uint64_t read, std::uint64_t announced,
                                  std::string_view things) {
  return lines.refuse(lines.count(), fmt::format("the file ends after {} of {} {}", read, announced, things));
}

struct TriangleHeader {
  std::uint64_t vertices = 0;
  std::uint64_t attributes = 0;
};

class TriangleReader {
 public:
  TriangleReader(std::string_view bytes, const std::string& name, ReadJob& job)
      : lines_(bytes, name, &job), name_(name), job_(job) {}

  /// `beside`: the file with the vertices if this one has none; null if there can be no such file.
  Expected<LoadedFile> read(const std::filesystem::path* beside) {
    const auto header = read_header(lines_);
    if (!header) return std::unexpected(header.error());
    std::vector<SourceFile> sources;
    if (header->vertices != 0) {
      if (auto done = read_vertices(lines_, *header); !done) return std::unexpected(done.error());
    } else if (auto done = read_node_file(beside, sources); !done) {
      return std::unexpected(done.error());
    }
    if (lines_.next())
      if (auto done = read_segments(); !done) return std::unexpected(done.error());
    auto file = std::move(graph_).load(name_, job_);
    if (!file) return file;
    file->warnings.insert(file->warnings.end(), remarks_.begin(), remarks_.end());
    file->sources = std::move(sources);
    return file;
  }

 private:
  static Expected<TriangleHeader> read_header(LineWords& lines) {
    lines.next();
    const auto vertices = lines.whole(0, "the number of vertices");
    if (!vertices) return std::unexpected(vertices.error());
    if (*vertices > kMostVertices) return lines.refuse(0, "these are too many vertices");
    const auto dimension = lines.whole(1, "the dimension, 2");
    if (!dimension) return std::unexpected(dimension.error());
    if (*dimension != 2) return lines.refuse(1, fmt::format("expected the dimension 2, found {}", *dimension));
    TriangleHeader out{.vertices = *vertices};
    if (lines.count() > 2) {
      const auto attributes = lines.whole(2, "the number of attributes");
      if (!attributes) return std::unexpected(attributes.error());
      out.attributes = *attributes;
    }
    return out;
  }

  Expected<void> read_vertices(LineWords& lines, const TriangleHeader& header) {
    if (header.attributes != 0) remarks_.push_back(lines.remark(2, "attributes of vertices are left out"));
    for (std::uint64_t i = 0; i < header.vertices; ++i) {
      if (!lines.next()) return ends_early(lines, i, header.vertices, "vertices");
      const auto number = lines.whole(0, "the number of a vertex");
      if (!number) return std::unexpected(number.error());
      if (i == 0) {
        if (*number > 1)
          return lines.refuse(0, fmt::format("the first vertex has the number 0 or 1, not {}", *number));
        first_ = *number;
      }
      if (*number != first_ + i)
        return lines.refuse(0, fmt::format("expected vertex {}, found {}", first_ + i, *number));
      const auto position = lines.position(1);
      if (!position) return std::unexpected(position.error());
      graph_.add_vertex(*position);
    }
    return {};
  }

  Expected<void> read_node_file(const std::filesystem::path* beside, std::vector<SourceFile>& sources) {
    std::error_code error;
    if (beside == nullptr || !std::filesystem::exists(*beside, error))
      return lines_.refuse(0, beside == nullptr
                                  ? std::string("there are no vertices, which would be in a .node file beside it")
                                  : fmt::format("there are no vertices, nor is there {} beside it, which would have "
                                                "them",
                                                printable(beside->filename().string())));
    const auto bytes = read_regular_file(*beside, {.job = job_.control()});
    if (!bytes) return std::unexpected(bytes.error());
    sources.push_back({*beside, fingerprint_of(*bytes)});
    const std::string name = beside->string();
    job_.begin(*bytes);
    LineWords lines(*bytes, name, &job_);
    const auto header = read_header(lines);
    if (!header) return std::unexpected(header.error());
    auto done = read_vertices(lines, *header);
    job_.begin(lines_.rest());
    return done;
  }

  Expected<std::uint32_t> vertex(std::size_t word) const {
    const auto number = lines_.whole(word, "the number of a vertex");
    if (!number) return std::unexpected(number.error());
    if (*number >= first_ && *number - first_ < graph_.vertex_count())
      return static_cast<std::uint32_t>(*number - first_);
    return lines_.refuse(word, fmt::format("there is no vertex {}", *number));
  }

  /// Reads on from the line that announces the segments.
  Expected<void> read_segments() {
    const auto count = lines_.whole(0, "the number of segments");
    if (!count) return std::unexpected(count.error());
    for (std::uint64_t i = 0; i < *count; ++i) {
      if (!lines_.next()) return ends_early(lines_, i, *count, "segments");
      const auto from = vertex(1);
      if (!from) return std::unexpected(from.error());
      const auto to = vertex(2);
      if (!to) return std::unexpected(to.error());
      graph_.add_segment(*from, *to);
    }
    return lines_.next() ? read_holes() : Expected<void>{};
  }

  Expected<void> read_holes() {
    const auto count = lines_.whole(0, "the number of holes");
    if (!count) return std::unexpected(count.error());
    if (*count != 0)
      remarks_.push_back(lines_.remark(
          0,
          fmt::format("{} left out, for the segments around holes say where these are",
                      *count == 1 ? "the place of 1 hole is" : fmt::format("the places of {} holes are", *count))));
    for (std::uint64_t i = 0; i < *count; ++i)
      if (!lines_.next()) return ends_early(lines_, i, *count, "holes");
    if (lines_.next()) remarks_.push_back(lines_.remark(0, "attributes of regions are left out"));
    return {};
  }

  LineWords lines_;
  const std::string& name_;
  ReadJob& job_;
  VertexGraph graph_;
  std::uint64_t first_ = 1;
  std::vector<std::string> remarks_;
};

/// Recognises "n 2 a m", and two vertices with the announced number of columns.
Match match_triangle(std::string_view bytes) {
  static const std::string kNoName;
  constexpr std::size_t kLookedAt = std::size_t{1} << 16U;
  LineWords lines(bytes.substr(0, kLookedAt), kNoName);
  constexpr std::size_t kHeader = 4;
  if (!lines.next() || lines.count() != kHeader || lines.word(1) != "2") return Match::no;
  const auto vertices = parse_count(lines.word(0));
  const auto attributes = parse_count(lines.word(2));
  const auto markers = parse_count(lines.word(3));
  if (!vertices || !attributes || !markers || *attributes > kLookedAt || *markers > 1) return Match::no;
  if (*vertices == 0) return Match::maybe;
  std::uint64_t first = 0;
  for (std::uint64_t i = 0; i < 2 && i < *vertices; ++i) {
    if (!lines.next() || lines.count() != 3 + *attributes + *markers) return Match::no;
    const auto number = parse_count(lines.word(0));
    if (!number || (i == 0 ? *number > 1 : *number != first + 1)) return Match::no;
    first = *number;
  }
  return Match::surely;
}

Expected<LoadedFile> read_triangle(std::string_view bytes, const std::string& name, ReadJob& job) {
  return TriangleReader(bytes, name, job).read(nullptr);
}

Expected<LoadedFile> read_beside(std::string_view bytes, const std::string& name, const std::filesystem::path& path,
                                 ReadJob& job) {
  std::filesystem::path beside = path;
  beside.replace_extension(".node");
  return TriangleReader(bytes, name, job).read(beside == path ? nullptr : &beside);
}

}  // namespace

Format triangle_format() {
  return {.descriptor = {.id = "triangle",
                         .name = "Vertices and segments of Triangle",
                         .extensions = {".node", ".poly"},
                         .can_read = true},
          .match = match_triangle,
          .read = read_triangle,
          .read_beside = read_beside};
}

}  // namespace mes
