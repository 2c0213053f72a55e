// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/raster/picture_decoder.h"

#include <fmt/core.h>
#include <algorithm>
#include <array>
#include <cstdlib>
#include <limits>
#include <memory>
#include <new>
#include <utility>
#include <vector>

#include "core/raster/internal/netpbm.h"
#include "core/raster/internal/orientation.h"
#include "core/raster/picture_guard.h"

#define STB_IMAGE_STATIC
#define STB_IMAGE_IMPLEMENTATION
#define STBI_ONLY_PNG
#define STBI_ONLY_JPEG
#define STBI_ONLY_BMP
#define STBI_NO_STDIO
#define STBI_FAILURE_USERMSG
#define STBI_MAX_DIMENSIONS 32768
#define STBI_MALLOC(size) allocate_zeros(size)
#define STBI_REALLOC(block, size) std::realloc(block, size)
#define STBI_FREE(block) std::free(block)

namespace {

/// stb_image 2.27 decodes with the Huffman tables of a JPEG whether or not the file has defined them. Zeros are a table
/// in which each code is the symbol 0; uninitialized memory would be a table with symbols out of range.
void* allocate_zeros(std::size_t bytes) {
  return std::calloc(1, bytes);
}

}  // namespace

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

std::unexpected<Error> fail(std::string text, const std::string& name, ErrorCode code = ErrorCode::bad_input) {
  return std::unexpected(Error{code, std::move(text), name});
}

/// a b / 255, rounded, for values up to 255.
unsigned product(unsigned a, unsigned b) {
  return (a * b + 127) / 255;
}

/// Weights of Rec. 709 in units of 1/256, rounded so that white stays white.
unsigned luma(const std::uint8_t* rgb) {
  return (54U * rgb[0] + 183U * rgb[1] + 19U * rgb[2] + 128U) / 256U;
}

bool is_silhouette_in_alpha(const Pixels& pixels) {
  const auto each = static_cast<std::size_t>(pixels.channels);
  std::size_t clear = 0;
  for (std::size_t i = each - 1; i < pixels.values.size(); i += each) clear += pixels.values[i] < 128 ? 1U : 0U;
  return 100 * clear >= pixels.values.size() / each;
}

/// Grey is the same in red, green and blue; pixels without alpha are opaque.
Pixels with_channels(Pixels pixels, int channels) {
  if (pixels.channels == channels) return pixels;
  const auto from = static_cast<std::size_t>(pixels.channels);
  const auto to = static_cast<std::size_t>(channels);
  const bool had_color = pixels.channels >= 3;
  const bool has_color = channels >= 3;
  const std::size_t count = pixels.values.size() / from;
  std::vector<std::uint8_t> values(count * to);
  for (std::size_t i = 0; i < count; ++i) {
    const std::uint8_t* const in = &pixels.values[from * i];
    std::uint8_t* const out = &values[to * i];
    if (has_color)
      for (std::size_t k = 0; k < 3; ++k) out[k] = in[had_color ? k : 0];
    else
      out[0] = had_color ? static_cast<std::uint8_t>(luma(in)) : in[0];
    if (channels % 2 == 0) out[to - 1] = pixels.channels % 2 == 0 ? in[from - 1] : std::uint8_t{255};
  }
  pixels.channels = channels;
  pixels.values = std::move(values);
  return pixels;
}

/// A decoder that lacks data reads beyond the end. So a picture is complete if it does not depend on what is there.
Expected<Pixels> decode_without_end(std::span<const std::byte> bytes, const std::string& name, int channels,
                                    std::size_t most_pixels, PictureTurn turn) {
  const auto followed_by = [&](std::byte what) {
    constexpr std::size_t kLookedAhead = 64;  // more than a decoder reads ahead
    std::vector<std::byte> all(bytes.begin(), bytes.end());
    while (all.back() == std::byte{0xFF}) all.pop_back();  // half a marker
    all.insert(all.end(), kLookedAhead, what);
    all.insert(all.end(), {std::byte{0xFF}, std::byte{0xD9}});
    return decode_pixels(all, name, channels, most_pixels, turn);
  };
  try {
    // Runs of zeros and ones of several lengths, and a pattern that is in hardly any code table.
    auto out = followed_by(std::byte{0});
    for (const unsigned what : {0x55U, 0xAAU, 0x33U, 0xFEU}) {
      if (!out && out.error().code != ErrorCode::bad_input) return out;
      const auto other = followed_by(static_cast<std::byte>(what));
      if (!other && other.error().code != ErrorCode::bad_input) return std::unexpected(other.error());
      if (!out || !other || out->values != other->values)
        return fail(
            fmt::format("the picture is broken: the file ends at byte {}, before its last pixels", bytes.size()),
            name);
    }
    out->lacks_end = true;
    return out;
  } catch (const std::bad_alloc&) {
    return fail("there is not enough memory for a picture without its end", name, ErrorCode::out_of_memory);
  }
}

}  // namespace

