// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/image/picture_file.h"

#include <algorithm>
#include <cstdint>
#include <fstream>
#include <iterator>
#include <new>
#include <utility>
#include <vector>

#include "core/base/lower_case.h"

namespace mes::render {
namespace {

constexpr std::uintmax_t kLargestFile = std::uintmax_t{1} << 28U;

std::unexpected<Error> fail(std::string text, const std::string& name, ErrorCode code = ErrorCode::bad_input) {
  return std::unexpected(Error{code, std::move(text), name});
}

/// Replaces two by two pixels by one; the last row or column of an odd size counts twice.
Image halved(const Image& image) {
  Image out{.width = (image.width + 1) / 2, .height = (image.height + 1) / 2, .rgba = {}};
  out.rgba.resize(4 * static_cast<std::size_t>(out.width) * static_cast<std::size_t>(out.height));
  for (int y = 0; y < out.height; ++y) {
    for (int x = 0; x < out.width; ++x) {
      unsigned sum[3] = {0, 0, 0};
      unsigned alpha = 0;
      for (int k = 0; k < 4; ++k) {
        const int from_x = std::min(2 * x + k % 2, image.width - 1);
        const int from_y = std::min(2 * y + k / 2, image.height - 1);
        const std::uint8_t* const from = &image.rgba[image.offset(from_x, from_y)];
        for (int channel = 0; channel < 3; ++channel) sum[channel] += unsigned{from[channel]} * from[3];
        alpha += from[3];
      }
      std::uint8_t* const to = &out.rgba[out.offset(x, y)];
      for (int channel = 0; channel < 3; ++channel)
        to[channel] = alpha == 0 ? std::uint8_t{0} : static_cast<std::uint8_t>((sum[channel] + alpha / 2) / alpha);
      to[3] = static_cast<std::uint8_t>((alpha + 2) / 4);
    }
  }
  return out;
}

}  // namespace

Expected<Image> decode_picture(std::span<const std::byte> bytes, const std::string& name, std::size_t most_pixels,
                               PictureTurn turn) {
  auto pixels = decode_pixels(bytes, name, 4, most_pixels, turn);
  if (!pixels) return std::unexpected(std::move(pixels.error()));
  return Image{.width = pixels->width, .height = pixels->height, .rgba = std::move(pixels->values)};
}

Expected<Image> read_picture(const std::filesystem::path& file, PictureTurn turn) {
  std::error_code error;
  if (!std::filesystem::exists(file, error)) return fail("there is no such file", file.string());
  // This also avoids blocking on pipes and devices.
  if (!std::filesystem::is_regular_file(file, error)) return fail("not a regular file", file.string());
  const std::uintmax_t size = std::filesystem::file_size(file, error);
  if (error) return fail("cannot be read: " + error.message(), file.string());
  if (size > kLargestFile) return fail("far too large for a picture", file.string());
  try {
    std::vector<std::byte> bytes(static_cast<std::size_t>(size));
    std::ifstream stream(file, std::ios::binary);
    stream.read(reinterpret_cast<char*>(bytes.data()), static_cast<std::streamsize>(size));
    if (!stream) return fail("cannot be read", file.string());
    return decode_picture(bytes, file.string(), kMostPicturePixels, turn);
  } catch (const std::bad_alloc&) {
    return fail("there is not enough memory for it", file.string(), ErrorCode::out_of_memory);
  }
}

bool is_picture_file(const std::filesystem::path& file) {
  const std::string extension = lower_case_extension(file);
  return std::ranges::find(kPictureExtensions, extension) != std::end(kPictureExtensions);
}

Image reduced(Image image, int limit) {
  while (std::max(image.width, image.height) > std::max(limit, 1)) image = halved(image);
  return image;
}

}  // namespace mes::render
