// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/raster/internal/pictures/orientation.h"

#include <algorithm>
#include <array>
#include <cstring>
#include <optional>
#include <string_view>

#include "core/base/zlib.h"
#include "core/raster/internal/pictures/bytes.h"

namespace mes {
namespace {

bool begins_with(Bytes bytes, std::string_view text) {
  return bytes.size() >= text.size() && std::memcmp(bytes.data(), text.data(), text.size()) == 0;
}

/// Numbers of a TIFF, in either order of bytes.
class Tiff {
 public:
  static std::optional<Tiff> of(Bytes bytes) {
    using namespace std::string_view_literals;
    if (begins_with(bytes, "II*\0"sv)) return Tiff(bytes, true);
    if (begins_with(bytes, "MM\0*"sv)) return Tiff(bytes, false);
    return std::nullopt;
  }

  std::optional<std::size_t> number(std::size_t at, std::size_t count) const {
    if (at > bytes_.size() || count > bytes_.size() - at) return std::nullopt;
    std::size_t out = 0;
    for (std::size_t i = 0; i < count; ++i)
      out = out << 8U | std::to_integer<std::size_t>(bytes_[at + (is_little_ ? count - 1 - i : i)]);
    return out;
  }

 private:
  Tiff(Bytes bytes, bool is_little) : bytes_(bytes), is_little_(is_little) {}
  Bytes bytes_;
  bool is_little_;
};

/// The orientation in the first directory, which describes the picture; later ones describe thumbnails.
std::optional<int> orientation_in_tiff(Bytes bytes) {
  constexpr std::size_t kTag = 0x0112;
  constexpr std::size_t kEntry = 12;
  constexpr std::size_t kValue = 8;  // offset in an entry
  const auto tiff = Tiff::of(bytes);
  if (!tiff) return std::nullopt;
  const auto directory = tiff->number(4, 4);
  const auto entries = directory ? tiff->number(*directory, 2) : std::nullopt;
  if (!entries) return std::nullopt;
  for (std::size_t i = 0; i < *entries; ++i) {
    const std::size_t entry = *directory + 2 + kEntry * i;
    const auto tag = tiff->number(entry, 2);
    if (!tag) return std::nullopt;
    if (*tag != kTag) continue;
    constexpr std::array<std::size_t, 5> kSizes{0, 1, 0, 2, 4};  // bytes of byte, short and long values, by type
    const std::size_t type = tiff->number(entry + 2, 2).value_or(0);
    const std::size_t size = type < kSizes.size() ? kSizes[type] : 0;
    const std::size_t value = size == 0 ? 0 : tiff->number(entry + kValue, size).value_or(0);
    if (tiff->number(entry + 4, 4).value_or(0) != 1 || value < 1 || value > 8) return std::nullopt;
    return static_cast<int>(value);
  }
  return std::nullopt;
}

std::size_t big_endian(Bytes bytes, std::size_t count) {
  std::size_t out = 0;
  for (std::size_t i = 0; i < count; ++i) out = out << 8U | std::to_integer<std::size_t>(bytes[i]);
  return out;
}

constexpr std::string_view kExif("Exif\0", 5);  // followed by a fill byte

std::optional<int> orientation_in_jpeg(Bytes bytes) {
  constexpr unsigned kApplication = 0xE1;
  constexpr unsigned kScan = 0xDA;
  constexpr unsigned kEnd = 0xD9;
  Bytes rest = without_first(bytes, 2);
  while (rest.size() >= 4) {
    if (rest[0] != std::byte{0xFF}) return std::nullopt;
    const auto marker = std::to_integer<unsigned>(rest[1]);
    if (marker == 0xFF) {  // a fill byte
      rest = rest.subspan(1);
      continue;
    }
    if (marker == kScan || marker == kEnd) return std::nullopt;
    if (marker == 0x01 || (marker >= 0xD0 && marker <= 0xD8)) {  // markers without a segment
      rest = rest.subspan(2);
      continue;
    }
    const std::size_t length = big_endian(rest.subspan(2), 2);
    if (length < 2 || length > rest.size() - 2) return std::nullopt;
    const Bytes contents = rest.subspan(4, length - 2);
    if (marker == kApplication && begins_with(contents, kExif))
      if (const auto found = orientation_in_tiff(without_first(contents, kExif.size() + 1))) return found;
    rest = rest.subspan(2 + length);
  }
  return std::nullopt;
}

/// A chunk with a wrong checksum is ignored.
std::optional<int> orientation_in_png(Bytes bytes) {
  constexpr std::size_t kSignature = 8;
  constexpr std::size_t kBeforeContents = 8;
  constexpr std::size_t kChecksum = 4;
  Bytes rest = without_first(bytes, kSignature);
  while (rest.size() >= kBeforeContents + kChecksum) {
    const std::size_t length = big_endian(rest, 4);
    if (length > rest.size() - kBeforeContents - kChecksum) return std::nullopt;
    const Bytes name = rest.subspan(4);
    if (begins_with(name, "IEND")) return std::nullopt;
    if (begins_with(name, "eXIf")) {
      const Bytes checked = name.first(4 + length);
      const std::size_t checksum = big_endian(rest.subspan(kBeforeContents + length), kChecksum);
      Bytes contents = rest.subspan(kBeforeContents, length);
      if (begins_with(contents, kExif)) contents = without_first(contents, kExif.size() + 1);  // some add it
      if (crc32_of({reinterpret_cast<const char*>(checked.data()), checked.size()}) == checksum)
        if (const auto found = orientation_in_tiff(contents)) return found;
    }
    rest = rest.subspan(kBeforeContents + length + kChecksum);
  }
  return std::nullopt;
}

/// Storage order of the upright picture: offset of its first pixel, and steps to the next one in a row and in a column.
struct Way {
  std::ptrdiff_t first = 0;
  std::ptrdiff_t along_row = 0;
  std::ptrdiff_t along_column = 0;
};

Way way_of(std::ptrdiff_t width, std::ptrdiff_t height, int orientation) {
  const std::ptrdiff_t end_of_row = width - 1;
  const std::ptrdiff_t last_row = (height - 1) * width;
  switch (orientation) {
    case 2: return {end_of_row, -1, width};
    case 3: return {last_row + end_of_row, -1, -width};
    case 4: return {last_row, 1, -width};
    case 5: return {0, width, 1};
    case 6: return {last_row, -width, 1};
    case 7: return {last_row + end_of_row, -width, -1};
    case 8: return {end_of_row, width, -1};
    default: return {0, 1, width};
  }
}

/// Copies square by square, so that rows and columns both stay in the cache.
template <std::ptrdiff_t kChannels>
void turn(const std::uint8_t* from, std::uint8_t* to, std::ptrdiff_t width, std::ptrdiff_t height, const Way& way) {
  constexpr std::ptrdiff_t kSquare = 64;
  for (std::ptrdiff_t top = 0; top < height; top += kSquare)
    for (std::ptrdiff_t left = 0; left < width; left += kSquare)
      for (std::ptrdiff_t y = top; y < std::min(height, top + kSquare); ++y)
        for (std::ptrdiff_t x = left; x < std::min(width, left + kSquare); ++x) {
          const std::uint8_t* const pixel = from + kChannels * (way.first + x * way.along_row + y * way.along_column);
          std::copy_n(pixel, kChannels, to + kChannels * (y * width + x));
        }
}

}  // namespace

int orientation_of(Bytes bytes) {
  if (begins_with(bytes, "\xFF\xD8")) return orientation_in_jpeg(bytes).value_or(1);
  if (begins_with(bytes, "\x89PNG")) return orientation_in_png(bytes).value_or(1);
  return 1;
}

std::vector<std::uint8_t> upright(const std::uint8_t* pixels, int width, int height, int channels, int orientation) {
  const std::size_t count =
      static_cast<std::size_t>(channels) * static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
  if (orientation <= 1 || orientation > 8) return {pixels, pixels + count};
  std::vector<std::uint8_t> out(count);
  const Way way = way_of(width, height, orientation);
  const std::ptrdiff_t across = swaps_sides(orientation) ? height : width;
  const std::ptrdiff_t down = swaps_sides(orientation) ? width : height;
  switch (channels) {
    case 1: turn<1>(pixels, out.data(), across, down, way); break;
    case 2: turn<2>(pixels, out.data(), across, down, way); break;
    case 3: turn<3>(pixels, out.data(), across, down, way); break;
    default: turn<4>(pixels, out.data(), across, down, way); break;
  }
  return out;
}

}  // namespace mes
