// SPDX-License-Identifier: GPL-3.0-or-later
// Sums of many terms.
#pragma once

#include <cmath>
#include <cstdint>

namespace mes {

/// A sum whose error does not grow with the number of terms (Neumaier's variant of Kahan's). Terms that are not finite
/// are skipped and counted.
class Sum {
 public:
  void add(double term) {
    if (!std::isfinite(term)) {
      ++left_out_;
      return;
    }
    const double next = sum_ + term;
    if (std::isfinite(next))
      correction_ += std::abs(sum_) >= std::abs(term) ? (sum_ - next) + term : (term - next) + sum_;
    sum_ = next;
  }
  void add(const Sum& other) {
    add(other.sum_);
    add(other.correction_);
    left_out_ += other.left_out_;
  }
  double value() const { return sum_ + correction_; }
  std::int64_t left_out() const { return left_out_; }

 private:
  double sum_ = 0.0;
  double correction_ = 0.0;
  std::int64_t left_out_ = 0;
};

}  // namespace mes
