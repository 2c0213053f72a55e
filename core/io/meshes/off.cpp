// SPDX-License-Identifier: GPL-3.0-or-later
// OFF of Geomview, seen from above or in the common plane of the vertices: "OFF", "vertices faces edges", then a line
// for each vertex and each face. Normals, colours and texture coordinates (NOFF, COFF, STOFF) are left out; a face of
// two corners is a segment.
#include <fmt/core.h>

#include "core/io/format_spec.h"
#include "core/io/meshes/vertex_graph.h"
#include "core/io/text/line_words.h"
#include "core/io/text/written_decimals.h"

namespace mes {
namespace {

/// Whether the word is OFF with any of the prefixes ST, C and N.
bool is_magic(std::string_view word) {
  if (word.starts_with("ST")) word.remove_prefix(2);
  if (word.starts_with('C')) word.remove_prefix(1);
  if (word.starts_with('N')) word.remove_prefix(1);
  return word == "OFF";
}

Match match_off(std::string_view bytes) {
  static const std::string kNoName;
  constexpr std::size_t kLookedAt = std::size_t{1} << 12U;
  LineWords lines(bytes.substr(0, kLookedAt), kNoName);
  return lines.next() && is_magic(lines.word(0)) ? Match::surely : Match::no;
}

class OffMeshReader {
 public:
  OffMeshReader(std::string_view bytes, const std::string& name, ReadJob& job)
      : lines_(bytes, name, &job), name_(name), job_(job) {}

  Expected<LoadedFile> read() {
    if (auto done = read_header(); !done) return std::unexpected(done.error());
    for (std::uint64_t i = 0; i < vertices_; ++i)
      if (auto done = read_vertex(i); !done) return std::unexpected(done.error());
    for (std::uint64_t i = 0; i < faces_; ++i)
      if (auto done = read_face(i); !done) return std::unexpected(done.error());
    std::vector<std::string> remarks;
    first_vertex_.text = graph_.leave_heights_out(decimals_.rounding());
    if (!first_vertex_.text.empty()) remarks.push_back(first_vertex_.message());
    if (lines_.next())
      remarks.push_back(lines_.remark(0, fmt::format("everything after the {} announced faces is ignored", faces_)));
    auto file = std::move(graph_).load(name_, job_);
    if (file) file->warnings.insert(file->warnings.end(), remarks.begin(), remarks.end());
    return file;
  }

 private:
  Expected<void> read_header() {
    lines_.next();
    // The magic word is optional.
    const bool has_magic = !parse_count(lines_.word(0));
    if (has_magic && !is_magic(lines_.word(0)))
      return lines_.refuse(0, fmt::format("expected OFF, found {}", in_quotes(lines_.word(0))));
    std::size_t at = has_magic ? 1 : 0;
    if (has_magic && lines_.count() == 1) {
      lines_.next();
      at = 0;
    }
    if (lines_.word(at) == "BINARY") return lines_.refuse(at, "only OFF as text can be read");
    const auto vertices = lines_.whole(at, "the number of vertices");
    if (!vertices) return std::unexpected(vertices.error());
    if (*vertices > kMostVertices) return lines_.refuse(at, "these are too many vertices");
    const auto faces = lines_.whole(at + 1, "the number of faces");
    if (!faces) return std::unexpected(faces.error());
    vertices_ = *vertices;
    faces_ = *faces;
    return {};
  }

  Expected<void> read_vertex(std::uint64_t i) {
    if (!lines_.next()) return lines_.refuse(0, fmt::format("the file ends after {} of {} vertices", i, vertices_));
    const auto position = lines_.position(0);
    if (!position) return std::unexpected(position.error());
    const auto height = lines_.number(2, "a coordinate");
    if (!height) return std::unexpected(height.error());
    if (i == 0) first_vertex_ = lines_.refuse(2, {}).error();
    decimals_.add(lines_.words().first(3));
    graph_.add_vertex(*position, *height);
    return {};
  }

  Expected<void> read_face(std::uint64_t i) {
    if (!lines_.next()) return lines_.refuse(0, fmt::format("the file ends after {} of {} faces", i, faces_));
    const auto count = lines_.whole(0, "the number of corners");
    if (!count) return std::unexpected(count.error());
    if (*count >= lines_.count()) return lines_.refuse(lines_.count(), fmt::format("expected {} corners", *count));
    corners_.clear();
    for (std::size_t k = 1; k <= *count; ++k) {
      const auto corner = lines_.whole(k, "the number of a vertex");
      if (!corner) return std::unexpected(corner.error());
      if (*corner >= vertices_) return lines_.refuse(k, fmt::format("there is no vertex {}", *corner));
      corners_.push_back(static_cast<std::uint32_t>(*corner));
    }
    if (*count == 2) {
      graph_.add_segment(corners_[0], corners_[1]);
    } else if (*count > 2) {
      graph_.add_face(corners_);
    }
    return {};
  }

  LineWords lines_;
  const std::string& name_;
  ReadJob& job_;
  VertexGraph graph_;
  VertexDecimals decimals_;
  Error first_vertex_{};
  std::vector<std::uint32_t> corners_;
  std::uint64_t vertices_ = 0;
  std::uint64_t faces_ = 0;
};

Expected<LoadedFile> read_off(std::string_view bytes, const std::string& name, ReadJob& job) {
  return OffMeshReader(bytes, name, job).read();
}

}  // namespace

Format off_format() {
  return {.descriptor = {.id = "off", .name = "OFF, from above", .extensions = {".off"}, .can_read = true},
          .match = match_off,
          .read = read_off};
}

}  // namespace mes
