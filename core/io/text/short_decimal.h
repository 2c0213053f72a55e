// SPDX-License-Identifier: GPL-3.0-or-later
// Reads decimal numbers of few digits several times as fast as `std::from_chars`. Private to core/io.
//
// Smallest use:
//     double value = 0.0;
//     const std::size_t size = short_decimal("12.5,3", value);  // 4
#pragma once

#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <string_view>

namespace mes {

namespace internal {

/// Does the same as `short_decimal`, byte by byte.
inline std::size_t short_decimal_by_bytes(std::string_view text, double& value) {
  constexpr std::size_t kMostDigits = 18;
  constexpr std::uint64_t kMostExact = std::uint64_t{1} << 53U;
  static constexpr std::array<double, 19> kPowers{1e0,  1e1,  1e2,  1e3,  1e4,  1e5,  1e6,  1e7,  1e8, 1e9,
                                                  1e10, 1e11, 1e12, 1e13, 1e14, 1e15, 1e16, 1e17, 1e18};
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
      digits = 10 * digits + digit;  // wraps after too many digits; checked below
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
  // Numerator and denominator are exact doubles, so the quotient is rounded only once.
  const double size = static_cast<double>(digits) / kPowers[decimals];
  value = is_negative ? -size : size;
  return static_cast<std::size_t>(at - begin);
}

/// The high bit of each byte that is above 9.
constexpr std::uint64_t bytes_above_nine(std::uint64_t bytes) {
  return (((bytes & 0x7f7f7f7f7f7f7f7f) + 0x7676767676767676) | bytes) & 0x8080808080808080;
}

/// Value of eight digits, the first in the lowest byte. Combines pairs of 16 bits, then fours of 32, then all.
constexpr std::uint64_t eight_digits(std::uint64_t bytes) {
  bytes = ((bytes * (1 + (10U << 8U))) >> 8U) & 0x00ff00ff00ff00ff;
  bytes = ((bytes * (1 + (100U << 16U))) >> 16U) & 0x0000ffff0000ffff;
  return (bytes * (1 + (std::uint64_t{10000} << 32U))) >> 32U;
}

}  // namespace internal

/// Reads a number at the beginning of the text into `value` and returns its length. A number is an optional sign,
/// digits, and digits after a point, of which either may be missing.
///
/// Guarantees: the value is the double nearest to the number, as for `std::from_chars`. Returns 0 and leaves
/// `value` alone for more than 18 digits, digits that are together above 2^53, an exponent, or text that is not a
/// number. Cost: a few nanoseconds.
inline std::size_t short_decimal(std::string_view text, double& value) {
  constexpr unsigned kBytes = 8;
  static constexpr std::array<double, kBytes> kPowers{1e0, 1e1, 1e2, 1e3, 1e4, 1e5, 1e6, 1e7};
  // Most numbers of drawings and maps have a point and end within eight bytes. These bytes are read together, which
  // takes less than half of the instructions.
  if constexpr (std::endian::native == std::endian::little) {
    const char* const begin = text.data();
    const std::size_t sign = !text.empty() && *begin == '-' ? 1 : 0;
    if (text.size() > kBytes + sign) {
      std::uint64_t bytes = 0;
      std::memcpy(&bytes, begin + sign, kBytes);
      bytes ^= 0x3030303030303030;  // maps a digit to its value, and a point to 0x1e
      const std::uint64_t others = internal::bytes_above_nine(bytes);
      const auto point = static_cast<unsigned>(std::countr_zero(others)) / kBytes;  // index of the point's byte
      const std::uint64_t after = others & (others - 1);
      const auto size = after == 0 ? kBytes : static_cast<unsigned>(std::countr_zero(after)) / kBytes;
      const auto next = static_cast<unsigned char>(begin[sign + size]);
      const bool is_done = static_cast<unsigned>(next) - unsigned{'0'} > 9 && (next | 0x20U) != 'e';
      if (others != 0 && size > 1 && ((bytes >> (8 * point)) & 0xffU) == 0x1e && is_done) {
        const std::uint64_t before = bytes & ((std::uint64_t{1} << (8 * point)) - 1);
        const std::uint64_t digits = (bytes >> 8U & ~std::uint64_t{0} << (8 * point)) | before;
        // Shifts the last digit to the highest byte, with zeros in front.
        const std::uint64_t number = internal::eight_digits(digits << (8 * (kBytes + 1 - size)));
        // Numerator and denominator are exact doubles, so the quotient is rounded only once.
        value = std::copysign(static_cast<double>(number) / kPowers[size - 1 - point], sign != 0 ? -1.0 : 1.0);
        return sign + size;
      }
    }
  }
  return internal::short_decimal_by_bytes(text, value);
}

}  // namespace mes
