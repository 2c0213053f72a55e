// SPDX-License-Identifier: GPL-3.0-or-later
// A drag, step by step, with the engine on its thread as beside the window: from the event to the frame that shows it,
// and the frame against drawing the same scene at rest, in a view for which nothing is kept.
#include <benchmark/benchmark.h>

#include <algorithm>
#include <atomic>
#include <memory>
#include <span>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include "app/editing/editor.h"
#include "app/picture/moved_points.h"
#include "core/base/rng.h"
#include "core/builtins/builtins.h"
#include "core/engine/engine.h"
#include "render/device/egl_context.h"
#include "render/device/gl_device.h"
#include "render/scene.h"
#include "tests/bench/ratios.h"
#include "tests/bench/setup.h"
#include "tests/support/builtin_layers.h"
#include "tests/support/shapes/shapes_benchmark.h"

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

/// What the window does in a frame, without its panels: the engine's patches, and the dots under the hand.
class Window {
 public:
  explicit Window(const std::vector<LayerIndex>& layers)
      : layers_(layers), scene_(device_), moved_(find_layer("points")) {
    for (const LayerIndex layer : layers) views_.push_back({layer, layer_descriptors()[layer].style});
    camera_.set_viewport(kWidth, kHeight);
    target_ = device_.create_framebuffer({kWidth, kHeight});
    engine_.set_demand(main_layers(layers));
  }
  ~Window() { device_.destroy_framebuffer(target_); }
  Window(const Window&) = delete;
  Window& operator=(const Window&) = delete;

  Engine& engine() { return engine_; }
  /// By the structures, for the last patch.
  double computed_us() const { return computed_us_; }
  void fit(const Box2& extent) { camera_.fit(extent, 20.0); }
  /// Nothing of another view serves the next drawing.
  void pan() { camera_.pan({1.0, 0.0}); }
  /// Until the engine has nothing to do.
  void settle() {
    while (auto patch = engine_.sync()) take(std::move(patch));
  }
  /// Until the engine has caught up.
  void wait() { waited_for_ = engine_.sync(); }
  /// Returns the revision that is shown now.
  std::uint64_t follow(const Document& document, std::span<const SampleSlot> moved) {
    if (waited_for_) take(std::move(waited_for_));
    while (auto patch = engine_.poll()) take(std::move(patch));
    if (document.revision() == shown_) return shown_;
    if (const FramePatch* own = moved_.catch_up(document, moved, scene_.frame())) scene_.apply(*own);
    return shown_;
  }
  void draw() {
    device_.clear(target_, {0, 0, kWidth, kHeight}, {1, 1, 1, 1});
    scene_.draw(camera_, views_, {.target = target_, .overlays = false});
    device_.finish();
  }

 private:
  void take(std::unique_ptr<FramePatch> patch) {
    scene_.apply(*patch);
    moved_.take(*patch);
    shown_ = patch->document_revision;
    computed_us_ = 0.0;
    for (const NodeReport& node : patch->nodes) computed_us_ += 1e3 * node.update_ms;
    engine_.recycle(std::move(patch));
  }

  std::vector<LayerIndex> layers_;
  render::GlDevice device_;
  render::Scene scene_;
  render::Camera camera_;
  render::FramebufferId target_{};
  std::vector<render::LayerView> views_;
  MovedPoints moved_;
  std::uint64_t shown_ = 0;
  double computed_us_ = 0.0;
  std::unique_ptr<FramePatch> waited_for_;
  Engine engine_{builtins(), {}};
};

