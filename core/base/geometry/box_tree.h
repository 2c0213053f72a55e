// SPDX-License-Identifier: GPL-3.0-or-later
// A tree over the bounding boxes of items in the plane; it finds items near a point, while items are added and removed.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <span>
#include <utility>
#include <vector>

#include "core/base/geometry/box2.h"
#include "core/base/jobs/parallel.h"
#include "core/base/radix_sort.h"

namespace mes {

/// An order that keeps near boxes mostly together: along a Z curve through their centres.
///
/// Cost: O(n), some 15 ns a box.
inline std::vector<std::uint32_t> order_along_z_curve(std::span<const Box2> boxes) {
  if (boxes.empty()) return {};
  const auto place = [](const Box2& box) {
    const auto middle = [](double low, double high) {
      if (!std::isfinite(low)) return std::isfinite(high) ? high : 0.0;
      return std::isfinite(high) ? 0.5 * low + 0.5 * high : low;
    };
    return Vec2{middle(box.low.x, box.high.x), middle(box.low.y, box.high.y)};
  };
  // A few boxes very far away would leave all others in one cell, so they are clamped to the rim of the others. The rim
  // is estimated from every 16th box.
  std::vector<double> reach;
  for (std::size_t i = 0; i < boxes.size(); i += 16) {
    const Vec2 at = place(boxes[i]);
    reach.push_back(std::max(std::abs(at.x), std::abs(at.y)));
  }
  const auto most = reach.begin() + static_cast<std::ptrdiff_t>(reach.size() - 1 - reach.size() / 16);
  std::ranges::nth_element(reach, most);
  const double rim = 2.0 * *most;
  const auto inside = [rim](double x) { return std::clamp(x, -rim, rim); };
  std::vector<Box2> extents(chunk_count(boxes.size()));
  parallel_for(boxes.size(), [&](std::size_t begin, std::size_t end, std::size_t chunk) {
    for (std::size_t i = begin; i < end; ++i) {
      const Vec2 at = place(boxes[i]);
      extents[chunk].add(Vec2{inside(at.x), inside(at.y)});
    }
  });
  Box2 extent;
  for (const Box2& one : extents) extent.add(one);
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
  std::vector<RadixKey> keys(boxes.size());
  parallel_for(boxes.size(), [&](std::size_t begin, std::size_t end, std::size_t) {
    for (std::size_t i = begin; i < end; ++i) {
      const Vec2 at = place(boxes[i]);
      keys[i] = {spread(cell(at.x, extent.low.x)) | (spread(cell(at.y, extent.low.y)) << 1U),
                 static_cast<std::uint32_t>(i)};
    }
  });
  radix_sort(keys);
  std::vector<std::uint32_t> out(keys.size());
  for (std::size_t i = 0; i < keys.size(); ++i) out[i] = keys[i].item;
  return out;
}

/// The bounds of an item, as the tree stores them.
struct TreeBounds {
  Box2 box;            ///< may reach to infinity
  double reach = 0.0;  ///< distance that the item reaches beyond its box; only `visit_where` uses it

  void add(const TreeBounds& other) {
    box.add(other.box);
    reach = std::max(reach, other.reach);
  }
};

/// A tree over items with bounds.
///
/// Guarantees:
///  1. `visit_near` skips an item only if its bounds prove that it is farther away than asked for, with a margin for
///     the rounding of distances at such coordinates. So the result does not depend on the tree.
///  2. The index that `moved` reports for an item is valid until `moved` reports another one, or the item is removed.
///
/// Boxes of nodes grow on insertion and do not shrink on removal; `is_worn` says when to rebuild.
///
/// Cost: building O(n log n), some 30 ns an item; a visit O(log n + visited), some 10 ns a node; inserting and removing
/// O(log n). Threads: visits may run side by side.
///
/// Smallest use:
///     BoxTree<Vec2> tree;
///     tree.build(places, [](Vec2 at) { return TreeBounds{{at, at}}; }, [](Vec2, std::uint32_t) {});
///     double nearest = std::numeric_limits<double>::infinity();  // squared
///     tree.visit_near(p, nearest, [&](Vec2 at) { nearest = std::min(nearest, dot(at - p, at - p)); });
template <class Item>
class BoxTree {
 public:
  /// Calls `moved(item, place)` with the index of each item, on several threads. `bounds_of(item)` returns its bounds.
  template <class BoundsOf, class Moved>
  void build(std::span<const Item> items, BoundsOf bounds_of, Moved moved);
  void clear() {
    items_.clear();
    counts_.clear();
    nodes_.clear();
    root_ = kNone;
    size_ = built_ = come_ = 0;
    is_deep_ = false;
  }
  bool is_empty() const { return size_ == 0; }
  std::size_t size() const { return size_; }
  bool is_worn() const { return is_deep_ || come_ > 256 + built_ / 2; }
  const Item& at(std::uint32_t place) const { return items_[place]; }

