// SPDX-License-Identifier: GPL-3.0-or-later
// Linear equations of which each unknown meets the three before and after it, around if they are closed. Private to
// core/raster.
#pragma once

#include <array>
#include <cstddef>
#include <vector>

namespace mes {

/// Symmetric and positive definite, built up as a sum of squares. At least eight unknowns if closed. Factored once, it is
/// solved for any number of right sides.
class StiffSystem {
 public:
  /// Begins again with nothing added, in the same memory.
  void clear(std::size_t count, bool is_closed) {
    rows_.assign(count, {});
    right_.assign(count, 0.0);
    corner_ = {};
    is_closed_ = is_closed;
  }

  /// Adds weight * (sum of coefficient[i] * unknown[first + i] - value)^2, at most four unknowns in a row: around if they
  /// are closed, otherwise those that are none are zero.
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
  /// Adds a sum of squares of two unknowns in a row by its matrix.
  void add_pair(std::ptrdiff_t first, double diagonal, double beside, double next_diagonal) {
    const auto count = static_cast<std::ptrdiff_t>(rows_.size());
    if (first >= 0) {
      rows_[static_cast<std::size_t>(first)][0] += diagonal;
      rows_[static_cast<std::size_t>(first)][1] += beside;
    }
    if (first + 1 < count) rows_[static_cast<std::size_t>(first + 1)][0] += next_diagonal;
    if (first + 1 == count && is_closed_) rows_[0][0] += next_diagonal;
  }

  /// The right side: of what was added with values, until it is solved for.
  std::vector<double>& right() { return right_; }

  /// O(unknowns). After it nothing can be added.
  void factor();
  /// Makes the right side the unknowns. O(unknowns). After `factor`.
  void solve();

 private:
  static constexpr std::size_t kReach = 3;
  using Row = std::array<double, kReach>;

  void factor_first(std::size_t count);

  std::vector<std::array<double, 4>>
      rows_;  // of the matrix, from the diagonal to the right, around; factored: of that
  std::vector<double> right_;
  bool is_closed_ = false;
  // The last three unknowns of a closed system join its ends: the others are solved for them first.
  std::vector<Row> border_;   // columns of the last, in the rows of the others
  std::vector<Row> reduced_;  // what the others are for each of the last
  std::array<Row, kReach> corner_{};
};

}  // namespace mes
