// SPDX-License-Identifier: GPL-3.0-or-later
// Which row of a table has the largest value, while values change.
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

namespace mes {

/// Of rows with one value, the one with the smaller index is first.
struct ByRow {
  template <class Row>
  bool operator()(Row a, Row b) const {
    return a.index() < b.index();
  }
};

/// A tree of maxima over the rows of a table; rows without a value have minus infinity.
///
/// `is_first(a, b)`, an order of rows, chooses among those with the largest value; it is asked only of rows with one value
/// other than minus infinity, and must be the same in all calls. It may read what rows are made of: rows that change
/// together are set together, so that it meets none as it was before.
/// Cost: `build` O(rows); a change O(log rows) at most, and O(1) for a row that is not the largest nearby, before or
/// after. 12 to 24 bytes a row.
///
/// Smallest use:
///     MaxTree<EdgeSlot> lengths;
///     lengths.build(2, [](EdgeSlot edge) { return edge.index() == 0 ? 3.0 : 1.0; });
///     lengths.set(EdgeSlot(1), 5.0);  // largest() is 5, and row_of_largest() row 1
template <class Row>
class MaxTree {
 public:
  template <class ValueOf, class IsFirst = ByRow>
  void build(std::size_t rows, ValueOf value_of, IsFirst is_first = {}) {
    capacity_ = std::bit_ceil(std::max<std::size_t>(rows, 1));
    values_.assign(capacity_, kNone);
    for (std::size_t row = 0; row < rows; ++row) values_[row] = value_of(Row(row));
    winners_.resize(capacity_);
    for (std::size_t node = capacity_; node-- > 1;) winners_[node] = winner_below(node, is_first);
  }
  void clear() {
    capacity_ = 0;
    values_.clear();
    winners_.clear();
  }
  /// Not built yet.
  bool is_empty() const { return values_.empty(); }

  /// A row beyond those there are makes room for itself.
  template <class IsFirst = ByRow>
  void set(Row row, double value, IsFirst is_first = {}) {
    set_all(
        std::array{row}, [value](Row) { return value; }, is_first);
  }
  /// The rows have other values, or what `is_first` reads of them is another, or both.
  template <class Rows, class ValueOf, class IsFirst = ByRow>
  void set_all(const Rows& rows, ValueOf value_of, IsFirst is_first = {}) {
    std::size_t end = 0;
    for (const Row row : rows) end = std::max(end, row.index() + std::size_t{1});
    const bool has_room = end <= capacity_;
    if (!has_room) values_.resize(std::bit_ceil(end), kNone);
    for (const Row row : rows) values_[row.index()] = value_of(row);
    if (has_room) {
      for (const Row row : rows) play(row, is_first);
    } else {
      const std::vector<double> values = std::move(values_);
      build(
          values.size(), [&values](Row row) { return values[row.index()]; }, is_first);
    }
  }

  /// Minus infinity if there is none.
  double largest() const { return is_empty() ? kNone : values_[row_of_largest().index()]; }
  /// The first of those with the largest value; there must be one.
  Row row_of_largest() const { return Row(capacity_ == 1 ? 0 : winners_[1]); }

 private:
  static constexpr double kNone = -std::numeric_limits<double>::infinity();

  template <class IsFirst>
  std::uint32_t winner_below(std::size_t node, IsFirst is_first) const {
    const auto winner = [this](std::size_t below) {
      return below < capacity_ ? winners_[below] : static_cast<std::uint32_t>(below - capacity_);
    };
    const std::uint32_t a = winner(2 * node);
    const std::uint32_t b = winner(2 * node + 1);
    if (values_[a] != values_[b]) return values_[a] > values_[b] ? a : b;
    return values_[a] == kNone || is_first(Row(a), Row(b)) ? a : b;
  }

  /// Nodes on the way of other rows may still have winners of before, which have their new values.
  template <class IsFirst>
  void play(Row row, IsFirst is_first) {
    for (std::size_t node = (capacity_ + row.index()) / 2; node > 0; node /= 2) {
      const std::uint32_t before = winners_[node];
      winners_[node] = winner_below(node, is_first);
      // Farther up this row does not count, nor did it, and what counted instead is the same.
      if (winners_[node] == before && before != row.index()) return;
    }
  }

  std::size_t capacity_ = 0;
  std::vector<double> values_;
  std::vector<std::uint32_t>
      winners_;  ///< rows; the children of node i are 2 i and 2 i + 1, from `capacity_` on rows
};

}  // namespace mes
