// SPDX-License-Identifier: GPL-3.0-or-later
// Linear equations of which each unknown meets the three before and after it, around if they are closed. Private to
// core/raster.
#pragma once

#include <array>
#include <cstddef>
#include <vector>

namespace mes {

/// Symmetric and positive definite, built up as a sum of squares. At least six unknowns, eight if closed.
class StiffSystem {
 public:
  StiffSystem(std::size_t count, bool is_closed) : rows_(count), right_(count, 0.0), is_closed_(is_closed) {}

  /// Adds weight * (sum of coefficient[i] * unknown[first + i] - value)^2, at most four unknowns in a row, around.
  template <std::size_t N>
  void add(std::size_t first, const std::array<double, N>& coefficients, double value, double weight) {
    static_assert(N <= 4);
    const std::size_t count = rows_.size();
    for (std::size_t i = 0; i < N; ++i) {
      const std::size_t row = first + i < count ? first + i : first + i - count;
      right_[row] += weight * coefficients[i] * value;
      for (std::size_t k = i; k < N; ++k) rows_[row][k - i] += weight * coefficients[i] * coefficients[k];
    }
  }

  /// O(unknowns). The system is used up.
  std::vector<double> solved() &&;

 private:
  /// Of the first unknowns, without those that join the end to the beginning.
  void factor(std::size_t count);
  void solve(std::vector<double>& x, std::size_t count) const;

  std::vector<std::array<double, 4>> rows_;  // of the matrix, from the diagonal to the right, around
  std::vector<double> right_;
  bool is_closed_;
};

}  // namespace mes
