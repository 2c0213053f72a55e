// SPDX-License-Identifier: GPL-3.0-or-later
// Private to app/picture.
#pragma once

#include <cstddef>
#include <string_view>

namespace mes {

/// The number of UTF-8 bytes of the letter that begins there.
inline std::size_t bytes_of_letter(std::string_view text, std::size_t at = 0) {
  std::size_t end = at + 1;
  while (end < text.size() && (static_cast<unsigned char>(text[end]) & 0xC0U) == 0x80U) ++end;
  return end - at;
}

}  // namespace mes
