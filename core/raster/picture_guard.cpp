// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/raster/picture_guard.h"

#include <algorithm>
#include <optional>

namespace mes {
namespace {

using Bytes = std::span<const std::byte>;

constexpr std::string_view kTooMuch = "it announces more than it can hold";

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

// --- BMP ---

std::size_t little_endian(Bytes bytes, std::size_t count) {
  std::size_t out = 0;
  for (std::size_t i = count; i > 0; --i)
    out = out << 8U | (i <= bytes.size() ? std::to_integer<std::size_t>(bytes[i - 1]) : 0U);
  return out;
}

/// The largest number of so many bits in the bytes.
unsigned largest_index(Bytes bytes, unsigned bits) {
  unsigned out = 0;
  for (const std::byte byte : bytes)
    for (unsigned shift = 0; shift < 8; shift += bits)
      out = std::max(out, std::to_integer<unsigned>(byte) >> shift & ((1U << bits) - 1U));
  return out;
}

/// The decoder takes what lies between header and pixels for the palette, reads colours beyond its end from memory that
/// was never written, and zeros beyond the end of the file.
std::string_view bmp_hazard(Bytes bytes) {
  constexpr std::size_t kFileHeader = 14;
  constexpr std::size_t kOldHeader = 12;  // of OS/2, which the decoder takes for longer
  constexpr std::size_t kMostSide = std::size_t{1} << 16U;
  const std::size_t offset = little_endian(without_first(bytes, 10), 4);
  const std::size_t header = little_endian(without_first(bytes, kFileHeader), 4);
  const bool is_old = header == kOldHeader;
  const Bytes rest = without_first(bytes, kFileHeader + 4);
  const std::size_t width = little_endian(rest, is_old ? 2 : 4);
  std::size_t height = little_endian(without_first(rest, is_old ? 2 : 4), is_old ? 2 : 4);
  if (height > 0x7FFFFFFFU) height = 0x100000000U - height;  // negative: rows from the top
  const std::size_t bits = little_endian(without_first(rest, is_old ? 6 : 10), 2);
  if (width >= kMostSide || height >= kMostSide || bits == 0 || bits > 32) return {};  // refused anyway
  const std::size_t row = (width * bits + 31) / 32 * 4;
  if (offset < kFileHeader + header || offset > bytes.size() || bytes.size() - offset < row * height) return kTooMuch;
  if (bits > 8) return {};
  const std::size_t colors =
      is_old ? (std::max<std::size_t>(offset, 38) - 38) / 3 : (offset - kFileHeader - header) / 4;
  if (bits != 1 && bits != 4 && bits != 8) return {};
  const bool is_within = largest_index(bytes.subspan(offset, row * height), static_cast<unsigned>(bits)) < colors;
  return is_within ? std::string_view() : "it has colours that its palette lacks";
}

// --- PGM and PPM ---

/// A number after white space and comments; nothing for none, or for one of many digits.
std::optional<std::size_t> next_number(Bytes& rest) {
  constexpr std::size_t kMostDigits = 6;
  const auto first = [&] { return rest.empty() ? 0 : std::to_integer<int>(rest[0]); };
  while (first() == ' ' || (first() >= '\t' && first() <= '\r') || first() == '#') {
    if (first() == '#')
      while (!rest.empty() && first() != '\n' && first() != '\r') rest = rest.subspan(1);
    else
      rest = rest.subspan(1);
  }
  std::size_t digits = 0;
  std::size_t out = 0;
  for (; first() >= '0' && first() <= '9'; rest = rest.subspan(1), ++digits)
    if (digits < kMostDigits) out = 10 * out + static_cast<std::size_t>(first() - '0');
  if (digits == 0 || digits > kMostDigits) return std::nullopt;
  return out;
}

/// The decoder adds up digits without end, takes 16 bits for 8, and does not look whether all pixels are there.
std::string_view pnm_hazard(Bytes bytes) {
  Bytes rest = bytes.subspan(2);
  const auto width = next_number(rest);
  const auto height = next_number(rest);
  const auto most = next_number(rest);
  if (!width || !height || !most || *most == 0) return "its header is not that of a PGM or PPM";
  if (*most > 255) return "values of 16 bits in PGM and PPM are not read";
  const std::size_t channels = bytes[1] == std::byte{'6'} ? 3 : 1;
  const bool holds_all = !rest.empty() && rest.size() - 1 >= channels * *width * *height;
  return holds_all ? std::string_view() : kTooMuch;
}

}  // namespace

std::string_view decoding_hazard(Bytes bytes) {
  constexpr std::byte kPng{0x89};
  const auto is_at = [&](std::size_t place, char c) {
    return place < bytes.size() && bytes[place] == static_cast<std::byte>(c);
  };
  if (bytes.empty()) return {};
  if (bytes.front() == kMarker) return is_safe_jpeg(bytes) ? std::string_view() : kTooMuch;
  if (bytes.front() == kPng) return is_safe_png(bytes) ? std::string_view() : kTooMuch;
  if (is_at(0, 'B') && is_at(1, 'M')) return bmp_hazard(bytes);
  if (is_at(0, 'P') && (is_at(1, '5') || is_at(1, '6'))) return pnm_hazard(bytes);
  return {};
}

}  // namespace mes
