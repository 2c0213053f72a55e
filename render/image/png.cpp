// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/image/png.h"

#include <libdeflate.h>

#include <algorithm>
#include <cstdlib>
#include <cstring>
#include <limits>
#include <memory>
#include <mutex>
#include <span>

#include "core/base/carried_session.h"

namespace {

struct FreeCompressor {
  void operator()(libdeflate_compressor* compressor) const { libdeflate_free_compressor(compressor); }
};

struct FreeBytes {
  void operator()(unsigned char* bytes) const { std::free(bytes); }
};

/// The compression level for this thread's picture; the writer's own setting is one variable for all threads.
thread_local int level_now = 1;

/// The PNG writer calls this instead of its own compressor, and releases the result with std::free.
unsigned char* compress_with_libdeflate(unsigned char* data, int size, int* out_size, int /*its level*/) {
  const std::unique_ptr<libdeflate_compressor, FreeCompressor> compressor(
      libdeflate_alloc_compressor(std::clamp(level_now, 1, 12)));
  if (!compressor) return nullptr;
  const auto bytes = static_cast<std::size_t>(size);
  const std::size_t bound = libdeflate_zlib_compress_bound(compressor.get(), bytes);
  auto* out = static_cast<unsigned char*>(std::malloc(bound));
  if (out == nullptr) return nullptr;
  const std::size_t written = libdeflate_zlib_compress(compressor.get(), data, bytes, out, bound);
  if (written == 0 || written > static_cast<std::size_t>(std::numeric_limits<int>::max())) {
    std::free(out);
    return nullptr;
  }
  *out_size = static_cast<int>(written);
  return out;
}

}  // namespace

#define STBIW_ZLIB_COMPRESS compress_with_libdeflate
#define STB_IMAGE_WRITE_STATIC
#define STB_IMAGE_WRITE_IMPLEMENTATION
#define STBI_WRITE_NO_STDIO
#include <stb_image_write.h>

namespace mes::render {
namespace {

Error out_of_memory() {
  return {.code = ErrorCode::out_of_memory, .text = "not enough memory to write the picture as PNG"};
}

void append_number(std::vector<std::byte>& out, std::uint32_t number) {
  for (const unsigned shift : {24U, 16U, 8U, 0U}) out.push_back(static_cast<std::byte>(number >> shift & 0xffU));
}

/// Inserts a compressed iTXt chunk after the header, before all pixels. Source: PNG (ISO/IEC 15948), 5.3 and 11.3.4.5.
void insert_session(std::vector<std::byte>& png, std::string_view session) {
  constexpr std::ptrdiff_t kAfterHeader = 33;
  const auto bytes_of = [](std::string_view text) {
    const auto* const first = reinterpret_cast<const std::byte*>(text.data());
    return std::span(first, text.size());
  };
  std::vector<std::byte> chunk;
  const auto append = [&](std::string_view text) {
    const auto bytes = bytes_of(text);
    chunk.insert(chunk.end(), bytes.begin(), bytes.end());
  };
  // After the keyword: zero, compressed, method zlib, no language, no translated keyword.
  constexpr std::string_view kMarks("\0\1\0\0\0", 5);
  append_number(chunk, static_cast<std::uint32_t>(kCarriedSession.size() + kMarks.size() + session.size()));
  append("iTXt");
  append(kCarriedSession);
  append(kMarks);
  append(session);
  append_number(chunk, libdeflate_crc32(0, chunk.data() + 4, chunk.size() - 4));
  png.insert(png.begin() + kAfterHeader, chunk.begin(), chunk.end());
}

}  // namespace

Expected<std::vector<std::byte>> encode_png(const Image& image, int level, std::string_view session) {
  const std::size_t pixels =
      static_cast<std::size_t>(std::max(image.width, 0)) * static_cast<std::size_t>(std::max(image.height, 0));
  if (pixels == 0 || image.rgba.size() != 4 * pixels) {
    return std::unexpected(Error{.code = ErrorCode::usage, .text = "a picture needs at least one pixel"});
  }
  // The writer stores the byte count of raw lines with their filters in an int.
  if (4 * pixels + static_cast<std::size_t>(image.height) >
      static_cast<std::size_t>(std::numeric_limits<int>::max())) {
    return std::unexpected(
        Error{.code = ErrorCode::usage, .text = "the picture is too large for PNG (2 GiB of pixels)"});
  }
  try {
    bool opaque = true;
    for (std::size_t i = 3; i < image.rgba.size() && opaque; i += 4) opaque = image.rgba[i] == 255;
    std::vector<std::uint8_t> rgb;
    if (opaque) {
      rgb.resize(3 * pixels);
      for (std::size_t i = 0; i < pixels; ++i) std::copy_n(&image.rgba[4 * i], 3, &rgb[3 * i]);
    }
    const int channels = opaque ? 3 : 4;
    const std::uint8_t* source = opaque ? rgb.data() : image.rgba.data();

    // Differences from the left neighbour suit lines on a plain background, and are cheap.
    static std::once_flag filter_chosen;
    std::call_once(filter_chosen, [] { stbi_write_force_png_filter = 1; });
    level_now = level;
    int size = 0;
    const std::unique_ptr<unsigned char, FreeBytes> png(
        stbi_write_png_to_mem(source, image.width * channels, image.width, image.height, channels, &size));
    if (!png) return std::unexpected(out_of_memory());
    std::vector<std::byte> out(static_cast<std::size_t>(size));
    std::memcpy(out.data(), png.get(), out.size());
    if (!session.empty()) insert_session(out, session);
    return out;
  } catch (const std::bad_alloc&) {
    return std::unexpected(out_of_memory());
  }
}

}  // namespace mes::render
