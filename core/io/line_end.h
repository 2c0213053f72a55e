// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <string_view>

namespace mes {

/// Where the first line of a text ends: at a line feed, a carriage return or the end of the text. One look at each
/// byte; `find_first_of` of the standard library calls a function for each.
inline std::size_t end_of_line(std::string_view text) {
  std::size_t end = 0;
  while (end < text.size() && text[end] != '\n' && text[end] != '\r') ++end;
  return end;
}

}  // namespace mes
