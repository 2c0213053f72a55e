// SPDX-License-Identifier: GPL-3.0-or-later
// Scaling by a power of two.
#pragma once

#include <bit>
#include <cmath>
#include <cstdint>

namespace mes {

/// x times 2^exponent: the double that std::ldexp returns, at the cost of a multiplication.
inline double times_power_of_two(double x, int exponent) {
  // These powers are normal doubles, so the product is rounded once.
  if (exponent < -1022 || exponent > 1023) return std::ldexp(x, exponent);
  return x * std::bit_cast<double>(static_cast<std::uint64_t>(exponent + 1023) << 52U);
}

}  // namespace mes
