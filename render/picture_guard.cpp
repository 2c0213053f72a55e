// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/picture_guard.h"

#include <algorithm>

namespace mes::render {
namespace {

using Bytes = std::span<const std::byte>;

/// A number of `count` bytes, big-endian; bytes beyond the end count as zero.
std::size_t number(Bytes bytes, std::size_t count) {
  std::size_t out = 0;
  for (std::size_t i = 0; i < count; ++i)
    out = out << 8U | (i < bytes.size() ? std::to_integer<std::size_t>(bytes[i]) : 0U);
  return out;
}

Bytes without_first(Bytes bytes, std::size_t count) {
  return bytes.subspan(std::min(count, bytes.size()));
}

// --- JPEG ---

constexpr std::byte kMarker{0xFF};

bool stands_alone(unsigned marker) {
  return (marker >= 0xD0 && marker <= 0xD9) || marker == 0x01;  // restarts, begin and end of the picture
}

/// A table is a byte of class and number, the counts of symbols by code length, and the symbols. The decoder reads
/// tables until the segment ends; the last one may extend beyond its end.
bool are_tables_sound(Bytes from_segment, std::size_t segment) {
  constexpr std::size_t kLengths = 16;
  constexpr std::size_t kMostSymbols = 256;
  for (std::size_t at = 0; at < segment;) {
    std::size_t symbols = 0;
    for (std::size_t i = 0; i < kLengths; ++i) symbols += number(without_first(from_segment, at + 1 + i), 1);
    if (symbols > kMostSymbols) return false;
    at += 1 + kLengths + symbols;
  }
  return true;
}

/// Walks from marker to marker: 0xFF and a byte that is neither zero, which means data, nor 0xFF, which is a filler.
/// The decoder finds the same markers between segments, or it fails earlier.
bool is_safe_jpeg(Bytes rest) {
  constexpr unsigned kTables = 0xC4;
  for (;;) {
    while (rest.size() >= 2 && (rest[0] != kMarker || rest[1] == kMarker || rest[1] == std::byte{0}))
      rest = rest.subspan(1);
    if (rest.size() < 2) return true;
    const auto marker = std::to_integer<unsigned>(rest[1]);
    rest = rest.subspan(2);
    if (stands_alone(marker)) continue;
    const std::size_t length = std::max<std::size_t>(number(rest, 2), 2);
    if (marker == kTables && !are_tables_sound(without_first(rest, 2), length - 2)) return false;
    rest = without_first(rest, length);
  }
}

// --- PNG ---

/// Chunks: length, name, contents, checksum.
bool is_safe_png(Bytes rest) {
  constexpr std::size_t kSignature = 8;
  constexpr std::size_t kBeforeContents = 8;
  constexpr std::size_t kChecksum = 4;
  constexpr std::size_t kEnd = 0x49454E44;
  rest = without_first(rest, kSignature);
  while (rest.size() >= kBeforeContents) {
    const std::size_t length = number(rest, 4);
    if (number(rest.subspan(4), 4) == kEnd) return true;
    rest = rest.subspan(kBeforeContents);
    if (length > rest.size()) return false;
    rest = without_first(rest, length + kChecksum);
  }
  return true;
}

}  // namespace

bool is_safe_to_decode(Bytes bytes) {
  constexpr std::byte kPng{0x89};
  if (bytes.empty()) return true;
  if (bytes.front() == kMarker) return is_safe_jpeg(bytes);
  return bytes.front() != kPng || is_safe_png(bytes);
}

}  // namespace mes::render
