// SPDX-License-Identifier: GPL-3.0-or-later
// Which row of a table has the largest value, while values change.
#pragma once

#include <algorithm>
#include <bit>
#include <cstddef>
#include <limits>
#include <vector>

namespace mes {

/// A tree of maxima over the rows of a table; rows without a value have minus infinity.
///
/// Cost: `build` O(rows); a change O(log rows) at most, and O(1) for a row that is not the largest nearby, before or
/// after. 16 to 32 bytes a row.
///
/// Smallest use:
///     MaxTree<EdgeSlot> lengths;
///     lengths.build(2, [](EdgeSlot edge) { return edge.index() == 0 ? 3.0 : 1.0; });
///     lengths.set(EdgeSlot(1), 5.0);  // largest() is 5, and row_of_largest() row 1
template <class Row>
class MaxTree {
 public:
  template <class ValueOf>
  void build(std::size_t rows, ValueOf value_of) {
    capacity_ = std::bit_ceil(std::max<std::size_t>(rows, 1));
    most_.assign(2 * capacity_, kNone);
    for (std::size_t row = 0; row < rows; ++row) most_[capacity_ + row] = value_of(Row(row));
    for (std::size_t node = capacity_; node-- > 1;) most_[node] = std::max(most_[2 * node], most_[2 * node + 1]);
  }
  void clear() {
    capacity_ = 0;
    most_.clear();
  }
  /// Not built yet.
  bool is_empty() const { return most_.empty(); }

  /// A row beyond those there are makes room for itself.
  void set(Row row, double value) {
    if (row.index() >= capacity_) grow(row.index() + std::size_t{1});
    std::size_t node = capacity_ + row.index();
    most_[node] = value;
    while (node > 1) {
      node /= 2;
      const double most = std::max(most_[2 * node], most_[2 * node + 1]);
      if (most_[node] == most) return;
      most_[node] = most;
    }
  }

  /// Minus infinity if there is none.
  double largest() const { return is_empty() ? kNone : most_[1]; }
  /// The first of those with the largest value; there must be one.
  Row row_of_largest() const {
    std::size_t node = 1;
    while (node < capacity_) node = 2 * node + (most_[2 * node] == most_[node] ? 0U : 1U);
    return Row(node - capacity_);
  }

 private:
  static constexpr double kNone = -std::numeric_limits<double>::infinity();

  void grow(std::size_t rows) {
    const std::vector<double> before(most_.begin() + static_cast<std::ptrdiff_t>(capacity_), most_.end());
    build(rows, [&before](Row row) { return row.index() < before.size() ? before[row.index()] : kNone; });
  }

  std::size_t capacity_ = 0;
  std::vector<double> most_;  ///< of the rows below each node; the children of node i are 2 i and 2 i + 1
};

}  // namespace mes
