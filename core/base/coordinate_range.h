// SPDX-License-Identifier: GPL-3.0-or-later
// Which doubles a document holds: the one place that says so, for files, sessions, tools, evolutions and commands.
//
// Every coordinate and every radius is
//  1. zero, or of a magnitude from 2^-500 up to, but not including, 2^500; and
//  2. of those other than zero in one document, the binary exponents differ by at most 100. So the largest may be
//     2^100 times the smallest, and is never 2^101 times as large.
//
// Both rules see binary exponents alone: a document within them stays within the second when it is multiplied by a
// power of two, and within the first as long as its numbers do. docs/decisions/coordinate_range.md says what follows:
// differences, circumradii and centres are finite and normal doubles, whatever three samples meet.
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
/// Between the largest and the smallest number of a document.
inline constexpr int kMostExponentsApart = 100;

/// The binary exponent of a number other than zero: e with 2^e <= |x| < 2^(e + 1). Below the normal range -1023; 1024
/// for what is not finite.
constexpr int exponent_of(double x) {
  constexpr int kBias = 1023;
  return static_cast<int>((std::bit_cast<std::uint64_t>(x) >> 52U) & 0x7ffU) - kBias;
}

enum class RangeFault : std::uint8_t {
  not_finite,
  too_small,       ///< whatever else there is
  too_large,       ///< whatever else there is
  too_small_here,  ///< beside the largest number of the document
  too_large_here,  ///< beside the smallest number of the document
};

/// By the first rule.
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
  /// Whether they keep the second rule.
  constexpr bool fit() const { return is_empty() || most - least <= kMostExponentsApart; }
  constexpr void add(double x) {
    if (x == 0.0) return;
    least = std::min(least, exponent_of(x));
    most = std::max(most, exponent_of(x));
  }
  /// By both rules, in the company of these.
  constexpr std::optional<RangeFault> fault_of(double x) const {
    if (x == 0.0) return std::nullopt;
    if (const auto fault = range_fault_of(x)) return fault;
    if (is_empty()) return std::nullopt;
    if (exponent_of(x) < most - kMostExponentsApart) return RangeFault::too_small_here;
    if (exponent_of(x) > least + kMostExponentsApart) return RangeFault::too_large_here;
    return std::nullopt;
  }
};

/// The number, or zero if it is too small for a document whose largest number has this binary exponent; any exponent,
/// also that of `Magnitudes` without numbers. For what comes from a hand or from rounding, where so small a number means
/// zero.
constexpr double without_traces(double x, int most_exponent) {
  const int least = std::max(kLeastExponent + kMostExponentsApart, most_exponent) - kMostExponentsApart;
  return exponent_of(x) < least ? 0.0 : x;
}

/// How many numbers have which binary exponent. Constant time a change; 4 KiB. What is added must keep the first
/// rule, and what is removed must have been added.
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
  std::array<std::uint64_t, (kExponents + 63) / 64> is_used_{};  // a bit for each count that is not 0
};

/// Why the number is refused, for a message: `named` is what it is called there. `others` as for `fault_of`.
std::string describe(RangeFault fault, std::string_view named, const Magnitudes& others = {});
/// The same, with the number's shortest decimal form for a name.
std::string describe(RangeFault fault, double x, const Magnitudes& others = {});

/// Both rules in words, for everything that documents input.
std::string_view coordinate_range_in_words();

}  // namespace mes
