// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/io/session/json_color.h"

#include <fmt/core.h>
#include <charconv>

namespace mes {

std::string hexadecimal(Rgb color) {
  return fmt::format("#{:02X}{:02X}{:02X}", color.r, color.g, color.b);
}

std::optional<Rgb> color_from(std::string_view word) {
  unsigned value = 0;
  const char* const end = word.data() + word.size();
  if (word.size() != 7 || word.front() != '#' || std::from_chars(word.data() + 1, end, value, 16).ptr != end)
    return std::nullopt;
  return Rgb{static_cast<std::uint8_t>(value >> 16U), static_cast<std::uint8_t>((value >> 8U) & 0xffU),
             static_cast<std::uint8_t>(value & 0xffU)};
}

}  // namespace mes
