// SPDX-License-Identifier: GPL-3.0-or-later
// Vertices with segments and faces, as in meshes and planar straight line graphs, converted to curves. Private to
// core/io.
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <span>
#include <string>
#include <vector>

#include "core/base/error.h"
#include "core/base/geometry/vec2.h"
#include "core/curves/curve.h"
#include "core/io/format.h"
#include "core/io/text/read_job.h"

namespace mes {

/// The rules for vertices:
///
///  1. Successive segments, at most two at each vertex, form a curve: closed if it returns to its start; its direction
///     is that of a segment at its beginning. Where more than two segments meet, curves end; areas that they enclose
///     are regions (core/curves/line_regions.h).
///  2. An edge of exactly one face is a segment. Vertices of faces without such an edge are inside the outlines of
///     these faces, and are left out, unless there is no outline at all (a closed surface).
///  3. All other vertices are points.
///
/// Segments from a vertex to itself, and repeated segments, are ignored.
///
/// Smallest use:
///     VertexGraph graph;
///     for (const Vec2 corner : {Vec2{0, 0}, Vec2{1, 0}, Vec2{0, 1}}) graph.add_vertex(corner);
///     graph.add_face(std::vector<std::uint32_t>{0, 1, 2});
///     return std::move(graph).load(name, job);
///
/// Cost: O(n log n) for n segments and edges of faces, 8 bytes for each.
class VertexGraph {
 public:
  std::size_t vertex_count() const { return positions_.size(); }
  void add_vertex(Vec2 position) { positions_.push_back(position); }
  /// The same in space. Either all vertices have a height or none has.
  void add_vertex(Vec2 position, double height) {
    positions_.push_back(position);
    heights_.push_back(height);
  }
  /// Drops the heights: vertices are seen from above. If all lie in one plane that is not level, that plane is used
  /// instead, upright, with lengths unchanged. `rounding` is the largest error of their coordinates; less than a
  /// millionth of the extent counts as flat. Returns one line about the change; empty if all heights are equal.
  std::string leave_heights_out(double rounding);
  /// The vertex of an earlier call at this position, or a new one. Do not mix with `add_vertex`.
  std::uint32_t vertex_at(Vec2 position);
  /// Both vertices must exist.
  void add_segment(std::uint32_t from, std::uint32_t to) { segments_.push_back({from, to}); }
  void add_face(std::span<const std::uint32_t> corners);

  /// Open curves, then closed ones, each ordered by first vertex, then points. `remarks` gets a line a kind of
  /// omission.
  CurveSet curves(std::vector<std::string>& remarks) &&;
  /// Their samples by `default_sampling`, which keeps the vertices. Error: as `load_samples`. Throws `Cancelled`.
  Expected<LoadedFile> load(const std::string& name, ReadJob& job) &&;

 private:
  struct Segment {
    std::uint32_t from;
    std::uint32_t to;
  };
  void add_outlines_of_faces();
  void drop_repeated_segments();

  struct Before {
    bool operator()(Vec2 a, Vec2 b) const { return a.x != b.x ? a.x < b.x : a.y < b.y; }
  };
  std::vector<Vec2> positions_;
  std::vector<double> heights_;
  std::map<Vec2, std::uint32_t, Before> vertex_at_;
  std::vector<Segment> segments_;
  std::vector<Segment> face_edges_;
  std::vector<bool> is_on_face_;  // for the first vertices; later ones are on no face
};

/// The largest number of vertices in a document, given by the width of its ids.
inline constexpr std::uint64_t kMostVertices = 0xfffffffe;

}  // namespace mes
