// SPDX-License-Identifier: GPL-3.0-or-later
// Finds long thin items near a point, whatever their directions. Private to core/curves.
//
// The box of a slanted line is wide, so among nested or parallel slanted lines nearly every box holds a given point.
// The nodes of this tree hold lines whose ends are near to each other. Such lines run alike, so a node is bounded by a
// thin slab along them besides its box.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "core/base/geometry/box2.h"

namespace mes {

/// An item within the convex hull of its points.
struct SlabItem {
  std::array<Vec2, 4> hull{};  ///< ends of its chord first and second; the others may repeat an end
  std::uint32_t item = 0;
};

/// Cost: building O(n log n); a visit O(log n + visited) where few items cross. Threads: visits may run side by side.
class SlabTree {
 public:
  explicit SlabTree(std::vector<SlabItem> items) : items_(std::move(items)) {
    for (SlabItem& one : items_)
      if (lexicographically_less(one.hull[1], one.hull[0])) std::swap(one.hull[0], one.hull[1]);
    nodes_.reserve(items_.size());
    if (!items_.empty()) build(0, items_.size());
  }

  /// Calls `visit(item)` for all items within `reach` of `p`, and for others, while it returns true. An item may be
  /// visited several times if it was given so. Returns the number of nodes and items that it compared.
  template <class Visit>
  std::size_t visit_near(Vec2 p, double reach, Visit visit) const {
    std::size_t compared = 0;
    for (std::size_t at = 0; at < nodes_.size();) {
      ++compared;
      const Node& node = nodes_[at];
      const double across = dot(node.normal, p - node.origin);
      const bool may_hold = node.box.low.x - reach <= p.x && p.x <= node.box.high.x + reach &&
                            node.box.low.y - reach <= p.y && p.y <= node.box.high.y + reach &&
                            node.low - reach <= across && across <= node.high + reach;
      if (may_hold)
        for (std::uint32_t i = node.first; i < node.end; ++i, ++compared)
          if (!visit(items_[i].item)) return compared;
      at = may_hold ? at + 1 : node.next;
    }
    return compared;
  }

 private:
  static constexpr std::size_t kLeaf = 4;

  struct Node {
    Box2 box{};
    Vec2 origin{};
    Vec2 normal{};
    double low = 0.0;  ///< across the slab, from the origin
    double high = 0.0;
    std::uint32_t first = 0;  ///< items of a leaf
    std::uint32_t end = 0;
    std::uint32_t next = 0;  ///< the node after all nodes below; the one below is the next in memory
  };

  void build(std::size_t first, std::size_t end) {
    const std::size_t at = nodes_.size();
    nodes_.push_back(bounds_of_items(std::span(items_).subspan(first, end - first)));
    if (end - first <= kLeaf) {
      nodes_[at].first = static_cast<std::uint32_t>(first);
      nodes_[at].end = static_cast<std::uint32_t>(end);
    } else {
      // The ends are a point in four dimensions. Halves it where it is widest.
      std::array<Box2, 2> ends;
      for (std::size_t i = first; i < end; ++i)
        for (std::size_t k = 0; k < 2; ++k) ends[k].add(items_[i].hull[k]);
      const std::array<double, 4> widths{ends[0].width(), ends[0].height(), ends[1].width(), ends[1].height()};
      const auto widest = static_cast<std::size_t>(std::ranges::max_element(widths) - widths.begin());
      const auto key = [widest](const SlabItem& one) {
        const Vec2 p = one.hull[widest / 2];
        return widest % 2 == 0 ? p.x : p.y;
      };
      const std::size_t middle = first + (end - first) / 2;
      const auto begin = items_.begin();
      std::ranges::nth_element(begin + static_cast<std::ptrdiff_t>(first),
                               begin + static_cast<std::ptrdiff_t>(middle), begin + static_cast<std::ptrdiff_t>(end),
                               {}, key);
      build(first, middle);
      build(middle, end);
    }
    nodes_[at].next = static_cast<std::uint32_t>(nodes_.size());
  }

  static Node bounds_of_items(std::span<const SlabItem> items) {
    Node out{.origin = items.front().hull[0]};
    Vec2 along;
    for (const SlabItem& one : items) {
      along = along + (one.hull[1] - one.hull[0]);
      for (const Vec2 p : one.hull) out.box.add(p);
    }
    const double size = length(along);
    if (size > 0.0) out.normal = perpendicular({along.x / size, along.y / size});
    for (const SlabItem& one : items) {
      for (const Vec2 p : one.hull) {
        const double across = dot(out.normal, p - out.origin);
        out.low = std::min(out.low, across);
        out.high = std::max(out.high, across);
      }
    }
    return out;
  }

  std::vector<SlabItem> items_;
  std::vector<Node> nodes_;
};

}  // namespace mes
