// SPDX-License-Identifier: GPL-3.0-or-later
// Text without regard to case: A to Z become a to z, every other byte stays, whatever the locale.
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

/// ".png" of "Cat.PNG": with the dot; empty when the name has none.
inline std::string lower_case_extension(const std::filesystem::path& file) {
  return lower_case(file.extension().string());
}

}  // namespace mes
