// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/zlib.h"

#include <libdeflate.h>

#include <algorithm>
#include <memory>
#include <new>

namespace mes {

std::string zlib_compressed(std::string_view bytes, ZlibEffort effort) {
  const int level = effort == ZlibEffort::fast ? 1 : 6;
  const std::unique_ptr<libdeflate_compressor, decltype(&libdeflate_free_compressor)> compressor(
      libdeflate_alloc_compressor(level), libdeflate_free_compressor);
  if (!compressor) throw std::bad_alloc();
  std::string out(libdeflate_zlib_compress_bound(compressor.get(), bytes.size()), '\0');
  out.resize(libdeflate_zlib_compress(compressor.get(), bytes.data(), bytes.size(), out.data(), out.size()));
  return out;
}

std::uint32_t crc32_of(std::string_view bytes) {
  return libdeflate_crc32(0, bytes.data(), bytes.size());
}

namespace {

using Expansion = decltype(&libdeflate_zlib_decompress_ex);

Expected<std::string> expanded(Expansion expand, std::string_view bytes, std::size_t most) {
  const std::unique_ptr<libdeflate_decompressor, decltype(&libdeflate_free_decompressor)> decompressor(
      libdeflate_alloc_decompressor(), libdeflate_free_decompressor);
  if (!decompressor) throw std::bad_alloc();
  // A zlib stream does not store its expanded size, and what a file of gzip stores may be wrong.
  constexpr std::size_t kFirstGuess = 1U << 16U;
  std::string out;
  for (std::size_t room = std::min(kFirstGuess, most);; room = std::min(4 * room, most)) {
    out.resize(room);
    std::size_t read = 0, written = 0;
    switch (expand(decompressor.get(), bytes.data(), bytes.size(), out.data(), room, &read, &written)) {
      case LIBDEFLATE_SUCCESS: out.resize(written); return out;
      case LIBDEFLATE_INSUFFICIENT_SPACE:
        if (room < most) break;
        return std::unexpected(
            Error{.code = ErrorCode::bad_input,
                  .text = "compressed data hold more than " + std::to_string(most >> 20U) + " MiB"});
      default:
        return std::unexpected(Error{.code = ErrorCode::bad_input, .text = "compressed data are cut or broken"});
    }
  }
}

}  // namespace

Expected<std::string> zlib_expanded(std::string_view bytes, std::size_t most) {
  return expanded(libdeflate_zlib_decompress_ex, bytes, most);
}

bool looks_like_gzip(std::string_view bytes) {
  return bytes.starts_with("\x1F\x8B");
}

Expected<std::string> gzip_expanded(std::string_view bytes, std::size_t most) {
  return expanded(libdeflate_gzip_decompress_ex, bytes, most);
}

}  // namespace mes
