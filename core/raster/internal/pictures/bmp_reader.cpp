// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/raster/internal/pictures/bmp_reader.h"

#include <fmt/core.h>
#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <limits>
#include <memory>
#include <optional>

#define STB_IMAGE_STATIC
#define STB_IMAGE_IMPLEMENTATION
#define STBI_ONLY_BMP
#define STBI_NO_STDIO
#define STBI_FAILURE_USERMSG
#define STBI_MAX_DIMENSIONS 32768

// One of our macros ends in a call, so the compiler attributes the old-style casts of the library to us.
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wold-style-cast"
#include <stb_image.h>
#pragma GCC diagnostic pop

namespace mes {
namespace {

struct FreePixels {
  void operator()(stbi_uc* pixels) const { stbi_image_free(pixels); }
};

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

}  // namespace

Expected<Pixels> read_bmp(Bytes bytes, const std::string& name, std::size_t most_pixels) {
  const auto* const data = reinterpret_cast<const stbi_uc*>(bytes.data());
  const auto size = static_cast<int>(std::min<std::size_t>(bytes.size(), std::numeric_limits<int>::max()));
  Pixels out;
  if (const std::string hazard = bmp_hazard(bytes); !hazard.empty())
    return std::unexpected(broken_picture(hazard, name));
  if (stbi_info_from_memory(data, size, &out.width, &out.height, &out.channels) == 0)
    return std::unexpected(broken_picture(stbi_failure_reason(), name));
  // Rows from the top have a negative height.
  if (auto refused =
          refused_size(static_cast<std::size_t>(out.width),
                       static_cast<std::size_t>(std::abs(static_cast<std::int64_t>(out.height))), most_pixels, name))
    return std::unexpected(*std::move(refused));
  const std::unique_ptr<stbi_uc, FreePixels> pixels(
      stbi_load_from_memory(data, size, &out.width, &out.height, &out.channels, 0));
  if (!pixels) return std::unexpected(broken_picture(stbi_failure_reason(), name));
  out.values.assign(pixels.get(), pixels.get() + static_cast<std::size_t>(out.width) *
                                                     static_cast<std::size_t>(out.height) *
                                                     static_cast<std::size_t>(out.channels));
  return out;
}

}  // namespace mes
