// SPDX-License-Identifier: GPL-3.0-or-later
// Sets of rows that merge as rows are joined.
#pragma once

#include <cstddef>
#include <cstdint>
#include <type_traits>
#include <utility>
#include <vector>

#include "core/base/ids.h"

namespace mes {

/// Disjoint sets of the rows of a table, or of the numbers below a count.
///
/// Smallest use:
///     DisjointSets<FaceSlot> sets(count);
///     sets.join(sets.root(a), sets.root(b));
///     const bool are_together = sets.root(a) == sets.root(b);
///
/// Cost: practically constant for each call (union by rank, path compression). Threads: none.
template <class Row>
class DisjointSets {
 public:
  explicit DisjointSets(std::size_t count = 0) { reset(count); }

  /// Makes every row below `count` a set of its own.
  void reset(std::size_t count) {
    parent_.clear();
    rank_.clear();
    grow(count);
  }
  /// Makes each new row below `count` a set of its own.
  void grow(std::size_t count) {
    if (count <= parent_.size()) return;
    rank_.resize(count, 0);
    for (auto x = static_cast<RowNumber>(parent_.size()); x < count; ++x) parent_.push_back(x);
  }

  Row root(Row x) {
    RowNumber at = number(x);
    while (parent_[at] != at) at = parent_[at];
    for (RowNumber next = number(x); next != at;) next = std::exchange(parent_[next], at);
    return Row(at);
  }
  /// Joins the sets of two roots; returns the root of the joint set, which is one of the two.
  Row join(Row a, Row b) {
    if (a == b) return a;
    if (rank_[number(a)] > rank_[number(b)]) std::swap(a, b);
    parent_[number(a)] = number(b);
    if (rank_[number(a)] == rank_[number(b)]) ++rank_[number(b)];
    return b;
  }

 private:
  static RowNumber number(Row x) {
    if constexpr (std::is_same_v<Row, RowNumber>) {
      return x;
    } else {
      return x.index();
    }
  }

  std::vector<RowNumber> parent_;
  std::vector<std::uint8_t> rank_;  // at least the length of the longest path to the root
};

}  // namespace mes
