// SPDX-License-Identifier: GPL-3.0-or-later
// Things in the plane by their boxes: which of them are near a place.
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <numeric>
#include <span>
#include <vector>

#include "core/base/box2.h"

namespace mes {

/// A tree over boxes that do not change; boxes may reach to infinity. Items are the positions in the list it was built
/// of.
///
/// What it guarantees: a visit leaves an item out only if its box is farther away than asked for, by more than what
/// rounding does to distances at such coordinates. So what is found does not depend on the tree.
///
/// Cost: building O(n log n), some 0.1 us an item; a visit O(log n + visited). Threads: visits may run side by side.
///
/// Smallest use:
///     BoxTree tree;
///     tree.build(boxes);
///     double nearest = std::numeric_limits<double>::infinity();  // squared
///     tree.visit_near(p, nearest, [&](std::uint32_t item) { nearest = std::min(nearest, squared_to(item, p)); });
class BoxTree {
 public:
  void build(std::span<const Box2> boxes);
  void clear() {
    items_.clear();
    nodes_.clear();
  }
  bool is_empty() const { return nodes_.empty(); }

  /// The items in the order in which visits meet those that are near to each other.
  std::span<const std::uint32_t> order() const { return items_; }
  /// From now on an item is its position in `order`: of a list that was put into that order, neighbours are visited one
  /// after the other, which the caches like.
  void number_by_order() { std::iota(items_.begin(), items_.end(), std::uint32_t{0}); }

  /// Calls `visit(item)` for items the square of whose box's distance from `p` is not above `bound`, which `visit` may
  /// lower; near ones tend to come first.
  template <class Visit>
  void visit_near(Vec2 p, const double& bound, Visit visit) const;
  /// Calls `visit(item)` for all items below nodes whose boxes `may_hold` what is looked for.
  template <class MayHold, class Visit>
  void visit_where(MayHold may_hold, Visit visit) const;

 private:
  static constexpr std::size_t kLeaf = 8;
  struct Node {
    Box2 box;
    std::uint32_t first = 0;  ///< child, or item of a leaf
    std::uint16_t count = 0;
    bool is_leaf = false;
  };
  /// A lower bound of the squared distance, whatever rounding did; `slack` is that of the coordinates of p.
  static double squared_below(const Box2& box, Vec2 p, double slack) {
    const auto gap = [slack](double below, double above) {
      const double outside = std::max({below, above, 0.0});
      return std::max(0.0, outside - 0x1p-47 * outside - slack);
    };
    const double dx = gap(box.low.x - p.x, p.x - box.high.x);
    const double dy = gap(box.low.y - p.y, p.y - box.high.y);
    return dx * dx + dy * dy;
  }

