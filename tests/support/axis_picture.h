// SPDX-License-Identifier: GPL-3.0-or-later
// The medial axis as one sees it: the drawn segments, with ends nearer than a merge distance taken as one node.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "core/base/vec2.h"

namespace mes::test {

struct AxisPicture {
  struct Node {
    Vec2 position;
    std::size_t degree = 0;
  };
  std::vector<Node> nodes;
  std::size_t edges = 0;  ///< between different nodes
  std::size_t components = 0;
  double length = 0.0;

  std::size_t cycles() const { return edges + components - nodes.size(); }
  /// Positions of the nodes with this degree; `degree` 3 stands for three and more.
  std::vector<Vec2> with_degree(std::size_t degree) const;
};

/// From the instances of a segment layer: x1 y1 x2 y2 scalar each.
AxisPicture axis_picture(std::span<const double> segments, double merge_distance);

}  // namespace mes::test
