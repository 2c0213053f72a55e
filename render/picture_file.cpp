// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/picture_file.h"

#include <fmt/core.h>
#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <fstream>
#include <limits>
#include <memory>
#include <new>
#include <vector>

#include "core/base/lower_case.h"
#include "render/picture_guard.h"

#define STB_IMAGE_STATIC
#define STB_IMAGE_IMPLEMENTATION
#define STBI_ONLY_PNG
#define STBI_ONLY_JPEG
#define STBI_NO_STDIO
#define STBI_FAILURE_USERMSG
#define STBI_MAX_DIMENSIONS 32768
#define STBI_MALLOC(size) allocate_zeros(size)
#define STBI_REALLOC(block, size) std::realloc(block, size)
#define STBI_FREE(block) std::free(block)

namespace {

/// stb_image 2.27 decodes with the Huffman tables of a JPEG whether or not the file has defined them. Zeros are a table
/// in which each code is the symbol 0; uninitialized memory is one whose symbols lie outside it.
void* allocate_zeros(std::size_t bytes) {
  return std::calloc(1, bytes);
}

}  // namespace

// A macro of ours that ends in a call lets the compiler take the old casts of the library for ours.
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wold-style-cast"
#include <stb_image.h>
#pragma GCC diagnostic pop

namespace mes::render {
namespace {

constexpr std::uintmax_t kLargestFile = std::uintmax_t{1} << 28U;

struct FreePixels {
  void operator()(stbi_uc* pixels) const { stbi_image_free(pixels); }
};

std::unexpected<Error> fail(std::string text, const std::string& name, ErrorCode code = ErrorCode::bad_input) {
  return std::unexpected(Error{code, std::move(text), name});
}

/// Two by two pixels become one; the last row or column of an odd size counts twice.
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

Expected<Image> decode_picture(std::span<const std::byte> bytes, const std::string& name, std::size_t most_pixels) {
  if (bytes.size() > static_cast<std::size_t>(std::numeric_limits<int>::max())) return fail("far too large", name);
  if (!is_safe_to_decode(bytes)) return fail("the picture is broken: it announces more than it can hold", name);
  const auto* const data = reinterpret_cast<const stbi_uc*>(bytes.data());
  const auto size = static_cast<int>(bytes.size());
  int width = 0;
  int height = 0;
  int channels = 0;
  if (stbi_info_from_memory(data, size, &width, &height, &channels) == 0)
    return fail("this is not a PNG or JPEG picture", name);
  const std::string extent = fmt::format("{}x{}", width, height);
  if (width < 1 || height < 1 || width > kLongestPictureSide || height > kLongestPictureSide ||
      static_cast<std::size_t>(width) * static_cast<std::size_t>(height) > most_pixels)
    return fail("a picture of " + extent + " pixels is too large to trace", name);
  try {
    const std::unique_ptr<stbi_uc, FreePixels> pixels(
        stbi_load_from_memory(data, size, &width, &height, &channels, 4));
    if (!pixels) return fail(std::string("the picture is broken: ") + stbi_failure_reason(), name);
    Image image{.width = width, .height = height, .rgba = {}};
    const std::size_t count = 4 * static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
    image.rgba.assign(pixels.get(), pixels.get() + count);
    return image;
  } catch (const std::bad_alloc&) {
    return fail("there is not enough memory for a picture of " + extent + " pixels", name, ErrorCode::out_of_memory);
  }
}

Expected<Image> read_picture(const std::filesystem::path& file) {
  std::error_code error;
  if (!std::filesystem::exists(file, error)) return fail("there is no such file", file.string());
  // Also keeps pipes and devices from being waited for.
  if (!std::filesystem::is_regular_file(file, error)) return fail("not a regular file", file.string());
  const std::uintmax_t size = std::filesystem::file_size(file, error);
  if (error) return fail("cannot be read: " + error.message(), file.string());
  if (size > kLargestFile) return fail("far too large for a picture", file.string());
  try {
    std::vector<std::byte> bytes(static_cast<std::size_t>(size));
    std::ifstream stream(file, std::ios::binary);
    stream.read(reinterpret_cast<char*>(bytes.data()), static_cast<std::streamsize>(size));
    if (!stream) return fail("cannot be read", file.string());
    return decode_picture(bytes, file.string());
  } catch (const std::bad_alloc&) {
    return fail("there is not enough memory for it", file.string(), ErrorCode::out_of_memory);
  }
}

bool is_picture_file(const std::filesystem::path& file) {
  const std::string extension = lower_case_extension(file);
  return extension == ".png" || extension == ".jpg" || extension == ".jpeg";
}

Image reduced(Image image, int limit) {
  while (std::max(image.width, image.height) > std::max(limit, 1)) image = halved(image);
  return image;
}

}  // namespace mes::render