  std::vector<std::uint32_t> items_;
  std::vector<Node> nodes_;  ///< the root is the last
};

inline void BoxTree::build(std::span<const Box2> boxes) {
  clear();
  if (boxes.empty()) return;
  // Along a Z curve through the finite corners.
  Box2 extent;
  const auto place = [](const Box2& box) {
    const auto middle = [](double low, double high) {
      if (!std::isfinite(low)) return std::isfinite(high) ? high : 0.0;
      return std::isfinite(high) ? 0.5 * low + 0.5 * high : low;
    };
    return Vec2{middle(box.low.x, box.high.x), middle(box.low.y, box.high.y)};
  };
  // A few boxes very far away would leave all others in one cell: they count as at the rim of the others.
  std::vector<double> reach;
  reach.reserve(boxes.size());
  for (const Box2& box : boxes) {
    const Vec2 at = place(box);
    reach.push_back(std::max(std::abs(at.x), std::abs(at.y)));
  }
  const auto most = reach.begin() + static_cast<std::ptrdiff_t>(reach.size() - 1 - reach.size() / 16);
  std::ranges::nth_element(reach, most);
  const double rim = 2.0 * *most;
  const auto inside = [rim](double x) { return std::clamp(x, -rim, rim); };
  for (const Box2& box : boxes) extent.add(Vec2{inside(place(box).x), inside(place(box).y)});
  const double size = std::max(extent.width(), extent.height());
  const auto spread = [](std::uint64_t x) {
    x = (x | (x << 16U)) & 0x0000ffff0000ffffU;
    x = (x | (x << 8U)) & 0x00ff00ff00ff00ffU;
    x = (x | (x << 4U)) & 0x0f0f0f0f0f0f0f0fU;
    x = (x | (x << 2U)) & 0x3333333333333333U;
    return (x | (x << 1U)) & 0x5555555555555555U;
  };
  const auto cell = [&](double x, double low) {
    const double share = size > 0.0 ? (inside(x) - low) / size : 0.0;
    return static_cast<std::uint64_t>(share * 4294967295.0);
  };
  std::vector<std::pair<std::uint64_t, std::uint32_t>> keys;
  keys.reserve(boxes.size());
  for (std::uint32_t i = 0; i < boxes.size(); ++i) {
    const Vec2 at = place(boxes[i]);
    keys.emplace_back(spread(cell(at.x, extent.low.x)) | (spread(cell(at.y, extent.low.y)) << 1U), i);
  }
  std::ranges::sort(keys);
  items_.reserve(boxes.size());
  for (const auto& [key, item] : keys) items_.push_back(item);
  const auto add_level = [this](std::size_t count, std::size_t group, bool is_leaf, auto box_of) {
    const std::size_t begin = nodes_.size();
    for (std::size_t first = 0; first < count; first += group) {
      Node node;
      node.first = static_cast<std::uint32_t>(first);
      node.count = static_cast<std::uint16_t>(std::min(group, count - first));
      node.is_leaf = is_leaf;
      for (std::size_t i = first; i < first + node.count; ++i) node.box.add(box_of(i));
      nodes_.push_back(node);
    }
    return begin;
  };
  std::size_t begin = add_level(items_.size(), kLeaf, true, [&](std::size_t i) { return boxes[items_[i]]; });
  while (nodes_.size() - begin > 1) {
    const std::size_t below = begin;
    begin = add_level(nodes_.size() - below, 4, false, [&](std::size_t i) { return nodes_[below + i].box; });
    for (std::size_t i = begin; i < nodes_.size(); ++i) nodes_[i].first += static_cast<std::uint32_t>(below);
  }
}

template <class Visit>
void BoxTree::visit_near(Vec2 p, const double& bound, Visit visit) const {
  if (nodes_.empty()) return;
  const double slack = 0x1p-47 * std::max(std::abs(p.x), std::abs(p.y));
  struct Waiting {
    double squared;
    std::uint32_t node;
  };
  std::array<Waiting, 64> stack;  // four children a level, sixteen levels
  std::size_t height = 0;
  stack[height++] = {squared_below(nodes_.back().box, p, slack), static_cast<std::uint32_t>(nodes_.size() - 1)};
  while (height != 0) {
    const Waiting next = stack[--height];
    if (next.squared > bound) continue;
    const Node& node = nodes_[next.node];
    if (node.is_leaf) {
      for (std::uint32_t i = node.first; i < node.first + node.count; ++i) visit(items_[i]);
      continue;
    }
    const std::size_t begin = height;
    for (std::uint32_t child = node.first; child < node.first + node.count; ++child) {
      const double squared = squared_below(nodes_[child].box, p, slack);
      if (!(squared <= bound)) continue;
      std::size_t at = height++;
      for (; at > begin && stack[at - 1].squared < squared; --at) stack[at] = stack[at - 1];
      stack[at] = {squared, child};
    }
  }
}

template <class MayHold, class Visit>
void BoxTree::visit_where(MayHold may_hold, Visit visit) const {
  if (nodes_.empty()) return;
  std::array<std::uint32_t, 64> stack;
  std::size_t height = 0;
  stack[height++] = static_cast<std::uint32_t>(nodes_.size() - 1);
  while (height != 0) {
    const Node& node = nodes_[stack[--height]];
    if (!may_hold(node.box)) continue;
    for (std::uint32_t i = node.first; i < node.first + node.count; ++i) {
      if (node.is_leaf)
        visit(items_[i]);
      else
        stack[height++] = i;
    }
  }
}

}  // namespace mes
