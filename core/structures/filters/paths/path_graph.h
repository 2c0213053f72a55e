// SPDX-License-Identifier: GPL-3.0-or-later
// A graph of nodes and edges with lengths, such as the branches of an axis between its ends and junctions. Plain data.
#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <utility>
#include <vector>

namespace mes {

struct PathEdge {
  std::uint32_t from = 0;
  std::uint32_t to = 0;
  double length = 0.0;  ///< finite, positive
};

/// An edge with a direction.
struct PathStep {
  static constexpr std::uint32_t kNone = std::numeric_limits<std::uint32_t>::max();
  std::uint32_t edge = kNone;
  bool is_backwards = false;  ///< from `PathEdge::to` to `PathEdge::from`
  friend bool operator==(const PathStep&, const PathStep&) = default;
  PathStep reversed() const { return {edge, !is_backwards}; }
};

/// Guarantees: the steps that lead away from a node are in the order of their edges; a loop leads away from its node
/// twice. Cost: O(nodes + edges) to build. Threads: any may read.
///
/// Smallest use:
///     const PathGraph graph(3, {{0, 1, 5.0}, {1, 2, 3.0}});
///     for (const PathStep step : graph.away_from(1)) use(graph.head(step));
class PathGraph {
 public:
  PathGraph(std::size_t nodes, std::vector<PathEdge> edges) : edges_(std::move(edges)), first_(nodes + 1, 0) {
    for (const PathEdge& edge : edges_) {
      ++first_[edge.from + 1];
      ++first_[edge.to + 1];
    }
    for (std::size_t node = 0; node < nodes; ++node) first_[node + 1] += first_[node];
    steps_.resize(2 * edges_.size());
    std::vector<std::uint32_t> next(first_.begin(), first_.end() - 1);
    for (std::uint32_t edge = 0; edge < edges_.size(); ++edge) {
      steps_[next[edges_[edge].from]++] = {edge, false};
      steps_[next[edges_[edge].to]++] = {edge, true};
    }
  }

  std::size_t nodes() const { return first_.size() - 1; }
  std::span<const PathEdge> edges() const { return edges_; }
  std::span<const PathStep> away_from(std::uint32_t node) const {
    return std::span(steps_).subspan(first_[node], first_[node + 1] - first_[node]);
  }
  std::uint32_t tail(PathStep step) const {
    return step.is_backwards ? edges_[step.edge].to : edges_[step.edge].from;
  }
  std::uint32_t head(PathStep step) const {
    return step.is_backwards ? edges_[step.edge].from : edges_[step.edge].to;
  }
  double length(PathStep step) const { return edges_[step.edge].length; }

 private:
  std::vector<PathEdge> edges_;
  std::vector<std::uint32_t> first_;  // of the steps away from each node
  std::vector<PathStep> steps_;
};

}  // namespace mes