  /// Calls `moved` for the new item, and for others whose index changes.
  template <class BoundsOf, class Moved>
  void insert(const Item& item, BoundsOf bounds_of, Moved moved);
  template <class Moved>
  void remove(std::uint32_t place, Moved moved);

  /// Calls `visit(item)` for each item whose bounds allow a squared distance from `p` of at most `bound`; `visit` may
  /// lower `bound`. Near items tend to come first.
  template <class Visit>
  void visit_near(Vec2 p, const double& bound, Visit visit) const;
  /// Calls `visit(item)` for all items below nodes for which `may_hold(box, reach)` is true. A node passes the union of
  /// its boxes and the largest of its reaches.
  template <class MayHold, class Visit>
  void visit_where(MayHold may_hold, Visit visit) const;

 private:
  static constexpr double kInfinity = std::numeric_limits<double>::infinity();
  static constexpr std::uint32_t kNone = 0xffffffffU;
  static constexpr std::uint32_t kLeafBit = 0x80000000U;
  static constexpr std::uint32_t kLeaf = 8;
  static constexpr std::uint32_t kFilled = 6;  ///< items in a leaf after `build`
  static constexpr std::size_t kDeepest = 40;
  static constexpr int kChildren = 4;

  /// The children are stored side by side, so that a few instructions look at all of them.
  struct Node {
    std::array<double, kChildren> low_x, low_y, high_x, high_y, reach;
    std::array<std::uint32_t, kChildren> child;

    Node() {
      for (std::size_t i = 0; i < kChildren; ++i) set(i, kNone, TreeBounds{});
    }
    Box2 box(std::size_t i) const { return {{low_x[i], low_y[i]}, {high_x[i], high_y[i]}}; }
    void set(std::size_t i, std::uint32_t to, const TreeBounds& bounds) {
      child[i] = to;
      low_x[i] = bounds.box.low.x;
      low_y[i] = bounds.box.low.y;
      high_x[i] = bounds.box.high.x;
      high_y[i] = bounds.box.high.y;
      reach[i] = bounds.reach;
    }
    void grow(std::size_t i, const TreeBounds& by) {
      TreeBounds all{box(i), reach[i]};
      all.add(by);
      set(i, child[i], all);
    }
  };
  std::uint32_t new_leaf() {
    counts_.push_back(0);
    items_.resize(items_.size() + kLeaf);
    return static_cast<std::uint32_t>(counts_.size() - 1);
  }
  template <class Moved>
  void put(std::uint32_t leaf, const Item& item, Moved& moved) {
    const std::uint32_t place = leaf * kLeaf + counts_[leaf]++;
    items_[place] = item;
    moved(items_[place], place);
  }
  template <class BoundsOf>
  TreeBounds bounds_of_leaf(std::uint32_t leaf, BoundsOf& bounds_of) const {
    TreeBounds out;
    for (std::uint32_t i = 0; i < counts_[leaf]; ++i) out.add(bounds_of(items_[leaf * kLeaf + i]));
    return out;
  }

