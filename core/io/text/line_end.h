// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <string_view>

namespace mes {

/// The end of the first line of a text: a line feed, a carriage return or the end of the text. Tests eight bytes at
/// once; `find_first_of` of the standard library calls a function for each byte.
inline std::size_t end_of_line(std::string_view text) {
  constexpr unsigned kBytes = 8;
  constexpr std::uint64_t kOnes = 0x0101010101010101;
  std::size_t end = 0;
  if constexpr (std::endian::native == std::endian::little) {
    // The lowest set high bit belongs to the first zero byte.
    const auto zero_bytes = [](std::uint64_t bytes) { return (bytes - kOnes) & ~bytes & (0x80 * kOnes); };
    for (; end + kBytes <= text.size(); end += kBytes) {
      std::uint64_t bytes = 0;
      std::memcpy(&bytes, text.data() + end, kBytes);
      const std::uint64_t ends = zero_bytes(bytes ^ ('\n' * kOnes)) | zero_bytes(bytes ^ ('\r' * kOnes));
      if (ends != 0) return end + static_cast<unsigned>(std::countr_zero(ends)) / kBytes;
    }
  }
  while (end < text.size() && text[end] != '\n' && text[end] != '\r') ++end;
  return end;
}

}  // namespace mes
