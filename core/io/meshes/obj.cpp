// SPDX-License-Identifier: GPL-3.0-or-later
// OBJ of Wavefront, seen from above or in the common plane of the vertices: vertices (v), lines (l), outlines of faces
// (f), points (p).
#include <fmt/core.h>
#include <algorithm>
#include <array>
#include <optional>

#include "core/io/format_spec.h"
#include "core/io/meshes/vertex_graph.h"
#include "core/io/text/ascii_text.h"
#include "core/io/text/line_words.h"
#include "core/io/text/written_decimals.h"

namespace mes {
namespace {

// Statements without positions, which can be ignored without loss.
constexpr std::array<std::string_view, 18> kSilent{
    "vt",     "vn",  "g",     "o",        "s",        "mg",         "usemtl",    "mtllib", "usemap",
    "maplib", "lod", "bevel", "c_interp", "d_interp", "shadow_obj", "trace_obj", "ctech",  "stech"};
// Curves and surfaces given by control points.
constexpr std::array<std::string_view, 15> kFreeForm{"vp",   "cstype", "deg",  "bmat", "step",
                                                     "curv", "curv2",  "surf", "parm", "trim",
                                                     "hole", "scrv",   "sp",   "end",  "con"};

class ObjReader {
 public:
  ObjReader(std::string_view bytes, const std::string& name, ReadJob& job)
      : lines_(bytes, name, &job, LineWords::Lines::continued), name_(name), job_(job) {}

  Expected<LoadedFile> read() {
    while (lines_.next())
      if (auto done = read_line(); !done) return std::unexpected(done.error());
    first_vertex_.text = graph_.leave_heights_out(decimals_.rounding());
    auto file = std::move(graph_).load(name_, job_);
    if (!file) return file;
    if (!first_vertex_.text.empty()) file->warnings.push_back(first_vertex_.message());
    file->warnings.insert(file->warnings.end(), remarks_.begin(), remarks_.end());
    return file;
  }

 private:
  Expected<void> read_line() {
    const std::string_view kind = lines_.word(0);
    if (kind == "v") return read_vertex();
    if (kind == "l") return read_line_through();
    if (kind == "f" || kind == "fo") return read_face();
    if (kind == "p" || is_one_of(kind, kSilent)) return {};
    if (!is_one_of(kind, kFreeForm))
      return lines_.refuse(0, fmt::format("expected v, l, f or another word of OBJ, found {}", in_quotes(kind)));
    if (!has_free_form_) remarks_.push_back(lines_.remark(0, "curves and surfaces of free form are left out"));
    has_free_form_ = true;
    return {};
  }

  Expected<void> read_vertex() {
    if (graph_.vertex_count() >= kMostVertices) return lines_.refuse(0, "these are too many vertices");
    const auto position = lines_.position(1);
    if (!position) return std::unexpected(position.error());
    if (graph_.vertex_count() == 0) first_vertex_ = lines_.refuse(0, {}).error();
    // A vertex without a height has height 0.
    const auto height = lines_.count() > 3 ? lines_.number(3, "a coordinate") : Expected<double>(0.0);
    if (!height) return std::unexpected(height.error());
    decimals_.add(lines_.words().subspan(1, std::min<std::size_t>(lines_.count() - 1, 3)));
    graph_.add_vertex(*position, *height);
    return {};
  }

  /// "5", "5/2/7", or "-1" for the last vertex so far.
  Expected<std::uint32_t> vertex(std::size_t i) const {
    std::string_view word = lines_.word(i);
    word = word.substr(0, word.find('/'));
    const bool is_backwards = word.starts_with('-');
    const auto number = parse_count(is_backwards ? word.substr(1) : word);
    if (!number) return lines_.refuse(i, fmt::format("expected the number of a vertex, found {}", in_quotes(word)));
    if (*number == 0 || *number > graph_.vertex_count())
      return lines_.refuse(i, fmt::format("there is no vertex {}", in_quotes(word)));
    return static_cast<std::uint32_t>(is_backwards ? graph_.vertex_count() - *number : *number - 1);
  }

  Expected<void> read_corners(std::size_t least) {
    corners_.clear();
    for (std::size_t i = 1; i < lines_.count(); ++i) {
      const auto corner = vertex(i);
      if (!corner) return std::unexpected(corner.error());
      corners_.push_back(*corner);
    }
    if (corners_.size() >= least) return {};
    return lines_.refuse(lines_.count(), fmt::format("expected {} vertices at least", least));
  }

  Expected<void> read_line_through() {
    if (auto done = read_corners(2); !done) return done;
    for (std::size_t i = 1; i < corners_.size(); ++i) graph_.add_segment(corners_[i - 1], corners_[i]);
    return {};
  }

  Expected<void> read_face() {
    constexpr std::size_t kTriangle = 3;
    if (auto done = read_corners(kTriangle); !done) return done;
    graph_.add_face(corners_);
    return {};
  }

  LineWords lines_;
  const std::string& name_;
  ReadJob& job_;
  VertexGraph graph_;
  VertexDecimals decimals_;
  Error first_vertex_{};
  std::vector<std::uint32_t> corners_;
  std::vector<std::string> remarks_;
  bool has_free_form_ = false;
};

/// Whether there are only words of OBJ, with a vertex among the first lines.
Match match_obj(std::string_view bytes) {
  static const std::string kNoName;
  constexpr std::size_t kLookedAt = std::size_t{1} << 16U;
  LineWords lines(bytes.substr(0, kLookedAt), kNoName, nullptr, LineWords::Lines::continued);
  while (lines.next()) {
    if (lines.word(0) == "v") return lines.count() > 2 && parse_number(lines.word(1)) ? Match::surely : Match::no;
    if (!is_one_of(lines.word(0), kSilent) && !is_one_of(lines.word(0), kFreeForm)) return Match::no;
  }
  return Match::no;
}

Expected<LoadedFile> read_obj(std::string_view bytes, const std::string& name, ReadJob& job) {
  return ObjReader(bytes, name, job).read();
}

}  // namespace

Format obj_format() {
  return {.descriptor = {.id = "obj", .name = "OBJ, from above", .extensions = {".obj"}, .can_read = true},
          .match = match_obj,
          .read = read_obj};
}

}  // namespace mes
