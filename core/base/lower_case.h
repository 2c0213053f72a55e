// SPDX-License-Identifier: GPL-3.0-or-later
// Text without regard to case: maps A to Z to a to z and keeps every other byte, whatever the locale.
#pragma once

#include <algorithm>
#include <filesystem>
#include <string>
#include <string_view>

namespace mes {

constexpr char lower_case(char c) {
  return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
}

inline std::string lower_case(std::string_view text) {
  std::string out(text);
  std::ranges::transform(out, out.begin(), [](char c) { return lower_case(c); });
  return out;
}

/// Returns the extension in lower case, with the dot: ".png" for "Cat.PNG". Empty if the name has none.
inline std::string lower_case_extension(const std::filesystem::path& file) {
  return lower_case(file.extension().string());
}

}  // namespace mes
