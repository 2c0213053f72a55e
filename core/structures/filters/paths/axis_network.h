// SPDX-License-Identifier: GPL-3.0-or-later
// An axis as a graph of branches, for lines along it, whatever the axis was computed from.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "core/base/geometry/vec2.h"
#include "core/structures/filters/paths/center_line.h"
#include "core/structures/filters/paths/path_graph.h"

namespace mes {

class AxisNetwork {
 public:
  /// An end or a junction of branches, with the radius of the ball about it.
  struct Node {
    Vec2 place{};
    double radius = 0.0;
  };

  AxisNetwork() = default;
  AxisNetwork(const AxisNetwork&) = delete;
  AxisNetwork& operator=(const AxisNetwork&) = delete;
  virtual ~AxisNetwork() = default;

  std::span<const Node> nodes() const { return nodes_; }
  std::span<const PathEdge> branches() const { return branches_; }
  /// Points that are an axis on their own, as in a disk.
  std::size_t points() const { return points_; }
  /// Adds the pieces of a branch, with their banks, to the axis of a line that ends where the branch begins.
  virtual void append(std::size_t branch, bool is_backwards, CenterLine& line) const = 0;

 protected:
  std::uint32_t add_node(Vec2 place, double radius) {
    nodes_.push_back({place, radius});
    return static_cast<std::uint32_t>(nodes_.size() - 1);
  }

  std::vector<Node> nodes_{};
  std::vector<PathEdge> branches_{};
  std::size_t points_ = 0;
};

}  // namespace mes
