// SPDX-License-Identifier: GPL-3.0-or-later
// Base64 (RFC 4648): bytes written as letters.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace mes {

/// Encodes without line breaks.
inline std::string base64(std::string_view bytes) {
  constexpr std::string_view kDigits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string out;
  out.reserve((bytes.size() + 2) / 3 * 4);
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    const std::size_t left = bytes.size() - i;
    const auto byte = [bytes](std::size_t k) -> std::uint32_t { return static_cast<std::uint8_t>(bytes[k]); };
    const std::uint32_t word = byte(i) << 16U | (left > 1 ? byte(i + 1) << 8U : 0U) | (left > 2 ? byte(i + 2) : 0U);
    out += kDigits[word >> 18U];
    out += kDigits[word >> 12U & 63U];
    out += left > 1 ? kDigits[word >> 6U & 63U] : '=';
    out += left > 2 ? kDigits[word & 63U] : '=';
  }
  return out;
}

/// Value of a base64 digit; -1 for other characters.
inline int base64_digit(char c) {
  if (c >= 'A' && c <= 'Z') return c - 'A';
  if (c >= 'a' && c <= 'z') return c - 'a' + 26;
  if (c >= '0' && c <= '9') return c - '0' + 52;
  return c == '+' ? 62 : (c == '/' ? 63 : -1);
}

/// Decodes base64. Skips white space, and ignores everything after the last digit.
inline std::string from_base64(std::string_view text) {
  std::string out;
  out.reserve(text.size() / 4 * 3);
  std::uint32_t bits = 0;
  unsigned count = 0;
  for (const char c : text) {
    if (c == ' ' || c == '\n' || c == '\r' || c == '\t') continue;
    const int digit = base64_digit(c);
    if (digit < 0) break;
    bits = bits << 6U | static_cast<std::uint32_t>(digit);
    if ((count += 6U) < 8U) continue;
    count -= 8U;
    out += static_cast<char>(bits >> count & 0xffU);
  }
  return out;
}

}  // namespace mes
