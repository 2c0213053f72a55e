// SPDX-License-Identifier: GPL-3.0-or-later
// The medial axis of an outline as a graph. Plain data.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "core/base/slot.h"
#include "core/base/table.h"
#include "core/structures/outline/outline_sides.h"

namespace mes {

using OutlineFeatureSlot = Slot<struct OutlineFeatureTag>;
using OutlineNodeSlot = Slot<struct OutlineNodeTag>;
using OutlineEdgeSlot = Slot<struct OutlineEdgeTag>;

/// A point of the outline, which is a vertex or a crossing of two sides, or a side without its ends.
struct OutlineFeature {
  Vec2 from{};  ///< the point, or the ends of the side; for the parts of a crossed side, those of the whole side
  Vec2 to{};
  SmoothPlace smooth{};
  std::optional<Vec2> center{};  ///< of the circle of a round side, and of one beside a vertex of a smooth curve
  bool is_arc = false;           ///< the curve itself is an arc of this circle
  bool is_point() const { return from == to; }
};

struct OutlineNode {
  Vec2 center{};
  double radius = 0.0;  ///< distance from the outline; exactly 0 at a corner
};

/// All points of an edge are equally far from two features, and nothing of the outline is nearer.
struct OutlineEdge {
  std::array<OutlineNodeSlot, 2> nodes{};
  std::array<OutlineFeatureSlot, 2> features{};
  std::uint32_t region = 0;  ///< number of the connected region
};

struct OutlineGraph {
  Table<OutlineFeatureSlot, OutlineFeature> features{};
  Table<OutlineNodeSlot, OutlineNode> nodes{};
  Table<OutlineEdgeSlot, OutlineEdge> edges{};
  std::uint32_t regions = 0;  ///< regions with an edge or a node
  std::size_t crossings = 0;  ///< points where sides cross
};

/// How much of a graph lies before one of its parts.
struct OutlineGraphPart {
  std::size_t features = 0;
  std::size_t nodes = 0;
  std::size_t edges = 0;
  std::uint32_t regions = 0;
};
inline OutlineGraphPart end_of(const OutlineGraph& graph) {
  return {graph.features.size(), graph.nodes.size(), graph.edges.size(), graph.regions};
}

}  // namespace mes
