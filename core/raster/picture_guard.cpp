// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/raster/picture_guard.h"

#include <fmt/core.h>
#include <algorithm>
#include <array>
#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

#include "core/base/zlib.h"
#include "core/raster/internal/bytes.h"

namespace mes {
namespace {

/// Offset of a part of the file.
std::size_t place_of(Bytes part, Bytes whole) {
  return static_cast<std::size_t>(part.data() - whole.data());
}

/// A number of `count` bytes, big-endian; bytes beyond the end count as zero.
std::size_t number(Bytes bytes, std::size_t count) {
  std::size_t out = 0;
  for (std::size_t i = 0; i < count; ++i)
    out = out << 8U | (i < bytes.size() ? std::to_integer<std::size_t>(bytes[i]) : 0U);
  return out;
}

// --- JPEG ---

constexpr std::byte kMarker{0xFF};

bool stands_alone(unsigned marker) {
  return (marker >= 0xD0 && marker <= 0xD9) || marker == 0x01;  // restart markers, begin and end of the picture
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

/// Tracks the coefficients covered by the scans of a JPEG. Source: ITU-T T.81, B.2.2, B.2.3 and G.1.1.
class ScannedCoefficients {
 public:
  void add_frame(Bytes contents, bool is_progressive) {
    constexpr std::size_t kHeader = 6;
    constexpr std::size_t kEach = 3;
    is_progressive_ = is_progressive;
    components_.clear();
    const std::size_t count = std::min(number(without_first(contents, kHeader - 1), 1), kMostComponents);
    for (std::size_t i = 0; i < count; ++i) {
      components_.push_back({.id = number(without_first(contents, kHeader + kEach * i), 1)});
      components_.back().bits_left.fill(kAll);
    }
  }
  void add_scan(Bytes contents) {
    const std::size_t count = std::min(number(contents, 1), kMostComponents);
    const Bytes limits = without_first(contents, 1 + 2 * count);
    const std::size_t first = is_progressive_ ? number(limits, 1) : 0;
    const std::size_t last = is_progressive_ ? number(without_first(limits, 1), 1) : kCoefficients - 1;
    const std::size_t bits = is_progressive_ ? number(without_first(limits, 2), 1) & 0xFU : 0;
    for (std::size_t i = 0; i < count; ++i)
      for (Component& component : components_)
        if (component.id == number(without_first(contents, 1 + 2 * i), 1))
          for (std::size_t k = first; k <= std::min(last, kCoefficients - 1); ++k)
            component.bits_left[k] = static_cast<std::uint8_t>(bits);
  }
  bool are_all() const {
    return !components_.empty() && std::ranges::all_of(components_, [](const Component& component) {
      return std::ranges::count(component.bits_left, 0) == std::ptrdiff_t{kCoefficients};
    });
  }

 private:
  static constexpr std::size_t kMostComponents = 4;
  static constexpr std::size_t kCoefficients = 64;
  static constexpr std::uint8_t kAll = 0xFF;
  struct Component {
    std::size_t id = 0;
    std::array<std::uint8_t, kCoefficients> bits_left{};
  };
  std::vector<Component> components_;
  bool is_progressive_ = false;
};

struct JpegMarkers {
  std::string hazard{};
  bool may_lack_only_end = false;
};

/// Walks from marker to marker. A marker is 0xFF followed by a byte that is neither zero (data) nor 0xFF (fill byte).
/// The decoder finds the same markers between segments, or it fails earlier.
JpegMarkers jpeg_markers(Bytes bytes) {
  constexpr unsigned kTables = 0xC4;
  constexpr unsigned kEnd = 0xD9;
  constexpr unsigned kScan = 0xDA;
  constexpr unsigned kRestartInterval = 0xDD;
  constexpr unsigned kFrame = 0xC0;
  constexpr unsigned kProgressiveFrame = 0xC2;
  ScannedCoefficients scanned;
  bool has_scan = false;
  bool has_restarts = false;
  bool is_cut = false;
  Bytes rest = bytes;
  for (;;) {
    while (rest.size() >= 2 && (rest[0] != kMarker || rest[1] == kMarker || rest[1] == std::byte{0}))
      rest = rest.subspan(1);
    if (rest.size() < 2) {
      if (!has_scan) return {};  // the decoder reports this
      // After the part between two restarts, the decoder does not check whether another follows.
      if (!is_cut && !has_restarts && scanned.are_all()) return {.may_lack_only_end = true};
      return {.hazard = fmt::format("the file ends at byte {}, before the marker that ends a picture", bytes.size())};
    }
    const std::size_t place = place_of(rest, bytes);
    const auto marker = std::to_integer<unsigned>(rest[1]);
    rest = rest.subspan(2);
    if (marker == kEnd && has_scan) return {};
    has_scan = has_scan || marker == kScan;
    if (stands_alone(marker)) continue;
    const std::size_t length = std::max<std::size_t>(number(rest, 2), 2);
    if (marker == kRestartInterval) has_restarts = has_restarts || number(without_first(rest, 2), 2) != 0;
    if (marker == kTables && !are_tables_sound(without_first(rest, 2), length - 2))
      return {.hazard = fmt::format("at byte {}: a table of codes announces more symbols than there are", place)};
    is_cut = length > rest.size();
    const Bytes contents = without_first(rest.first(std::min(length, rest.size())), 2);
    if (marker >= kFrame && marker <= kProgressiveFrame) scanned.add_frame(contents, marker == kProgressiveFrame);
    if (marker == kScan) scanned.add_scan(contents);
    rest = without_first(rest, length);
  }
}

// --- PNG ---

constexpr std::size_t kSignature = 8;
constexpr std::size_t kBeforeContents = 8;
constexpr std::size_t kChecksum = 4;
constexpr std::size_t kEnd = 0x49454E44;

/// Chunks consist of length, name, contents and checksum.
std::string png_hazard(Bytes bytes) {
  Bytes rest = without_first(bytes, kSignature);
  while (rest.size() >= kBeforeContents) {
    const std::size_t length = number(rest, 4);
    if (number(rest.subspan(4), 4) == kEnd) return {};
    if (length > rest.size() - kBeforeContents)
      return fmt::format("at byte {}: a chunk announces {} bytes, and the file ends after {}", place_of(rest, bytes),
                         length, rest.size() - kBeforeContents);
    rest = without_first(rest, kBeforeContents + length + kChecksum);
  }
  return {};
}

/// Describes the first chunk that is truncated or has a wrong checksum.
std::string png_damage(Bytes bytes) {
  Bytes rest = without_first(bytes, kSignature);
  while (!rest.empty()) {
    const std::size_t length = number(rest, 4);
    if (rest.size() < kBeforeContents + kChecksum || length > rest.size() - kBeforeContents - kChecksum)
      return fmt::format("the file ends within the chunk at byte {}", place_of(rest, bytes));
    const Bytes checked = rest.subspan(4, 4 + length);
    const Bytes checksum = rest.subspan(kBeforeContents + length, kChecksum);
    if (crc32_of({reinterpret_cast<const char*>(checked.data()), checked.size()}) != number(checksum, kChecksum))
      return fmt::format("the chunk at byte {} does not fit its checksum", place_of(rest, bytes));
    if (number(rest.subspan(4), 4) == kEnd) return {};
    rest = rest.subspan(kBeforeContents + length + kChecksum);
  }
  return fmt::format("the file ends at byte {}, before the chunk that ends a picture", bytes.size());
}

// --- BMP ---

std::size_t little_endian(Bytes bytes, std::size_t count) {
  std::size_t out = 0;
  for (std::size_t i = count; i > 0; --i)
    out = out << 8U | (i <= bytes.size() ? std::to_integer<std::size_t>(bytes[i - 1]) : 0U);
  return out;
}

/// The first byte with a number of `bits` bits that is at least `end`.
std::optional<std::size_t> first_index_from(std::size_t end, Bytes bytes, unsigned bits) {
  for (std::size_t i = 0; i < bytes.size(); ++i)
    for (unsigned shift = 0; shift < 8; shift += bits)
      if ((std::to_integer<std::size_t>(bytes[i]) >> shift & ((std::size_t{1} << bits) - 1U)) >= end) return i;
  return std::nullopt;
}

std::string ends_in_row(std::size_t row, std::size_t rows) {
  return fmt::format("the file ends in row {} of {}", row + 1, rows);
}

/// The decoder reads everything between header and pixels as the palette. It reads colours beyond the palette's end
/// from uninitialized memory, and zeros beyond the end of the file.
std::string bmp_hazard(Bytes bytes) {
  constexpr std::size_t kFileHeader = 14;
  constexpr std::size_t kOldHeader = 12;  // header size of OS/2; the decoder assumes a longer one
  constexpr std::size_t kMostSide = std::size_t{1} << 16U;
  const std::size_t offset = little_endian(without_first(bytes, 10), 4);
  const std::size_t header = little_endian(without_first(bytes, kFileHeader), 4);
  const bool is_old = header == kOldHeader;
  const Bytes rest = without_first(bytes, kFileHeader + 4);
  const std::size_t width = little_endian(rest, is_old ? 2 : 4);
  std::size_t height = little_endian(without_first(rest, is_old ? 2 : 4), is_old ? 2 : 4);
  if (height > 0x7FFFFFFFU) height = 0x100000000U - height;  // negative: rows from the top
  const std::size_t bits = little_endian(without_first(rest, is_old ? 6 : 10), 2);
  if (width >= kMostSide || height >= kMostSide || bits == 0 || bits > 32) return {};  // refused by the decoder
  const std::size_t row = (width * bits + 31) / 32 * 4;
  if (offset < kFileHeader + header || offset > bytes.size())
    return fmt::format("at byte 10: its pixels cannot begin at byte {}", offset);
  if (bytes.size() - offset < row * height) return ends_in_row((bytes.size() - offset) / row, height);
  if (bits > 8) return {};
  const std::size_t colors =
      is_old ? (std::max<std::size_t>(offset, 38) - 38) / 3 : (offset - kFileHeader - header) / 4;
  if (bits != 1 && bits != 4 && bits != 8) return {};
  const auto beyond = first_index_from(colors, bytes.subspan(offset, row * height), static_cast<unsigned>(bits));
  return beyond ? fmt::format("at byte {}: there is a colour that its palette lacks", offset + *beyond)
                : std::string();
}

constexpr std::byte kPng{0x89};

}  // namespace

std::string decoding_hazard(Bytes bytes) {
  const auto is_at = [&](std::size_t place, char c) {
    return place < bytes.size() && bytes[place] == static_cast<std::byte>(c);
  };
  if (bytes.empty()) return {};
  if (bytes.front() == kMarker) return jpeg_markers(bytes).hazard;
  if (bytes.front() == kPng) return png_hazard(bytes);
  if (is_at(0, 'B') && is_at(1, 'M')) return bmp_hazard(bytes);
  return {};
}

bool may_lack_only_end(Bytes bytes) {
  return !bytes.empty() && bytes.front() == kMarker && jpeg_markers(bytes).may_lack_only_end;
}

std::string place_of_damage(Bytes bytes) {
  return !bytes.empty() && bytes.front() == kPng ? png_damage(bytes) : std::string();
}

}  // namespace mes