void drag(benchmark::State& state, RatioTable& table, const Input& input, bool is_busy) {
  const auto context = render::EglContext::create();
  if (!context) {
    state.SkipWithError(context.error().text.c_str());
    return;
  }
  Window window(layers_named({"interior-voronoi-disks", "curve", "medial-axis", "points"}));
  Editor editor([&](const std::shared_ptr<const DocumentDelta>& delta) { window.engine().post(delta); });
  SampleData data;
  data.positions = positions_of(input);
  Box2 extent;
  for (const Vec2 p : data.positions) extent.add(p);
  if (!editor.load(data)) return;
  window.fit(extent);
  window.settle();
  window.draw();
  std::vector<std::pair<SampleId, Vec2>> targets;
  std::vector<SampleSlot> moved;
  for (std::size_t i = 0; i < input.moved; ++i) {
    moved.emplace_back(input.samples / 2 + i);
    targets.emplace_back(editor.document().id(moved.back()), editor.document().position(moved.back()));
  }
  // A pixel or two a step.
  const Vec2 step{2e-3 * extent.width(), 1e-3 * extent.height()};
  const BusyLoop busy(is_busy);
  std::vector<double> own, frame, anew, rest, dot, all, computed;
  editor.begin_gesture("Move");
  for (auto _ : state) {
    for (auto& [id, to] : targets) to = to + step;
    const double event = now_us();
    if (!editor.move(targets, {})) state.SkipWithError("the move was refused");
    // The first frame has the dot where the hand is, the next one, where it is needed, all that follows.
    const auto draw_from = [&](double start) {
      const bool is_shown = window.follow(editor.document(), moved) == editor.document().revision();
      own.push_back(now_us() - start);
      window.draw();
      frame.push_back(now_us() - start);
      return is_shown;
    };
    bool is_shown = draw_from(event);
    dot.push_back(now_us() - event);
    while (!is_shown) {
      window.wait();
      is_shown = draw_from(now_us());
    }
    all.push_back(now_us() - event);
    computed.push_back(window.computed_us());
    const double start = now_us();
    window.draw();
    rest.push_back(now_us() - start);
  }
  editor.end_gesture();
  for (std::size_t i = 0; i < rest.size(); ++i) {
    window.pan();
    const double start = now_us();
    window.draw();
    anew.push_back(now_us() - start);
  }
  const std::string name = "drag " + std::to_string(input.moved) + ", " + input.name + (is_busy ? ", busy" : "");
  table.add({name, input.samples, median(frame), median(anew), 1.2, "drawing the same scene in another view"});
  const auto ms = [](const std::vector<double>& us) { return std::to_string(1e-3 * median(us)) + " ms"; };
  table.add_note(name + " of " + std::to_string(input.samples) + ": from the event to the frame with the dot " +
                 ms(dot) + ", with everything " + ms(all) + "; the window's thread beside drawing " + ms(own) +
                 " (goal 3), the structures " + ms(computed) + "; drawing once more what is already drawn " +
                 ms(rest));
}

/// The limit of the pruned lambda axis is dragged: from the event to the frame that shows the axis at the new limit.
void slide(benchmark::State& state, RatioTable& table, std::size_t n) {
  const auto context = render::EglContext::create();
  if (!context) {
    state.SkipWithError(context.error().text.c_str());
    return;
  }
  Window window(layers_named({"interior-voronoi-disks", "curve", "lambda-medial-axis", "points"}));
  const std::vector<Vec2> points = test::rough_curve(n);
  Box2 extent;
  for (const Vec2 p : points) extent.add(p);
  ComputationSettings settings;
  settings[Parameter::keep_topology] = 1.0;
  const double size = std::max(extent.width(), extent.height());
  window.engine().set_settings(settings);
  window.engine().post(replace_with(Document(), points));
  window.fit(extent);
  window.settle();
  window.draw();
  std::vector<double> all, anew;
  int step = 0;
  for (auto _ : state) {
    // Back and forth within what a slider is dragged over.
    settings[Parameter::lambda_limit] = 1e-3 * size * static_cast<double>(1 + (7 * step++) % 20);
    const double event = now_us();
    window.engine().set_settings(settings);
    window.settle();
    window.draw();
    all.push_back(now_us() - event);
  }
  for (std::size_t i = 0; i < all.size(); ++i) {
    window.pan();
    const double start = now_us();
    window.draw();
    anew.push_back(now_us() - start);
  }
  table.add({"drag the limit of pruning", n, median(all), median(anew), n == 100000 ? 1.3 : 0.0,
             "drawing the same scene in another view"});
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
  for (const std::size_t n : {std::size_t{1000}, std::size_t{100000}})
    benchmark::RegisterBenchmark(("drag/limit of pruning/" + std::to_string(n)).c_str(),
                                 [&table, n](benchmark::State& state) { slide(state, table, n); })
        ->Iterations(15)
        ->Unit(benchmark::kMillisecond);
}

}  // namespace mes::bench
