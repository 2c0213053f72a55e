// SPDX-License-Identifier: GPL-3.0-or-later
// Precision of the written numbers of a file: numbers that differ only in their last digits are equal. Private to
// core/io.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <span>
#include <string_view>

namespace mes {

/// The digits of a decimal number as written.
struct WrittenNumber {
  int decimals = 0;     ///< digits after the point; a negative exponent adds some, a positive one subtracts some
  int significant = 0;  ///< digits from the first nonzero one
};

/// Counts the digits of a number as written.
inline WrittenNumber written_number(std::string_view token) {
  WrittenNumber out;
  bool is_after_point = false;
  std::size_t i = 0;
  for (; i < token.size(); ++i) {
    const char c = token[i];
    if (c == '.' || c == ',') is_after_point = true;
    if (c == 'e' || c == 'E' || c == 'd' || c == 'D') break;
    if (c < '0' || c > '9') continue;
    if (is_after_point) ++out.decimals;
    if (c != '0' || out.significant != 0) ++out.significant;
  }
  if (i == token.size()) return out;
  constexpr int kMost = 400;
  int exponent = 0;
  const bool is_negative = i + 1 < token.size() && token[i + 1] == '-';
  for (++i; i < token.size(); ++i)
    if (token[i] >= '0' && token[i] <= '9') exponent = std::min(10 * exponent + (token[i] - '0'), kMost);
  out.decimals += is_negative ? exponent : -exponent;
  return out;
}

/// Half a unit of the last digit: the largest error of rounding to it. Zero for a number with less than `least`
/// decimals, which counts as exact.
inline double half_last_digit(std::string_view token, int least = 2) {
  const int decimals = written_number(token).decimals;
  return decimals < least ? 0.0 : 0.5 * std::pow(10.0, -decimals);
}

/// The decimals of all numbers of a kind in a file, by magnitude: programs write all numbers either with the same
/// number of decimals or of significant digits, and may drop trailing zeros.
///
/// Smallest use:
///     WrittenDecimals decimals;
///     for (const std::string_view word : {"0.12346", "2", "1.12346"}) decimals.add(word);
///     const bool are_equal = std::abs(a - b) <= 2.0 * decimals.error_of(2.0);
class WrittenDecimals {
 public:
  void add(std::string_view token) {
    const WrittenNumber number = written_number(token);
    if (number.decimals <= 0 || number.significant == 0) return;
    int& most = most_[index_of(number.significant - number.decimals)];
    most = std::max(most, number.decimals);
  }
  /// Largest rounding error of a number of this magnitude: half a unit of the last decimal of numbers of this or a
  /// greater magnitude, or else of the largest smaller ones. Zero if these have less than three decimals, which count
  /// as exact.
  double error_of(double magnitude) const {
    constexpr int kLeast = 3;
    const std::size_t own = index_of(magnitude > 0.0 ? static_cast<int>(std::floor(std::log10(magnitude))) + 1 : 0);
    int decimals = *std::max_element(most_.begin() + static_cast<std::ptrdiff_t>(own), most_.end());
    for (std::size_t i = own; decimals == 0 && i > 0; --i) decimals = most_[i - 1];
    return decimals < kLeast ? 0.0 : 0.5 * std::pow(10.0, -decimals);
  }

 private:
  static constexpr int kLow = -20;
  static constexpr int kHigh = 20;
  /// The index is the number of digits before the point, or minus the number of zeros after it.
  static std::size_t index_of(int leading) {
    return static_cast<std::size_t>(std::clamp(leading, kLow, kHigh) - kLow);
  }

  std::array<int, kHigh - kLow + 1> most_{};
};

/// The decimals of vertex coordinates; the first few thousand represent all.
class VertexDecimals {
 public:
  void add(std::span<const std::string_view> coordinates) {
    constexpr int kLookedAt = 4096;
    if (seen_++ >= kLookedAt) return;
    for (const std::string_view word : coordinates) {
      decimals_.add(word);
      const WrittenNumber number = written_number(word);
      leading_ = std::max(leading_, number.significant - number.decimals);
    }
  }
  /// Largest rounding error of the vertex coordinates.
  double rounding() const { return decimals_.error_of(0.5 * std::pow(10.0, leading_)); }

 private:
  WrittenDecimals decimals_;
  int leading_ = -20;
  int seen_ = 0;
};

}  // namespace mes
