// SPDX-License-Identifier: GPL-3.0-or-later
// Finds the row of a table with the largest value, while values change.
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

/// Orders rows of equal value by their index.
struct ByRow {
  template <class Row>
  bool operator()(Row a, Row b) const {
    return a.index() < b.index();
  }
};

/// A tree of maxima over the rows of a table; rows without a value have minus infinity.
///
/// `is_first(a, b)`, an order of rows, chooses among rows with the largest value. It is called only for rows with one
/// common value other than minus infinity, and must be the same in all calls. It may read data of the rows: rows that
/// change together must be set together, so that the comparator never sees a stale row.
/// Cost: `build` O(rows); a change at most O(log rows), and O(1) for a row that is not the largest nearby, before or
/// after. 12 to 24 bytes for each row.
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
  /// True before the first `build`.
  bool is_empty() const { return values_.empty(); }

  /// Sets the value of a row; a row beyond the table extends it.
  template <class IsFirst = ByRow>
  void set(Row row, double value, IsFirst is_first = {}) {
    set_all(
        std::array{row}, [value](Row) { return value; }, is_first);
  }
  /// Updates rows after a change of their values, of the data that `is_first` reads, or of both.
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

  /// Minus infinity if no row has a value.
  double largest() const { return is_empty() ? kNone : values_[row_of_largest().index()]; }
  /// The first of the rows with the largest value; there must be one.
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

  /// Winners of nodes above other changed rows may be outdated; their values are already new.
  template <class IsFirst>
  void play(Row row, IsFirst is_first) {
    for (std::size_t node = (capacity_ + row.index()) / 2; node > 0; node /= 2) {
      const std::uint32_t before = winners_[node];
      winners_[node] = winner_below(node, is_first);
      // This row is not the winner here, neither before nor now, so it changes nothing farther up.
      if (winners_[node] == before && before != row.index()) return;
    }
  }

  std::size_t capacity_ = 0;
  std::vector<double> values_;
  std::vector<std::uint32_t>
      winners_;  ///< rows; the children of node i are 2 i and 2 i + 1, from `capacity_` on rows
};

}  // namespace mes
