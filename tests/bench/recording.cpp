// SPDX-License-Identifier: GPL-3.0-or-later
// What recording costs: a 1080p frame as PNG against the library's own way, a picture with its session against one
// without, and the time of the thread that draws with and without reading each frame back. Without OpenGL it is left out.
#include <benchmark/benchmark.h>

#include <cstdint>
#include <memory>
#include <utility>

#include "core/builtins/builtins.h"
#include "core/io/session/session.h"
#include "render/device/egl_context.h"
#include "render/frame_capture.h"
#include "render/image/png.h"
#include "render/offscreen.h"
#include "tests/bench/ratios.h"
#include "tests/bench/setup.h"
#include "tests/support/builtin_layers.h"
#include "tests/support/shapes/shapes_benchmark.h"

#define STB_IMAGE_WRITE_STATIC
#define STB_IMAGE_WRITE_IMPLEMENTATION
#define STBI_WRITE_NO_STDIO
#include <stb_image_write.h>

namespace mes::bench {
namespace {

constexpr int kWidth = 1920;
constexpr int kHeight = 1080;
constexpr std::size_t kSamples = 400;
constexpr Rgb kWhite{255, 255, 255};

/// A drawing as the window first shows it.
class Stage {
 public:
  explicit Stage(int width = kWidth, int height = kHeight, std::size_t samples = kSamples) : scene_(device_) {
    Graph graph{builtins()};
    const auto layers = layers_named({"interior-voronoi-disks", "curve", "medial-axis", "points"});
    graph.set_demand(layers);
    FramePatch patch;
    JobControl job;
    graph.post(replace_with(Document(), test::benchmark_curve(samples)));
    graph.run(patch, job);
    scene_.apply(patch);
    for (const LayerIndex layer : layers) views_.push_back({layer, layer_descriptors()[layer].style});
    camera_.set_viewport(width, height);
    camera_.fit(graph.structures().get<Samples>().extent(), 20.0);
    target_ = device_.create_framebuffer({.width = kWidth, .height = kHeight});
  }
  void draw() {
    device_.clear(target_, {0, 0, kWidth, kHeight}, {1.0F, 1.0F, 1.0F, 1.0F});
    scene_.draw(camera_, views_, {.target = target_});
    device_.finish();
  }
  render::Image image() { return *render::draw_image(device_, scene_, camera_, views_, {.background = kWhite}); }
  render::GlDevice& device() { return device_; }
  render::FramebufferId target() const { return target_; }

 private:
  render::GlDevice device_;
  render::Scene scene_;
  render::Camera camera_;
  std::vector<render::LayerView> views_;
  render::FramebufferId target_{};
};

void encode(benchmark::State& state, RatioTable& table) {
  const auto context = render::EglContext::create();
  if (!context) {
    state.SkipWithError(context.error().text.c_str());
    return;
  }
  const render::Image image = Stage().image();
  std::vector<double> ours;
  std::vector<double> raw;
  for (auto _ : state) {
    const double start = now_us();
    benchmark::DoNotOptimize(render::encode_png(image));
    const double middle = now_us();
    int size = 0;
    unsigned char* png = stbi_write_png_to_mem(image.rgba.data(), 4 * kWidth, kWidth, kHeight, 4, &size);
    benchmark::DoNotOptimize(png);
    raw.push_back(now_us() - middle);
    ours.push_back(middle - start);
    STBIW_FREE(png);
  }
  table.add({"PNG of a 1080p frame", kSamples, median(ours), median(raw), 0.3, "stb_image_write as it comes"});
}

void carry(benchmark::State& state, RatioTable& table) {
  const auto context = render::EglContext::create();
  if (!context) {
    state.SkipWithError(context.error().text.c_str());
    return;
  }
  constexpr std::size_t kCarried = 10'000;
  const render::Image image = Stage(1600, 1200, kCarried).image();
  Session session;
  SampleData data{.positions = test::benchmark_curve(kCarried)};
  data.contours.push_back({.closed = true, .points = {}});
  for (std::uint32_t i = 0; i < kCarried; ++i) data.contours.back().points.push_back(i);
  session.data = std::make_shared<const SampleData>(std::move(data));
  std::vector<double> with;
  std::vector<double> without;
  for (auto _ : state) {
    const double start = now_us();
    benchmark::DoNotOptimize(render::encode_png(image, render::kPngSmall));
    const double middle = now_us();
    const auto packed = packed_session(session);
    if (!packed) state.SkipWithError("the session is too long");
    benchmark::DoNotOptimize(render::encode_png(image, render::kPngSmall, packed.value_or("")));
    with.push_back(now_us() - middle);
    without.push_back(middle - start);
  }
  table.add(
      {"PNG of 1600x1200 with its session", kCarried, median(with), median(without), 1.1, "the PNG without it"});
}

void capture(benchmark::State& state, RatioTable& table) {
  const auto context = render::EglContext::create();
  if (!context) {
    state.SkipWithError(context.error().text.c_str());
    return;
  }
  Stage stage;
  render::FrameCapture frames(stage.device());
  std::vector<double> ours;
  std::vector<double> raw;
  stage.draw();
  for (auto _ : state) {
    const double start = now_us();
    stage.draw();
    const double middle = now_us();
    stage.draw();
    frames.take(stage.target(), {0, 0, kWidth, kHeight});
    while (auto picture = frames.poll()) benchmark::DoNotOptimize(picture->rgba.data());
    ours.push_back(now_us() - middle);
    raw.push_back(middle - start);
  }
  table.add({"1080p frame, recorded", kSamples, median(ours), median(raw), 1.2, "the same frame, not recorded"});
}

}  // namespace

void register_recording(RatioTable& table) {
  benchmark::RegisterBenchmark("recording/png", [&table](benchmark::State& state) { encode(state, table); })
      ->Iterations(15)
      ->Unit(benchmark::kMillisecond);
  benchmark::RegisterBenchmark("recording/source", [&table](benchmark::State& state) { carry(state, table); })
      ->Iterations(15)
      ->Unit(benchmark::kMillisecond);
  benchmark::RegisterBenchmark("recording/capture", [&table](benchmark::State& state) { capture(state, table); })
      ->Iterations(40)
      ->Unit(benchmark::kMillisecond);
}

}  // namespace mes::bench
