// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/geometry/coordinate_range.h"

#include <fmt/core.h>
#include <array>
#include <charconv>
#include <cmath>

namespace mes {
namespace {

std::string shortest(double x) {
  std::array<char, 32> digits{};
  const auto [end, error] = std::to_chars(digits.data(), digits.data() + digits.size(), x);
  return {digits.data(), error == std::errc() ? end : digits.data()};
}

std::string about(int exponent) {
  std::array<char, 32> digits{};
  const auto [end, error] = std::to_chars(digits.data(), digits.data() + digits.size(), std::ldexp(1.0, exponent),
                                          std::chars_format::general, 2);
  return {digits.data(), error == std::errc() ? end : digits.data()};
}

constexpr std::string_view kFirstRule =
    "coordinates and radii are 0, or from 2^-500 (3.1e-151) to below 2^500 (3.3e150) in magnitude";
constexpr std::string_view kSecondRule =
    "the largest may be 2^100 (1.3e30) times the smallest in one document, zeros aside";

}  // namespace

Magnitudes MagnitudeCounts::magnitudes() const {
  Magnitudes out;
  for (std::size_t i = 0; i < is_used_.size(); ++i) {
    if (is_used_[i] == 0) continue;
    const int first = kLeastExponent + 64 * static_cast<int>(i);
    out.least = std::min(out.least, first + std::countr_zero(is_used_[i]));
    out.most = first + 63 - std::countl_zero(is_used_[i]);
  }
  return out;
}

std::string describe(RangeFault fault, std::string_view named, const Magnitudes& others) {
  switch (fault) {
    case RangeFault::not_finite: return fmt::format("{} is not a finite number", named);
    case RangeFault::too_small: return fmt::format("{} is too small: {}", named, kFirstRule);
    case RangeFault::too_large: return fmt::format("{} is too large: {}", named, kFirstRule);
    case RangeFault::too_small_here:
      return fmt::format("{} is too small beside numbers of about {}: {}", named, about(others.most), kSecondRule);
    case RangeFault::too_large_here:
      return fmt::format("{} is too large beside numbers of about {}: {}", named, about(others.least), kSecondRule);
  }
  return {};
}

std::string describe(RangeFault fault, double x, const Magnitudes& others) {
  return describe(fault, shortest(x), others);
}

std::string_view coordinate_range_in_words() {
  static const std::string words = fmt::format("{}; {}", kFirstRule, kSecondRule);
  return words;
}

}  // namespace mes
