// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/raster/picture_decoder.h"

#include <fmt/core.h>
#include <algorithm>
#include <array>
#include <new>
#include <optional>
#include <string_view>
#include <utility>
#include <vector>

#include "core/raster/internal/pictures/bmp_reader.h"
#include "core/raster/internal/pictures/jpeg_reader.h"
#include "core/raster/internal/pictures/netpbm.h"
#include "core/raster/internal/pictures/orientation.h"
#include "core/raster/internal/pictures/png_reader.h"

namespace mes {
namespace {

using namespace std::string_view_literals;

constexpr auto kPngBeginning = "\x89PNG\r\n\x1a\n"sv;
constexpr auto kJpegBeginning = "\xFF\xD8"sv;
constexpr auto kBmpBeginning = "BM"sv;

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

Expected<Pixels> read_picture(std::span<const std::byte> bytes, std::string_view text, const std::string& name,
                              std::size_t most_pixels, PictureTurn turn, const JobControl* job) {
  if (looks_like_netpbm(text) || text.starts_with("P5") || text.starts_with("P6"))
    return decode_netpbm(text, name, most_pixels);
  if (text.starts_with(kBmpBeginning)) return read_bmp(bytes, name, most_pixels);
  const bool is_png = text.starts_with(kPngBeginning);
  if (!is_png && !text.starts_with(kJpegBeginning)) return fail("this is not a PNG, JPEG, BMP or PGM picture", name);
  auto out = is_png ? read_png(bytes, name, most_pixels, job) : read_jpeg(bytes, name, most_pixels, job);
  const int orientation = turn == PictureTurn::upright ? orientation_of(bytes) : 1;
  if (!out || orientation == 1) return out;
  out->values = upright(out->values.data(), out->width, out->height, out->channels, orientation);
  if (swaps_sides(orientation)) std::swap(out->width, out->height);
  return out;
}

}  // namespace

std::optional<Error> refused_size(std::size_t width, std::size_t height, std::size_t most_pixels,
                                  const std::string& name) {
  const std::string extent = fmt::format("{}x{}", width, height);
  if (width == 0 || height == 0) return broken_picture("it has " + extent + " pixels", name);
  if (std::max(width, height) <= kLongestPictureSide && width * height <= most_pixels) return std::nullopt;
  return Error{ErrorCode::bad_input, "a picture of " + extent + " pixels is too large to trace", name};
}

Error broken_picture(const std::string& why, const std::string& name) {
  return {ErrorCode::bad_input, "the picture is broken: " + why, name};
}

bool looks_like_picture(std::string_view bytes) {
  if (bytes.starts_with(kPngBeginning) || bytes.starts_with("\xFF\xD8\xFF"sv) || looks_like_netpbm(bytes))
    return true;
  // "BM", a size of four bytes, four zero bytes, and the offset of the pixels, which is below 65536.
  return bytes.size() >= 14 && bytes.starts_with(kBmpBeginning) && bytes.substr(6, 4) == "\0\0\0\0"sv &&
         bytes.substr(12, 2) == "\0\0"sv;
}

Expected<Pixels> decode_pixels(std::span<const std::byte> bytes, const std::string& name, int channels,
                               std::size_t most_pixels, PictureTurn turn, const JobControl* job) {
  const std::string_view text(reinterpret_cast<const char*>(bytes.data()), bytes.size());
  try {
    auto pixels = read_picture(bytes, text, name, most_pixels, turn, job);
    if (pixels && channels != 0) *pixels = with_channels(*std::move(pixels), channels);
    return pixels;
  } catch (const std::bad_alloc&) {
    return fail("there is not enough memory for the picture", name, ErrorCode::out_of_memory);
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
