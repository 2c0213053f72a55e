// SPDX-License-Identifier: GPL-3.0-or-later
// PNG, JPEG, BMP and PGM files, to be traced by hand and by the program.
#include <algorithm>
#include <span>

#include "core/raster/trace.h"
#include "render/image/picture_file.h"
#include "render/image/png.h"
#include "tests/fuzz/reader_checks.h"

namespace mes::fuzz {
namespace {

// Pictures may be large by right, which takes time; a few bytes that announce one say nothing new.
constexpr std::size_t kMostPixels = std::size_t{1} << 18U;

/// Outlines end where they begin, and lie in the picture up to what smoothing moves them.
void check_tracing(const GrayImage& image, const TraceRequest& request) {
  const auto tracing = trace(image, request);
  if (!tracing) {
    require_message(tracing.error().text);
    return;
  }
  require_message(remark_of(*tracing));
  require(!tracing->curves.curves.empty(), "a tracing has an outline");
  for (const PlaneCurve& curve : tracing->curves.curves) {
    require(curve.is_closed(), "outlines are closed");
    curve.for_each_piece([&](const Piece& piece) {
      const Vec2 p = piece.to();
      require(p.x >= -1.0 && p.y >= -1.0 && p.x <= image.width + 1.0 && p.y <= image.height + 1.0,
              "outlines lie in the picture");
    });
  }
}

void check_traced(std::span<const std::byte> bytes) {
  auto pixels = decode_pixels(bytes, "a.png", 0, kMostPixels);
  if (!pixels) return;
  const GrayImage image = gray_of(*std::move(pixels));
  check_tracing(image, {});
  const auto last = std::to_integer<int>(bytes.back());
  check_tracing(image, {.threshold = std::min(last, 254), .specks = 1.0});
}

}  // namespace
}  // namespace mes::fuzz

void mes::fuzz::run_picture(std::string_view bytes) {
  const auto data = std::as_bytes(std::span(bytes));
  const auto picture = mes::render::decode_picture(data, "a.png", kMostPixels);
  require_little_memory(bytes.size() + 40 * kMostPixels, 1);
  if (!picture) {
    require_error(picture.error(), bytes);
    return;
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
  check_traced(data);
}
