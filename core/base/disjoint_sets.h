// SPDX-License-Identifier: GPL-3.0-or-later
// Sets of rows that merge as rows are joined.
#pragma once

#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "core/base/ids.h"

namespace mes {

/// Disjoint sets of the rows of a table.
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
    RowNumber at = x.index();
    while (parent_[at] != at) at = parent_[at];
    for (RowNumber next = x.index(); next != at;) next = std::exchange(parent_[next], at);
    return Row(at);
  }
  /// Joins the sets of two roots; returns the root of the joint set, which is one of the two.
  Row join(Row a, Row b) {
    if (a == b) return a;
    if (rank_[a.index()] > rank_[b.index()]) std::swap(a, b);
    parent_[a.index()] = b.index();
    if (rank_[a.index()] == rank_[b.index()]) ++rank_[b.index()];
    return b;
  }

 private:
  std::vector<RowNumber> parent_;
  std::vector<std::uint8_t> rank_;  // at least the length of the longest path to the root
};

}  // namespace mes
