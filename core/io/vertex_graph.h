// SPDX-License-Identifier: GPL-3.0-or-later
// Vertices with segments and faces between them, as meshes and planar straight line graphs have them, on their way to
// curves. Private to core/io.
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <span>
#include <string>
#include <vector>

#include "core/base/error.h"
#include "core/base/vec2.h"
#include "core/curves/curve.h"
#include "core/io/format.h"
#include "core/io/read_job.h"

namespace mes {

/// What becomes of the vertices:
///
///  1. Segments that follow each other, never more than two at a vertex, are a curve: closed, if they come back to where
///     they start; in the direction of a segment at its beginning. Where more than two meet, curves end; what they enclose
///     are regions (core/curves/line_regions.h).
///  2. An edge of exactly one face is a segment. Vertices of faces that lie on no such edge are inside the outlines of
///     these faces, and left out, unless there is no outline at all (a closed surface).
///  3. All other vertices are points.
///
/// Segments that join a vertex to itself or repeat another one count for nothing.
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
  /// The same in space. All vertices have a height, or none has.
  void add_vertex(Vec2 position, double height) {
    positions_.push_back(position);
    heights_.push_back(height);
  }
  /// Leaves the heights out: vertices are seen from above. If all lie in one plane that is not level, they are taken in that
  /// plane instead, upright, without a change of lengths. `rounding` is how much their coordinates may be off; what is
  /// less than a millionth of the extent counts as flat. One line that says what was done; empty where heights are equal.
  std::string leave_heights_out(double rounding);
  /// The vertex that was found at this place before, or a new one. Not to be mixed with `add_vertex`.
  std::uint32_t vertex_at(Vec2 position);
  /// Of vertices that there are.
  void add_segment(std::uint32_t from, std::uint32_t to) { segments_.push_back({from, to}); }
  void add_face(std::span<const std::uint32_t> corners);

  /// Open curves, then closed ones, each in the order of their first vertices, then points. `remarks` gets one line a kind of what was left out.
  CurveSet curves(std::vector<std::string>& remarks) &&;
  /// Their samples by `default_sampling`, which keeps the vertices. Error: as `load_samples`, and `Cancelled` is thrown as there.
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
  std::vector<bool> is_on_face_;  // of the first vertices; no more are
};

/// The most vertices of a document, as many as its ids allow.
inline constexpr std::uint64_t kMostVertices = 0xfffffffe;

}  // namespace mes
