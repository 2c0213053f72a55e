// SPDX-License-Identifier: GPL-3.0-or-later
// Prunes a graph from its free ends inwards, for all limits at once.
//
// Leaf edges are removed, the one of the least value first. The *level* of a removed edge is the largest value removed
// up to then. A limit L leaves the edges of level L or more. Only leaves are ever removed, so for every L the rest is a
// deformation retract of the graph: as many components, as many cycles.
//
// Instead of a queue of leaves, all edges are sorted once and visited in this order. A visited edge that is a leaf is
// removed, and with it, one after the other, the edges behind it that become leaves and were visited before. The order
// is the same up to ties, and the level is the value of the visited edge.
#pragma once

#include <cstdint>
#include <utility>
#include <vector>

#include "core/base/slot.h"
#include "core/base/table.h"
#include "core/structures/delaunay/delaunay.h"

namespace mes {

/// Guarantees: the result depends on the graph and the order of the edges alone. A component without cycles keeps one
/// node, its *root*, at every limit.
///
/// Cost: O(edges), plus the sorting, which the caller does.
///
/// Smallest use:
///     AxisPruning pruning;
///     pruning.begin(edge_rows, node_rows);
///     pruning.add(edge, node, other_node);                 // in ascending order of the values
///     pruning.run([](FaceSlot a, FaceSlot b) { return a < b; });
///     if (const EdgeSlot level = pruning.level_of(edge); level == kNoSlot || reaches(level)) keep(edge);
class AxisPruning {
 public:
  void clear();
  void begin(std::size_t edge_rows, std::size_t node_rows);
  void add(EdgeSlot edge, FaceSlot a, FaceSlot b);
  /// `is_better_root(a, b)` tells which end of a last edge stays.
  template <class IsBetterRoot>
  void run(IsBetterRoot is_better_root);

  /// The added edge whose value is the level of this one; kNoSlot if it is never removed.
  EdgeSlot level_of(EdgeSlot edge) const { return level_[edge]; }
  /// True for a node that stays although all its edges are removed. Nodes without edges are not known here.
  bool is_root(FaceSlot node) const { return is_root_.has(node) && is_root_[node] != 0; }
  std::size_t degree(FaceSlot node) const { return end_.has(node) ? end_[node].degree_at_first : 0; }

 private:
  struct Item {
    EdgeSlot edge;
    FaceSlot end[2];
  };
  struct End {
    std::uint32_t degree = 0;
    std::uint32_t items = 0;  ///< xor of the positions of the remaining edges: for a leaf, its edge
    std::uint32_t degree_at_first = 0;
  };
  bool is_leaf(const Item& item) const { return end_[item.end[0]].degree == 1 || end_[item.end[1]].degree == 1; }

  std::vector<Item> items_;  // in ascending order
  Table<FaceSlot, End> end_;
  Table<FaceSlot, std::uint8_t> is_root_;
  Table<EdgeSlot, EdgeSlot> level_;
  std::vector<std::uint8_t> is_gone_;  // by position
};

template <class IsBetterRoot>
void AxisPruning::run(IsBetterRoot is_better_root) {
  is_gone_.assign(items_.size(), 0);
  for (std::uint32_t visited = 0; visited < items_.size(); ++visited) {
    std::uint32_t at = visited;
    while (at <= visited && is_gone_[at] == 0 && is_leaf(items_[at])) {
      const Item& item = items_[at];
      is_gone_[at] = 1;
      level_[item.edge] = items_[visited].edge;
      const bool is_last = end_[item.end[0]].degree == 1 && end_[item.end[1]].degree == 1;
      for (const FaceSlot node : item.end) {
        --end_[node].degree;
        end_[node].items ^= at;
      }
      if (is_last) {
        is_root_[is_better_root(item.end[0], item.end[1]) ? item.end[0] : item.end[1]] = 1;
        break;
      }
      const End& inner = end_[item.end[end_[item.end[0]].degree == 0 ? 1 : 0]];
      if (inner.degree != 1) break;
      at = inner.items;
    }
  }
}

}  // namespace mes
