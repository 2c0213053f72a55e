// SPDX-License-Identifier: GPL-3.0-or-later
// The main lines of a graph with lengths, such as the branches of an axis.
//
// A *free end* is a node with one edge. A *shape* is a component of the graph that has edges. Its first line is
//  - with two free ends or more: the longest of the shortest ways between free ends;
//  - with one: the longest way that begins there and ends where it meets itself;
//  - with none: the closed line through the longest edge that lies on a cycle, by the shortest way back.
// Each further line begins on an earlier one. It leads to a free end by the shortest way, or through an edge that
// closes a cycle back to an earlier line or to itself; the longest such line comes next.
//
// Guarantees:
//  1. No edge is in two lines of a shape, and no edge is twice in one.
//  2. The lines depend on the numbering of nodes and edges only where lengths are equal.
//  3. With enough lines asked for, every edge is in one.
//
// Cost: O(e log e) for each line of a shape with e edges. The first line of a shape with cycles may take a search from
// each free end in the worst case; bounds on the distances usually leave a few.
//
// Smallest use:
//     AxisPaths paths(PathGraph(4, {{0, 1, 5.0}, {1, 2, 3.0}, {1, 3, 1.0}}));
//     JobControl job;
//     const std::vector<AxisPath> lines = paths.main_lines(1, job);  // 0-1-2, of length 8
//
// Source of the bounds: Crescenzi, Grossi, Habib, Lanzi and Marino, "On computing the diameter of real-world undirected
// graphs", 2013 (iFUB), here with lengths and between free ends.
#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <span>
#include <vector>

#include "core/base/jobs/job_control.h"
#include "core/structures/filters/paths/path_graph.h"

namespace mes {

struct AxisPath {
  std::vector<PathStep> steps;
  double length = 0.0;
  bool is_closed = false;   ///< ends where it begins, at no free end and on no earlier line
  std::uint32_t shape = 0;  ///< number of the shape, by its first edge
};

class AxisPaths {
 public:
  explicit AxisPaths(PathGraph graph);

  std::size_t shape_count() const { return shapes_.size(); }
  const PathGraph& graph() const { return graph_; }
  bool is_free_end(std::uint32_t node) const { return graph_.away_from(node).size() == 1; }

  /// At most `most` lines of each shape, shape by shape. Throws `Cancelled`.
  std::vector<AxisPath> main_lines(std::size_t most, JobControl& job);
  /// The shortest way between two different nodes; nothing if they are in different shapes.
  std::optional<AxisPath> between(std::uint32_t a, std::uint32_t b);

 private:
  static constexpr double kFar = std::numeric_limits<double>::infinity();
  static constexpr std::uint32_t kNone = PathStep::kNone;
  struct Shape {
    std::vector<std::uint32_t> nodes;
    std::vector<std::uint32_t> edges;
    std::vector<std::uint32_t> ends;  // free ends
  };

  void find_shapes();
  /// Distances from the sources along edges that are in no line.
  void spread(const Shape& shape, std::span<const std::uint32_t> sources);
  std::uint32_t farthest_end(const Shape& shape) const;
  /// The steps from a source of the last `spread` to the node.
  std::vector<PathStep> way_to(std::uint32_t node) const;
  AxisPath first_line(const Shape& shape, JobControl& job);
  AxisPath longest_way(const Shape& shape, JobControl& job);
  AxisPath closed_line(const Shape& shape);
  AxisPath next_line(const Shape& shape, std::span<const std::uint32_t> sources);
  AxisPath through(std::uint32_t edge) const;
  void measure(AxisPath& path) const;

  PathGraph graph_;
  std::vector<Shape> shapes_;
  std::vector<std::uint32_t> shape_of_;  // for each node
  std::vector<std::uint8_t> is_taken_;   // for each edge: it is in a line
  std::vector<double> distance_;
  std::vector<PathStep> arrival_;  // the step by which a node was reached; its edge is kNone at sources
};

}  // namespace mes
