// SPDX-License-Identifier: GPL-3.0-or-later
// PNG and JPEG files to trace.
#include <span>

#include "render/picture_file.h"
#include "render/png.h"
#include "tests/fuzz/reader_checks.h"

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace mes::fuzz;
  // Pictures may be large by right, which takes time; a few bytes that announce one say nothing new.
  constexpr std::size_t kMostPixels = std::size_t{1} << 18U;
  const auto picture = mes::render::decode_picture(std::as_bytes(std::span(data, size)), "a.png", kMostPixels);
  require_little_memory(size + 40 * kMostPixels, 1);
  if (!picture) {
    require_error(picture.error(), text_of(data, size));
    return 0;
  }
  const auto pixels = static_cast<std::size_t>(picture->width) * static_cast<std::size_t>(picture->height);
  require(picture->width > 0 && picture->height > 0 && picture->rgba.size() == 4 * pixels && pixels <= kMostPixels,
          "a picture has its pixels");
  const auto written = mes::render::encode_png(*picture);
  require(written.has_value(), "a picture can be written");
  require(require_read(mes::render::decode_picture(*written, "again.png")) == *picture,
          "what is written reads back equal");
  const mes::render::Image small = mes::render::reduced(*picture, 16);
  require(small.width > 0 && small.height > 0 && small.width <= 16 && small.height <= 16,
          "a reduced picture is within its limit");
  return 0;
}
