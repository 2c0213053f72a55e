// SPDX-License-Identifier: GPL-3.0-or-later
// What the contours of a silhouette cost, against decoding its file, which comes before.
#include <benchmark/benchmark.h>

#include <cmath>
#include <cstddef>
#include <string>
#include <vector>

#include "core/raster/picture_decoder.h"
#include "core/raster/trace.h"
#include "tests/bench/ratios.h"
#include "tests/bench/setup.h"

#define STB_IMAGE_WRITE_STATIC
#define STB_IMAGE_WRITE_IMPLEMENTATION
#define STBI_WRITE_NO_STDIO
#include <stb_image_write.h>

namespace mes::bench {
namespace {

constexpr int kSide = 4096;

/// A flower of grey values with soft edges and round holes, which its petals leave.
std::vector<std::uint8_t> silhouette() {
  std::vector<std::uint8_t> out;
  out.reserve(std::size_t{kSide} * kSide);
  for (int y = 0; y < kSide; ++y)
    for (int x = 0; x < kSide; ++x) {
      const double dx = x - 0.5 * kSide;
      const double dy = y - 0.5 * kSide;
      const double radius = 0.3 * kSide * (1.0 + 0.4 * std::cos(9.0 * std::atan2(dy, dx)));
      const double hole = std::hypot(std::fmod(x, 512.0) - 256.0, std::fmod(y, 512.0) - 256.0) - 60.0;
      const double inside = std::min(radius - std::hypot(dx, dy), hole);
      out.push_back(static_cast<std::uint8_t>(std::lround(255.0 * std::clamp(inside + 0.5, 0.0, 1.0))));
    }
  return out;
}

void append(void* bytes, void* data, int length) {
  static_cast<std::string*>(bytes)->append(static_cast<const char*>(data), static_cast<std::size_t>(length));
}

void tracing(benchmark::State& state, RatioTable& table) {
  const std::vector<std::uint8_t> pixels = silhouette();
  std::string png;
  stbi_write_png_to_func(append, &png, kSide, kSide, 1, pixels.data(), kSide);
  std::vector<double> our_times, raw_times;
  std::size_t curves = 0;
  for (auto _ : state) {
    double start = now_us();
    auto decoded = decode_pixels(std::as_bytes(std::span(png)), "silhouette");
    raw_times.push_back(now_us() - start);
    if (!decoded) break;
    start = now_us();
    const auto traced = trace(gray_of(std::move(*decoded)), {});
    our_times.push_back(now_us() - start);
    curves = traced ? traced->curves.curves.size() : 0;
  }
  if (curves == 0) state.SkipWithError("nothing was traced");
  table.add({"contours of a silhouette of 4096 x 4096", curves, median(our_times), median(raw_times), 1.0,
             "stb_image decoding it from PNG"});
}

}  // namespace

void register_tracing(RatioTable& table) {
  benchmark::RegisterBenchmark("tracing", [&table](benchmark::State& state) { tracing(state, table); })
      ->Iterations(7)
      ->Unit(benchmark::kMillisecond);
}

}  // namespace mes::bench