bool looks_like_picture(std::string_view bytes) {
  using namespace std::string_view_literals;
  constexpr std::array kBeginnings{"\x89PNG\r\n\x1a\n"sv, "\xFF\xD8\xFF"sv};
  for (const std::string_view beginning : kBeginnings)
    if (bytes.starts_with(beginning)) return true;
  if (looks_like_netpbm(bytes)) return true;
  // "BM", a size of four bytes, four zero bytes, and the offset of the pixels, which is below 65536.
  return bytes.size() >= 14 && bytes.starts_with("BM") && bytes.substr(6, 4) == "\0\0\0\0"sv &&
         bytes.substr(12, 2) == "\0\0"sv;
}

Expected<Pixels> decode_pixels(std::span<const std::byte> bytes, const std::string& name, int channels,
                               std::size_t most_pixels, PictureTurn turn) {
  if (bytes.size() > static_cast<std::size_t>(std::numeric_limits<int>::max())) return fail("far too large", name);
  const std::string_view text(reinterpret_cast<const char*>(bytes.data()), bytes.size());
  if (looks_like_netpbm(text) || text.starts_with("P5") || text.starts_with("P6")) {
    try {
      auto pixels = decode_netpbm(text, name, most_pixels);
      if (pixels && channels != 0) *pixels = with_channels(*std::move(pixels), channels);
      return pixels;
    } catch (const std::bad_alloc&) {
      return fail("there is not enough memory for the picture", name, ErrorCode::out_of_memory);
    }
  }
  if (const std::string hazard = decoding_hazard(bytes); !hazard.empty())
    return fail("the picture is broken: " + hazard, name);
  if (may_lack_only_end(bytes)) return decode_without_end(bytes, name, channels, most_pixels, turn);
  const auto* const data = reinterpret_cast<const stbi_uc*>(bytes.data());
  const auto size = static_cast<int>(bytes.size());
  Pixels out;
  int found = 0;
  if (stbi_info_from_memory(data, size, &out.width, &out.height, &found) == 0)
    return fail("this is not a PNG, JPEG, BMP or PGM picture", name);
  if (out.height < 0 && out.height > std::numeric_limits<int>::min())
    out.height = -out.height;  // BMP, rows from the top
  const std::string extent = fmt::format("{}x{}", out.width, out.height);
  if (out.width < 1 || out.height < 1) return fail("the picture is broken: it has " + extent + " pixels", name);
  if (out.width > kLongestPictureSide || out.height > kLongestPictureSide ||
      static_cast<std::size_t>(out.width) * static_cast<std::size_t>(out.height) > most_pixels)
    return fail("a picture of " + extent + " pixels is too large to trace", name);
  try {
    const std::unique_ptr<stbi_uc, FreePixels> pixels(
        stbi_load_from_memory(data, size, &out.width, &out.height, &found, channels));
    if (!pixels) {
      const std::string place = place_of_damage(bytes);
      return fail("the picture is broken: " + (place.empty() ? stbi_failure_reason() : place), name);
    }
    out.channels = channels == 0 ? found : channels;
    const int orientation = turn == PictureTurn::upright ? orientation_of(bytes) : 1;
    out.values = upright(pixels.get(), out.width, out.height, out.channels, orientation);
    if (swaps_sides(orientation)) std::swap(out.width, out.height);
    return out;
  } catch (const std::bad_alloc&) {
    return fail("there is not enough memory for a picture of " + extent + " pixels", name, ErrorCode::out_of_memory);
  }
}

GrayImage gray_of(Pixels pixels) {
  GrayImage out{pixels.width, pixels.height, {}};
  if (pixels.channels == 1) {
    out.values = std::move(pixels.values);
    return out;
  }
  const auto each = static_cast<std::size_t>(pixels.channels);
  const bool has_color = pixels.channels >= 3;
  const bool has_alpha = pixels.channels % 2 == 0;
  const bool is_alpha = has_alpha && is_silhouette_in_alpha(pixels);
  out.values.resize(pixels.values.size() / each);
  for (std::size_t i = 0; i < out.values.size(); ++i) {
    const std::uint8_t* const pixel = &pixels.values[each * i];
    const unsigned alpha = has_alpha ? pixel[each - 1] : 255U;
    unsigned value = alpha;
    if (!is_alpha) {
      const unsigned lightness = has_color ? luma(pixel) : pixel[0];
      value = alpha == 255U ? lightness : product(lightness, alpha) + (255U - alpha);
    }
    out.values[i] = static_cast<std::uint8_t>(std::min(value, 255U));
  }
  return out;
}

}  // namespace mes
