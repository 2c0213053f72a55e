// SPDX-License-Identifier: GPL-3.0-or-later
// Which things belong together after some have been joined.
#pragma once

#include <boost/pending/disjoint_sets.hpp>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "core/base/slot.h"

namespace mes {

/// Disjoint sets of the numbers from 0: Boost's, with their memory.
///
/// Smallest use:
///     DisjointSets sets(3);
///     sets.join(sets.root(0), sets.root(2));
///     const bool are_together = sets.root(0) == sets.root(2);
///
/// Cost: constant a call for all practical purposes (union by rank, path compression). Threads: none.
class DisjointSets {
 public:
  explicit DisjointSets(std::size_t count = 0) { reset(count); }

  /// Every number below `count` is a set of its own.
  void reset(std::size_t count) {
    parent_.clear();
    rank_.clear();
    grow(count);
  }
  /// Numbers below `count` that are new are sets of their own.
  void grow(std::size_t count) {
    if (count <= parent_.size()) return;
    rank_.resize(count, 0);
    for (auto x = static_cast<Slot>(parent_.size()); x < count; ++x) parent_.push_back(x);
  }

  Slot root(Slot x) { return sets().find_set(x); }
  /// Of two roots; returns the root of what is now one set, which is either of them.
  Slot join(Slot a, Slot b) {
    if (a != b) sets().link(a, b);
    return parent_[a] == a ? a : b;
  }

 private:
  boost::disjoint_sets<std::uint8_t*, Slot*> sets() { return {rank_.data(), parent_.data()}; }

  std::vector<Slot> parent_;
  std::vector<std::uint8_t> rank_;
};

}  // namespace mes
