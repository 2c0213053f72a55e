// SPDX-License-Identifier: GPL-3.0-or-later
// Numbers taken off bytes, for targets whose input is not text. At the end all numbers are zero.
#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <string_view>

#include "core/base/geometry/vec2.h"

namespace mes::fuzz {

class ByteSource {
 public:
  explicit ByteSource(std::string_view bytes) : rest_(bytes) {}

  bool is_at_end() const { return rest_.empty(); }
  /// Little endian.
  std::uint64_t bits(std::size_t bytes) {
    std::uint64_t out = 0;
    for (std::size_t i = 0; i < bytes && !rest_.empty(); ++i, rest_.remove_prefix(1))
      out |= std::uint64_t{static_cast<std::uint8_t>(rest_.front())} << (8 * i);
    return out;
  }
  std::uint8_t byte() { return static_cast<std::uint8_t>(bits(1)); }
  /// Below `count`, which is at most 256 and not zero.
  std::size_t below(std::size_t count) { return byte() % count; }
  bool flag() { return (byte() & 1U) != 0; }
  double any_double() { return std::bit_cast<double>(bits(8)); }
  double small_integer() { return static_cast<double>(static_cast<std::int8_t>(byte())); }
  double integer() { return static_cast<double>(static_cast<std::int16_t>(bits(2))); }

 private:
  std::string_view rest_;
};

}  // namespace mes::fuzz
