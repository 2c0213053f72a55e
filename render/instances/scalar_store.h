// SPDX-License-Identifier: GPL-3.0-or-later
// The scalars of a set of instances, and the range of their finite ones.
//
// Guarantees: after `settle`, `range` is that of the finite values stored.
//
// Smallest use:
//     store.resize(count);
//     for (...) store.set(instance, scalar);
//     store.settle();
//     use(store.range());
//
// Cost: O(1) for `set` and `range`, O(k log n) for `settle` after k changes, by a tree of blocks of 32 values. Threads:
// a value; one at a time.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "render/instances/colormap.h"

namespace mes::render {

class ScalarStore {
 public:
  std::size_t size() const { return values_.size(); }
  std::span<const double> values() const { return values_; }
  /// New values are NaN until they are set.
  void resize(std::size_t size);
  void set(std::size_t index, double value);
  void settle();
  ScalarRange range() const { return levels_.empty() || levels_.back().empty() ? ScalarRange{} : levels_.back()[0]; }
  void clear();

 private:
  void mark(std::size_t block);
  ScalarRange of_block(std::size_t level, std::size_t block) const;

  std::vector<double> values_;
  std::vector<std::vector<ScalarRange>> levels_;  // [0]: ranges of blocks of values; the last level has one range
  std::vector<std::size_t> changed_;              // changed blocks of values
};

}  // namespace mes::render
