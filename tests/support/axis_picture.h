// SPDX-License-Identifier: GPL-3.0-or-later
// The visible medial axis: the drawn segments, with ends merged into one node if they are nearer than a merge distance.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "core/base/geometry/vec2.h"

namespace mes::test {

struct AxisPicture {
  struct Node {
    Vec2 position;
    std::size_t degree = 0;
  };
  std::vector<Node> nodes;
  std::size_t edges = 0;  ///< edges between different nodes
  std::size_t components = 0;
  double length = 0.0;

  std::size_t cycles() const { return edges + components - nodes.size(); }
  /// Positions of the nodes with this degree; `degree` 3 means at least three.
  std::vector<Vec2> with_degree(std::size_t degree) const;
};

/// Takes the instances of a segment layer: x1 y1 x2 y2 scalar each.
AxisPicture axis_picture(std::span<const double> segments, double merge_distance);

}  // namespace mes::test