  std::vector<Item> items_;  ///< `kLeaf` slots in each leaf
  std::vector<std::uint8_t> counts_;
  std::vector<Node> nodes_;
  std::uint32_t root_ = kNone;  ///< index of a node, or index of a leaf with `kLeafBit`
  std::size_t size_ = 0;
  std::size_t built_ = 0;
  std::size_t come_ = 0;
  bool is_deep_ = false;
};

template <class Item>
template <class BoundsOf, class Moved>
void BoxTree<Item>::build(std::span<const Item> items, BoundsOf bounds_of, Moved moved) {
  clear();
  if (items.empty()) return;
  std::vector<TreeBounds> bounds(items.size());
  parallel_for(items.size(), [&](std::size_t begin, std::size_t end, std::size_t) {
    for (std::size_t i = begin; i < end; ++i) bounds[i] = bounds_of(items[i]);
  });
  std::vector<Box2> boxes(items.size());
  for (std::size_t i = 0; i < boxes.size(); ++i) boxes[i] = bounds[i].box;
  const std::vector<std::uint32_t> order = order_along_z_curve(boxes);
  const std::size_t leaves = (items.size() + kFilled - 1) / kFilled;
  items_.resize(leaves * kLeaf);
  counts_.resize(leaves);
  std::vector<TreeBounds> below(leaves);
  parallel_for(leaves, [&](std::size_t begin, std::size_t end, std::size_t) {
    for (std::size_t leaf = begin; leaf < end; ++leaf) {
      const std::size_t first = leaf * kFilled;
      for (std::size_t i = first; i < std::min(items.size(), first + kFilled); ++i) {
        const auto place = static_cast<std::uint32_t>(leaf * kLeaf + counts_[leaf]++);
        items_[place] = items[order[i]];
        moved(items_[place], place);
        below[leaf].add(bounds[order[i]]);
      }
    }
  });
  // Each level is a run of nodes over the level before.
  std::uint32_t first_below = kLeafBit;
  while (below.size() > 1) {
    const auto first = static_cast<std::uint32_t>(nodes_.size());
    std::vector<TreeBounds> level((below.size() + kChildren - 1) / kChildren);
    nodes_.resize(first + level.size());
    for (std::size_t i = 0; i < below.size(); ++i) {
      nodes_[first + i / kChildren].set(i % kChildren, first_below + static_cast<std::uint32_t>(i), below[i]);
      level[i / kChildren].add(below[i]);
    }
    first_below = first;
    below = std::move(level);
  }
  root_ = first_below;
  size_ = built_ = items.size();  // last, so that the tree is empty if memory runs out on the way
}

template <class Item>
template <class BoundsOf, class Moved>
void BoxTree<Item>::insert(const Item& item, BoundsOf bounds_of, Moved moved) {
  ++size_;
  ++come_;
  if (root_ == kNone) root_ = kLeafBit | new_leaf();
  const TreeBounds bounds = bounds_of(item);
  const Box2& box = bounds.box;
  // Descend to the child whose box grows least.
  const auto growth = [&box](const Node& node, std::size_t i) {
    return std::max(0.0, node.low_x[i] - box.low.x) + std::max(0.0, node.low_y[i] - box.low.y) +
           std::max(0.0, box.high.x - node.high_x[i]) + std::max(0.0, box.high.y - node.high_y[i]);
  };
  std::uint32_t at = root_;
  std::uint32_t parent = kNone;
  std::size_t way = 0;  // index of the child in `parent`
  std::size_t depth = 0;
  while ((at & kLeafBit) == 0) {
    Node& node = nodes_[at];
    std::size_t best = 0;
    for (std::size_t i = 1; i < kChildren; ++i)
      if (node.child[i] != kNone && growth(node, i) < growth(node, best)) best = i;
    node.grow(best, bounds);
    parent = at;
    way = best;
    at = node.child[best];
    ++depth;
  }
  is_deep_ = is_deep_ || depth >= kDeepest;
  const std::uint32_t leaf = at & ~kLeafBit;
  if (counts_[leaf] < kLeaf) return put(leaf, item, moved);
  // Split a full leaf in two.
  std::array<Item, kLeaf + 1> all;
  std::copy_n(items_.begin() + leaf * kLeaf, kLeaf, all.begin());
  all.back() = item;
  Box2 whole;
  for (const Item& one : all) whole.add(bounds_of(one).box);
  const bool by_x = whole.width() >= whole.height();
  std::ranges::sort(all, {}, [&](const Item& one) {
    const Vec2 low = bounds_of(one).box.low;
    return by_x ? low.x : low.y;
  });
  const std::uint32_t other = new_leaf();
  counts_[leaf] = 0;
  for (std::size_t i = 0; i < all.size(); ++i) put(i < all.size() / 2 ? leaf : other, all[i], moved);
  const TreeBounds mine = bounds_of_leaf(leaf, bounds_of);
  const TreeBounds its = bounds_of_leaf(other, bounds_of);
  if (parent != kNone) {
    Node& node = nodes_[parent];
    const auto free = std::ranges::find(node.child, kNone);
    if (free != node.child.end()) {
      node.set(way, kLeafBit | leaf, mine);
      node.set(static_cast<std::size_t>(free - node.child.begin()), kLeafBit | other, its);
      return;
    }
  }
  const auto between = static_cast<std::uint32_t>(nodes_.size());
  nodes_.emplace_back();
  nodes_.back().set(0, kLeafBit | leaf, mine);
  nodes_.back().set(1, kLeafBit | other, its);
  (parent == kNone ? root_ : nodes_[parent].child[way]) = between;
}

template <class Item>
template <class Moved>
void BoxTree<Item>::remove(std::uint32_t place, Moved moved) {
  --size_;
  const std::uint32_t leaf = place / kLeaf;
  const std::uint32_t last = leaf * kLeaf + --counts_[leaf];
  if (place == last) return;
  items_[place] = items_[last];
  moved(items_[place], place);
}

template <class Item>
template <class Visit>
void BoxTree<Item>::visit_near(Vec2 p, const double& bound, Visit visit) const {
  if (root_ == kNone) return;
  const double slack = 0x1p-47 * std::max(std::abs(p.x), std::abs(p.y));
  struct Waiting {
    double squared;
    std::uint32_t node;
  };
  std::array<Waiting, (kDeepest + 20) * kChildren> stack;
  std::size_t height = 0;
  stack[height++] = {0.0, root_};
  while (height != 0) {
    const Waiting next = stack[--height];
    if (next.squared > bound) continue;
    if ((next.node & kLeafBit) != 0) {
      const std::uint32_t leaf = next.node & ~kLeafBit;
      const Item* const first = items_.data() + leaf * kLeaf;
      for (std::uint32_t i = 0; i < counts_[leaf]; ++i) visit(first[i]);
      continue;
    }
    // Lower bounds of the squared distances, whatever the rounding.
    const Node& node = nodes_[next.node];
    std::array<double, kChildren> squared;
    for (std::size_t i = 0; i < kChildren; ++i) {
      const double below_x = node.low_x[i] - p.x;
      const double above_x = p.x - node.high_x[i];
      const double below_y = node.low_y[i] - p.y;
      const double above_y = p.y - node.high_y[i];
      double dx = below_x > above_x ? below_x : above_x;
      double dy = below_y > above_y ? below_y : above_y;
      dx -= 0x1p-47 * dx + slack;
      dy -= 0x1p-47 * dy + slack;
      dx = dx > 0.0 ? dx : 0.0;
      dy = dy > 0.0 ? dy : 0.0;
      squared[i] = dx * dx + dy * dy;
    }
    const std::size_t begin = height;
    for (std::size_t i = 0; i < kChildren; ++i) {
      if (!(squared[i] <= bound) || node.child[i] == kNone) continue;
      std::size_t at = height++;
      for (; at > begin && stack[at - 1].squared < squared[i]; --at) stack[at] = stack[at - 1];
      stack[at] = {squared[i], node.child[i]};
    }
  }
}

template <class Item>
template <class MayHold, class Visit>
void BoxTree<Item>::visit_where(MayHold may_hold, Visit visit) const {
  if (root_ == kNone) return;
  std::array<std::uint32_t, (kDeepest + 20) * kChildren> stack;
  std::size_t height = 0;
  stack[height++] = root_;
  while (height != 0) {
    const std::uint32_t next = stack[--height];
    if ((next & kLeafBit) != 0) {
      const std::uint32_t leaf = next & ~kLeafBit;
      for (std::uint32_t i = 0; i < counts_[leaf]; ++i) visit(items_[leaf * kLeaf + i]);
      continue;
    }
    const Node& node = nodes_[next];
    for (std::size_t i = 0; i < kChildren; ++i)
      if (node.child[i] != kNone && may_hold(node.box(i), node.reach[i])) stack[height++] = node.child[i];
  }
}

}  // namespace mes
