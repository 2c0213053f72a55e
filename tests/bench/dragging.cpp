// SPDX-License-Identifier: GPL-3.0-or-later
// What a step of a drag costs the window's thread: the edit, the patch, and the frame against drawing the same scene at
// rest. The engine works between the measured parts, as it does beside the window.
#include <benchmark/benchmark.h>

#include <atomic>
#include <optional>
#include <string>
#include <thread>
#include <utility>

#include "app/model/editor.h"
#include "core/base/rng.h"
#include "render/egl_context.h"
#include "render/gl_device.h"
#include "render/scene.h"
#include "tests/bench/ratios.h"
#include "tests/bench/setup.h"
#include "tests/support/shapes_benchmark.h"

namespace mes::bench {
namespace {

constexpr int kWidth = 1600;
constexpr int kHeight = 1000;

struct Input {
  std::string name;
  std::size_t samples = 0;
  bool is_random = false;
  std::size_t moved = 1;
};

std::vector<Vec2> positions_of(const Input& input) {
  if (!input.is_random) return test::benchmark_curve(input.samples);
  Rng rng(7);
  std::vector<Vec2> out(input.samples);
  for (Vec2& p : out) p = {rng.uniform(), rng.uniform()};
  return out;
}

/// Another program that wants a processor.
class BusyLoop {
 public:
  explicit BusyLoop(bool is_wanted) {
    if (is_wanted)
      thread_ = std::jthread([](const std::stop_token& stop) {
        std::atomic<std::uint64_t> turns = 0;
        while (!stop.stop_requested()) ++turns;
      });
  }

 private:
  std::jthread thread_;
};

void drag(benchmark::State& state, RatioTable& table, const Input& input, bool is_busy) {
  const auto context = render::EglContext::create();
  if (!context) {
    state.SkipWithError(context.error().text.c_str());
    return;
  }
  render::GlDevice device;
  render::Scene scene(device);
  const auto layers = layers_named({"interior-voronoi-disks", "curve", "medial-axis", "points"});
  Graph graph;
  graph.set_demand(layers);
  Editor editor([&graph](const std::shared_ptr<const DocumentDelta>& delta) { graph.post(delta); });
  SampleData data;
  data.positions = positions_of(input);
  if (!editor.load(data)) return;
  FramePatch patch;
  JobControl job;
  graph.run(patch, job);
  scene.apply(patch);
  std::vector<render::LayerView> views;
  for (const LayerIndex layer : layers) views.push_back({layer, layer_descriptors()[layer].style});
  render::Camera camera;
  camera.set_viewport(kWidth, kHeight);
  const Box2 extent = graph.structures().get<Samples>().extent();
  camera.fit(extent, 20.0);
  const render::FramebufferId target = device.create_framebuffer({kWidth, kHeight});
  const auto draw = [&] {
    device.clear(target, {0, 0, kWidth, kHeight}, {1, 1, 1, 1});
    scene.draw(camera, views, {.target = target, .overlays = false});
    device.finish();
  };
  std::vector<std::pair<SampleId, Vec2>> targets;
  for (std::size_t i = 0; i < input.moved; ++i) {
    const SampleSlot slot(input.samples / 2 + i);
    targets.emplace_back(editor.document().id(slot), editor.document().position(slot));
  }
  // A pixel or two a step.
  const Vec2 step{2e-3 * extent.width(), 1e-3 * extent.height()};
  const BusyLoop busy(is_busy);
  std::vector<double> own;
  std::vector<double> frame;
  std::vector<double> rest;
  std::vector<double> computed;
  editor.begin_gesture("Move");
  for (auto _ : state) {
    for (auto& [id, to] : targets) to = to + step;
    double start = now_us();
    if (!editor.move(targets, {})) state.SkipWithError("the move was refused");
    const double edited = now_us() - start;
    start = now_us();
    graph.run(patch, job);
    computed.push_back(now_us() - start);
    start = now_us();
    scene.apply(patch);
    const double applied = now_us() - start;
    draw();
    frame.push_back(edited + now_us() - start);
    own.push_back(edited + applied);
    start = now_us();
    draw();
    rest.push_back(now_us() - start);
  }
  editor.end_gesture();
  device.destroy_framebuffer(target);
  const std::string name = "drag " + std::to_string(input.moved) + ", " + input.name + (is_busy ? ", busy" : "");
  table.add({name, input.samples, median(frame), median(rest), 1.2, "drawing the same scene at rest"});
  table.add_note(name + " of " + std::to_string(input.samples) + ": a step costs the window's thread " +
                 std::to_string(1e-3 * median(own)) + " ms beside drawing (goal 3), the engine's " +
                 std::to_string(1e-3 * median(computed)) + " ms");
}

}  // namespace

void register_dragging(RatioTable& table) {
  const Input inputs[] = {
      {"curve", 1000}, {"curve", 100000}, {"random", 100000, true}, {"curve", 100000, false, 1800}};
  for (const Input& input : inputs)
    for (const bool is_busy : {false, true})
      benchmark::RegisterBenchmark(
          ("drag/" + input.name + '/' + std::to_string(input.samples) + '/' + std::to_string(input.moved) +
           (is_busy ? "/busy" : ""))
              .c_str(),
          [&table, input, is_busy](benchmark::State& state) { drag(state, table, input, is_busy); })
          ->Iterations(input.is_random ? 5 : 15)
          ->Unit(benchmark::kMillisecond);
}

}  // namespace mes::bench
