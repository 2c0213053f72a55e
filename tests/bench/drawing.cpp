// SPDX-License-Identifier: GPL-3.0-or-later
// What reaches the graphics card and how long it takes there: bytes of one edit, frame time against the number of
// primitives, and the way from samples to the first picture. Without OpenGL the last two are left out.
#include <benchmark/benchmark.h>

#include <optional>

#include "core/base/rng.h"
#include "render/egl_context.h"
#include "render/gl_device.h"
#include "render/offscreen.h"
#include "render/recording_device.h"
#include "render/scene.h"
#include "tests/bench/ratios.h"
#include "tests/bench/setup.h"
#include "tests/support/shapes_benchmark.h"

namespace mes::bench {
namespace {

constexpr int kWidth = 1600;
constexpr int kHeight = 1000;

std::vector<LayerIndex> six_layers() {
  return layers_named({"points", "delaunay", "voronoi", "curve", "medial-axis", "interior-voronoi-disks"});
}

std::vector<render::LayerView> views_of(const std::vector<LayerIndex>& layers) {
  std::vector<render::LayerView> views;
  for (const LayerIndex layer : layers) views.push_back({layer, layer_descriptors()[layer].style});
  return views;
}

void upload(benchmark::State& state, RatioTable& table, std::size_t n) {
  render::RecordingDevice device;
  render::Scene scene(device);
  Document document;
  Graph graph;
  graph.set_demand(six_layers());
  FramePatch patch;
  JobControl job;
  const auto step = [&](const std::shared_ptr<const DocumentDelta>& delta) {
    document.apply(*delta);
    graph.post(delta);
    graph.run(patch, job);
    const std::uint64_t before = device.counters().bytes_uploaded;
    scene.apply(patch);
    return static_cast<double>(device.counters().bytes_uploaded - before);
  };
  step(replace_with(document, test::benchmark_curve(n)));
  Rng rng(3);
  std::vector<double> bytes;
  for (auto _ : state) {
    const auto slot = static_cast<Slot>(rng.below(n));
    const Vec2 to = document.position(slot) + Vec2{1e-3 * rng.uniform(), 1e-3 * rng.uniform()};
    const auto delta = move_samples(document, std::vector{std::pair{document.id(slot), to}});
    bytes.push_back(step(std::make_shared<const DocumentDelta>(*delta)));
  }
  const double most = *std::ranges::max_element(bytes);
  table.add_note("bytes uploaded for one move at " + std::to_string(n) + ", six layers: median " +
                 std::to_string(static_cast<int>(median(bytes))) + ", most " +
                 std::to_string(static_cast<int>(most)) + " of " + std::to_string(bytes.size()) + " (goal 16384)");
}

void frame(benchmark::State& state, RatioTable& table, std::size_t n) {
  const auto context = render::EglContext::create();
  if (!context) {
    state.SkipWithError(context.error().text.c_str());
    return;
  }
  render::GlDevice device;
  const auto layers = layers_named({"delaunay"});
  Graph graph;
  graph.set_demand(layers);
  const auto points = test::benchmark_curve(n);
  FramePatch patch;
  JobControl job;
  graph.post(replace_with(Document(), points));
  graph.run(patch, job);
  render::Scene scene(device);
  scene.apply(patch);
  render::Camera camera;
  camera.set_viewport(kWidth, kHeight);
  camera.fit(graph.structures().get<Samples>().extent(), 20.0);
  const auto views = views_of(layers);
  std::vector<double> times;
  for (auto _ : state) {
    const double start = now_us();
    const auto image = render::draw_image(device, scene, camera, views, {.background = Rgb{255, 255, 255}});
    benchmark::DoNotOptimize(image);
    times.push_back(1e-3 * (now_us() - start));
  }
  table.add_note("frame of " + std::to_string(scene.instances(layers[0], PrimitiveKind::segment)) +
                 " segments, 1600 x 1000, read back: median " + std::to_string(median(times)) + " ms (" +
                 context->description() + ")");
}

void first_picture(benchmark::State& state, RatioTable& table, std::size_t n) {
  const auto points = test::benchmark_curve(n);
  std::vector<double> times;
  for (auto _ : state) {
    const double start = now_us();
    const auto context = render::EglContext::create();
    if (!context) {
      state.SkipWithError(context.error().text.c_str());
      return;
    }
    render::GlDevice device;
    const auto layers = layers_named({"interior-voronoi-disks", "curve", "medial-axis", "points"});
    Graph graph;
    graph.set_demand(layers);
    FramePatch patch;
    JobControl job;
    graph.post(replace_with(Document(), points));
    graph.run(patch, job);
    render::Scene scene(device);
    scene.apply(patch);
    render::Camera camera;
    camera.set_viewport(kWidth, kHeight);
    camera.fit(graph.structures().get<Samples>().extent(), 20.0);
    const auto image =
        render::draw_image(device, scene, camera, views_of(layers), {.background = Rgb{255, 255, 255}});
    benchmark::DoNotOptimize(image);
    times.push_back(1e-3 * (now_us() - start));
  }
  table.add_note("from samples to the first picture, context included, " + std::to_string(n) + " samples: median " +
                 std::to_string(median(times)) + " ms");
}

}  // namespace

void register_drawing(RatioTable& table) {
  benchmark::RegisterBenchmark("upload/move/100000",
                               [&table](benchmark::State& state) { upload(state, table, 100000); })
      ->Iterations(2000)
      ->Unit(benchmark::kMicrosecond);
  for (const std::size_t n : {std::size_t{3000}, std::size_t{30000}, std::size_t{300000}}) {
    benchmark::RegisterBenchmark(("frame/delaunay/" + std::to_string(n)).c_str(),
                                 [&table, n](benchmark::State& state) { frame(state, table, n); })
        ->Iterations(n >= 300000 ? 5 : 20)
        ->Unit(benchmark::kMillisecond);
  }
  for (const std::size_t n : {std::size_t{1000}, std::size_t{100000}}) {
    benchmark::RegisterBenchmark(("first_picture/" + std::to_string(n)).c_str(),
                                 [&table, n](benchmark::State& state) { first_picture(state, table, n); })
        ->Iterations(5)
        ->Unit(benchmark::kMillisecond);
  }
}

}  // namespace mes::bench
