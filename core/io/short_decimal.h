// SPDX-License-Identifier: GPL-3.0-or-later
// Decimal numbers of few digits, read several times as fast as `std::from_chars` does. Private to core/io.
//
// Smallest use:
//     double value = 0.0;
//     const std::size_t size = short_decimal("12.5,3", value);  // 4
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string_view>

namespace mes {

/// How many bytes from the beginning are a number, which is then in `value`: a sign or none, digits, and digits after a
/// point, of which either may be missing.
///
/// What it guarantees: the value is the double nearest to the number, as `std::from_chars` has it. 0, and `value` as it
/// was, where that takes more: more than 18 digits, digits that are together above 2^53, an exponent, or text that is not
/// a number. Cost: a few nanoseconds.
inline std::size_t short_decimal(std::string_view text, double& value) {
  constexpr std::array<double, 19> kPowers{1e0,  1e1,  1e2,  1e3,  1e4,  1e5,  1e6,  1e7,  1e8, 1e9,
                                           1e10, 1e11, 1e12, 1e13, 1e14, 1e15, 1e16, 1e17, 1e18};
  constexpr std::size_t kMostDigits = 18;
  constexpr std::uint64_t kMostExact = std::uint64_t{1} << 53U;
  const char* const begin = text.data();
  const char* const end = begin + text.size();
  const char* at = begin;
  const bool is_negative = at != end && *at == '-';
  if (at != end && (*at == '-' || *at == '+')) ++at;
  std::uint64_t digits = 0;
  const char* const first = at;
  const auto take_digits = [&] {
    for (; at != end; ++at) {
      const auto digit = static_cast<unsigned>(static_cast<unsigned char>(*at)) - unsigned{'0'};
      if (digit > 9) return;
      digits = 10 * digits + digit;  // wraps where there are too many, which is seen below
    }
  };
  take_digits();
  auto count = static_cast<std::size_t>(at - first);
  std::size_t decimals = 0;
  if (at != end && *at == '.') {
    const char* const point = ++at;
    take_digits();
    decimals = static_cast<std::size_t>(at - point);
    count += decimals;
  }
  if (count == 0 || count > kMostDigits || digits > kMostExact) return 0;
  if (at != end && (*at == 'e' || *at == 'E')) return 0;
  // Both are doubles without rounding, so that the quotient is rounded once.
  const double size = static_cast<double>(digits) / kPowers[decimals];
  value = is_negative ? -size : size;
  return static_cast<std::size_t>(at - begin);
}

}  // namespace mes
