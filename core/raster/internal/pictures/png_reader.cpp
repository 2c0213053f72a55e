// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/raster/internal/pictures/png_reader.h"

#include <png.h>

#include <fmt/core.h>
#include <algorithm>
#include <array>
#include <csetjmp>
#include <cstdint>
#include <cstring>
#include <new>
#include <vector>

#include "core/base/zlib.h"

namespace mes {
namespace {

constexpr std::size_t kSignature = 8;
constexpr std::size_t kBeforeContents = 8;  // length and name of a chunk
constexpr std::size_t kChecksum = 4;

std::size_t big_endian(Bytes four) {
  std::size_t out = 0;
  for (const std::byte byte : four.first(4)) out = out << 8U | std::to_integer<std::size_t>(byte);
  return out;
}

/// The first chunk that is cut, or whose checksum does not fit its contents; empty if there is none.
std::string first_damage(Bytes bytes) {
  Bytes rest = without_first(bytes, kSignature);
  while (!rest.empty()) {
    const std::size_t position = bytes.size() - rest.size();
    if (rest.size() < kBeforeContents + kChecksum)
      return fmt::format("the file ends within the chunk at byte {}", position);
    const std::size_t length = big_endian(rest);
    if (length > rest.size() - kBeforeContents - kChecksum)
      return fmt::format("the file ends within the chunk at byte {}", position);
    const Bytes checked = rest.subspan(4, 4 + length);
    if (crc32_of({reinterpret_cast<const char*>(checked.data()), checked.size()}) !=
        big_endian(rest.subspan(kBeforeContents + length)))
      return fmt::format("the chunk at byte {} does not fit its checksum", position);
    if (std::memcmp(checked.data(), "IEND", 4) == 0) return {};
    rest = rest.subspan(kBeforeContents + length + kChecksum);
  }
  return fmt::format("the file ends at byte {}, before the chunk that ends a picture", bytes.size());
}

/// A call of libpng may jump out of `run`, which therefore owns nothing.
struct PngRun {
  Bytes rest;
  std::array<char, 120> message{};
  png_structp png = nullptr;
  png_infop info = nullptr;
  png_bytepp rows = nullptr;
  const JobControl* job = nullptr;
  bool is_stopped = false;
};

void fail_png(png_structp png, png_const_charp text) {
  auto& message = static_cast<PngRun*>(png_get_error_ptr(png))->message;
  std::strncpy(message.data(), text, message.size() - 1);
  png_longjmp(png, 1);
}

void ignore_warning(png_structp /*png*/, png_const_charp /*text*/) {}

void read_png_bytes(png_structp png, png_bytep to, std::size_t count) {
  Bytes& rest = static_cast<PngRun*>(png_get_io_ptr(png))->rest;
  if (count > rest.size()) png_error(png, "the file ends too early");
  std::memcpy(to, rest.data(), count);
  rest = rest.subspan(count);
}

void look_for_stop(png_structp png, png_uint_32 /*row*/, int /*pass*/) {
  PngRun& run = *static_cast<PngRun*>(png_get_error_ptr(png));
  run.is_stopped = run.job != nullptr && run.job->stop_requested();
  if (run.is_stopped) png_error(png, "it was stopped");
}

/// Calls `step(run)`; false if libpng has reported an error.
template <class Step>
bool succeeds(PngRun& run, Step step) {
  if (setjmp(png_jmpbuf(run.png)) != 0) return false;
  step(run);
  return true;
}

void read_png_header(PngRun& run) {
  png_set_read_fn(run.png, &run, read_png_bytes);
  png_set_read_status_fn(run.png, look_for_stop);
  png_set_user_limits(run.png, PNG_UINT_31_MAX, PNG_UINT_31_MAX);  // the caller's limits are checked next
  // All other chunks are skipped unread: texts and colour profiles may expand to any size.
  png_set_keep_unknown_chunks(run.png, PNG_HANDLE_CHUNK_NEVER, nullptr, -1);
  png_read_info(run.png, run.info);
  png_set_palette_to_rgb(run.png);
  png_set_expand_gray_1_2_4_to_8(run.png);
  if (png_get_valid(run.png, run.info, PNG_INFO_tRNS) != 0) png_set_tRNS_to_alpha(run.png);
  png_set_strip_16(run.png);
  png_set_interlace_handling(run.png);
  png_read_update_info(run.png, run.info);
}

struct DestroyPng {
  PngRun& run;
  ~DestroyPng() { png_destroy_read_struct(&run.png, &run.info, nullptr); }
};

}  // namespace

Expected<Pixels> read_png(Bytes bytes, const std::string& name, std::size_t most_pixels, const JobControl* job) {
  PngRun run{.rest = bytes, .job = job};
  run.png = png_create_read_struct(PNG_LIBPNG_VER_STRING, &run, fail_png, ignore_warning);
  const DestroyPng destroy{run};
  if (run.png != nullptr) run.info = png_create_info_struct(run.png);
  if (run.info == nullptr) throw std::bad_alloc();
  const auto broken = [&] {
    if (run.is_stopped) throw Cancelled{};
    const std::string place = first_damage(bytes);
    return std::unexpected(broken_picture(place.empty() ? run.message.data() : place, name));
  };
  if (!succeeds(run, read_png_header)) return broken();
  if (auto refused = refused_size(png_get_image_width(run.png, run.info), png_get_image_height(run.png, run.info),
                                  most_pixels, name))
    return std::unexpected(*std::move(refused));
  const std::size_t row = png_get_rowbytes(run.png, run.info);
  Pixels out{.width = static_cast<int>(png_get_image_width(run.png, run.info)),
             .height = static_cast<int>(png_get_image_height(run.png, run.info)),
             .channels = png_get_channels(run.png, run.info)};
  out.values.resize(row * static_cast<std::size_t>(out.height));
  std::vector<png_bytep> rows(static_cast<std::size_t>(out.height));
  for (std::size_t y = 0; y < rows.size(); ++y) rows[y] = out.values.data() + row * y;
  run.rows = rows.data();
  if (!succeeds(run, [](PngRun& in) { png_read_image(in.png, in.rows); })) return broken();
  return out;
}

}  // namespace mes
