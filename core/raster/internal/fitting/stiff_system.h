// SPDX-License-Identifier: GPL-3.0-or-later
// Linear equations in which each unknown is coupled to the three before and after it, cyclically if closed. Private to
// core/raster.
#pragma once

#include <array>
#include <cstddef>
#include <vector>

namespace mes {

/// A symmetric positive definite system, built as a sum of squares. At least eight unknowns if closed. After one
/// factorization it can be solved for any number of right sides.
class StiffSystem {
 public:
  /// Removes all equations and keeps the memory.
  void clear(std::size_t count, bool is_closed) {
    rows_.assign(count, {});
    right_.assign(count, 0.0);
    corner_ = {};
    is_closed_ = is_closed;
  }

  /// Adds weight * (sum of coefficient[i] * unknown[first + i] - value)^2, for at most four successive unknowns: cyclic
  /// if closed; otherwise unknowns out of range are zero.
  template <std::size_t N>
  void add(std::ptrdiff_t first, const std::array<double, N>& coefficients, double value, double weight) {
    static_assert(N <= 4);
    const auto count = static_cast<std::ptrdiff_t>(rows_.size());
    for (std::size_t i = 0; i < N; ++i) {
      std::ptrdiff_t row = first + static_cast<std::ptrdiff_t>(i);
      if (is_closed_ && row >= count) row -= count;
      if (row < 0 || row >= count) continue;
      const auto at = static_cast<std::size_t>(row);
      right_[at] += weight * coefficients[i] * value;
      for (std::size_t k = i; k < N; ++k) rows_[at][k - i] += weight * coefficients[i] * coefficients[k];
    }
  }
  /// Adds a quadratic form of two successive unknowns by its matrix.
  void add_pair(std::ptrdiff_t first, double diagonal, double beside, double next_diagonal) {
    const auto count = static_cast<std::ptrdiff_t>(rows_.size());
    if (first >= 0) {
      rows_[static_cast<std::size_t>(first)][0] += diagonal;
      rows_[static_cast<std::size_t>(first)][1] += beside;
    }
    if (first + 1 < count) rows_[static_cast<std::size_t>(first + 1)][0] += next_diagonal;
    if (first + 1 == count && is_closed_) rows_[0][0] += next_diagonal;
  }

  /// The right side: the sum of the added values, and after `solve` the solution.
  std::vector<double>& right() { return right_; }

  /// O(unknowns). Nothing can be added after it.
  void factor();
  /// Replaces the right side by the solution. O(unknowns). Call after `factor`.
  void solve();

 private:
  static constexpr std::size_t kReach = 3;
  using Row = std::array<double, kReach>;

  void factor_first(std::size_t count);

  std::vector<std::array<double, 4>>
      rows_;  // matrix rows from the diagonal to the right, cyclic; after `factor` those of the factor
  std::vector<double> right_;
  bool is_closed_ = false;
  // The last three unknowns of a closed system couple to its ends, so the others are solved for in terms of them first.
  std::vector<Row> border_;   // columns of these three in the rows of the others
  std::vector<Row> reduced_;  // the others in terms of these three
  std::array<Row, kReach> corner_{};
};

}  // namespace mes
