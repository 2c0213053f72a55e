// SPDX-License-Identifier: GPL-3.0-or-later
// Defines which doubles a document may hold, for files, sessions, tools, evolutions and commands alike.
//
// Every coordinate and every radius satisfies two rules:
//  1. It is zero, or its magnitude is at least 2^-500 and below 2^500.
//  2. The binary exponents of all nonzero numbers of one document differ by at most 100. So the largest may be 2^100
//     times the smallest, and is never 2^101 times as large.
//
// Both rules look at binary exponents only. Scaling a document by a power of two keeps the second rule, and keeps the
// first rule as long as the scaled numbers satisfy it. docs/decisions/coordinate_range.md derives the
// consequence: differences, circumradii and centres of any three samples are finite and normal doubles.
//
// Smallest use:
//     Magnitudes seen;
//     if (const auto fault = seen.fault_of(x)) return refuse(describe(*fault, x, seen));
//     seen.add(x);
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <string_view>

namespace mes {

inline constexpr int kLeastExponent = -500;
inline constexpr int kMostExponent = 499;
/// Largest difference of exponents between the numbers of a document.
inline constexpr int kMostExponentsApart = 100;

/// The binary exponent of a nonzero number: e with 2^e <= |x| < 2^(e + 1). Returns -1023 below the normal range, and
/// 1024 for infinities and NaN.
constexpr int exponent_of(double x) {
  constexpr int kBias = 1023;
  return static_cast<int>((std::bit_cast<std::uint64_t>(x) >> 52U) & 0x7ffU) - kBias;
}

enum class RangeFault : std::uint8_t {
  not_finite,
  too_small,       ///< in any document
  too_large,       ///< in any document
  too_small_here,  ///< compared with the largest number of the document
  too_large_here,  ///< compared with the smallest number of the document
};

/// Checks the first rule.
constexpr std::optional<RangeFault> range_fault_of(double x) {
  if (x == 0.0) return std::nullopt;
  const int exponent = exponent_of(x);
  if (kLeastExponent <= exponent && exponent <= kMostExponent) return std::nullopt;
  if (exponent > std::numeric_limits<double>::max_exponent - 1) return RangeFault::not_finite;
  return exponent < kLeastExponent ? RangeFault::too_small : RangeFault::too_large;
}

/// The least and the largest binary exponent of some numbers other than zero.
struct Magnitudes {
  int least = std::numeric_limits<int>::max();
  int most = std::numeric_limits<int>::min();

  constexpr bool is_empty() const { return least > most; }
  /// Whether the numbers satisfy the second rule.
  constexpr bool fit() const { return is_empty() || most - least <= kMostExponentsApart; }
  constexpr void add(double x) {
    if (x == 0.0) return;
    least = std::min(least, exponent_of(x));
    most = std::max(most, exponent_of(x));
  }
  /// Checks both rules for a number that joins these.
  constexpr std::optional<RangeFault> fault_of(double x) const {
    if (x == 0.0) return std::nullopt;
    if (const auto fault = range_fault_of(x)) return fault;
    if (is_empty()) return std::nullopt;
    if (exponent_of(x) < most - kMostExponentsApart) return RangeFault::too_small_here;
    if (exponent_of(x) > least + kMostExponentsApart) return RangeFault::too_large_here;
    return std::nullopt;
  }
};

/// Returns the number, or zero if it is too small for a document whose largest number has this binary exponent. Any
/// exponent is allowed, also that of empty `Magnitudes`. For numbers from mouse input or rounding, where so small a
/// number means zero.
constexpr double without_traces(double x, int most_exponent) {
  const int least = std::max(kLeastExponent + kMostExponentsApart, most_exponent) - kMostExponentsApart;
  return exponent_of(x) < least ? 0.0 : x;
}

/// Counts the numbers with each binary exponent. O(1) for a change; 4 KiB. Added numbers must satisfy the first rule,
/// and removed ones must have been added.
class MagnitudeCounts {
 public:
  void add(double x) {
    if (x == 0.0) return;
    const std::size_t i = index_of(x);
    if (count_[i]++ == 0) is_used_[i / 64] |= std::uint64_t{1} << (i % 64);
  }
  void remove(double x) {
    if (x == 0.0) return;
    const std::size_t i = index_of(x);
    if (--count_[i] == 0) is_used_[i / 64] &= ~(std::uint64_t{1} << (i % 64));
  }
  Magnitudes magnitudes() const;

 private:
  static constexpr std::size_t kExponents = kMostExponent - kLeastExponent + 1;
  static std::size_t index_of(double x) { return static_cast<std::size_t>(exponent_of(x) - kLeastExponent); }

  std::array<std::uint32_t, kExponents> count_{};
  std::array<std::uint64_t, (kExponents + 63) / 64> is_used_{};  // one bit for each nonzero count
};

/// Explains in a message why the number is refused. `named` is its name there; `others` as in `fault_of`.
std::string describe(RangeFault fault, std::string_view named, const Magnitudes& others = {});
/// The same, with the shortest decimal form of the number as its name.
std::string describe(RangeFault fault, double x, const Magnitudes& others = {});

/// Both rules in words, for all texts that document input.
std::string_view coordinate_range_in_words();

}  // namespace mes
