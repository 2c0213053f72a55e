// SPDX-License-Identifier: GPL-3.0-or-later
// From saving the source of an experiment to the picture of its new version, without the time of the compiler: the watch
// of the file, the trial in a process of its own, loading, and all that is computed and drawn again.
#include <benchmark/benchmark.h>
#include <fmt/core.h>
#include <stdlib.h>

#include <algorithm>
#include <chrono>
#include <condition_variable>
#include <filesystem>
#include <fstream>
#include <memory>
#include <mutex>
#include <sstream>
#include <string>
#include <system_error>
#include <thread>
#include <utility>
#include <vector>

#include "app/experiments/experiment_list.h"
#include "core/builtins/builtins.h"
#include "core/engine/engine.h"
#include "core/io/format.h"
#include "render/device/egl_context.h"
#include "render/device/gl_device.h"
#include "render/scene.h"
#include "tests/bench/ratios.h"
#include "tests/bench/setup.h"
#include "tests/support/shapes/shapes_benchmark.h"

namespace mes::bench {
namespace {

namespace fs = std::filesystem;

constexpr double kGoalUs = 200000.0;
constexpr int kVersions = 9;
constexpr int kWidth = 1600;
constexpr int kHeight = 1000;

/// Microseconds since 1970, as `date` tells them.
double clock_us() {
  return std::chrono::duration<double, std::micro>(std::chrono::system_clock::now().time_since_epoch()).count();
}

std::string text_of(const fs::path& file) {
  std::ostringstream out;
  out << std::ifstream(file).rdbuf();
  return out.str();
}

class TemporaryFolder {
 public:
  TemporaryFolder() {
    std::string pattern = (fs::temp_directory_path() / "mesecina-bench-XXXXXX").string();
    path_ = ::mkdtemp(pattern.data()) == nullptr ? fs::path() : fs::path(pattern);
  }
  ~TemporaryFolder() {
    std::error_code ignored;
    if (!path_.empty()) fs::remove_all(path_, ignored);
  }
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;
  const fs::path& path() const { return path_; }

 private:
  fs::path path_;
};

/// A compiler that notes when it begins and when it has ended.
class TimedCompiler {
 public:
  explicit TimedCompiler(const fs::path& folder) : program_(folder / "compiler"), times_(folder / "times") {
    std::ofstream(program_) << "#!/bin/sh\ndate +%s%N >>" << times_ << "\nc++ \"$@\"\nresult=$?\ndate +%s%N >>"
                            << times_ << "\nexit $result\n";
    fs::permissions(program_, fs::perms::owner_all);
  }
  std::string words() const { return program_.string(); }
  /// Of the last call.
  double us() const {
    std::ifstream in(times_);
    double begin = 0.0, end = 0.0;
    for (double a = 0.0, b = 0.0; in >> a >> b;) begin = a, end = b;
    return 1e-3 * (end - begin);
  }

 private:
  fs::path program_, times_;
};

/// What the window does, without its panels.
class Window {
 public:
  Window(const std::vector<Vec2>& points, const std::string& compiler)
      : list_({.program = MESECINA_BINARY, .compiler = compiler}, [this] { wake(); }) {
    camera_.set_viewport(kWidth, kHeight);
    target_ = device_.create_framebuffer({kWidth, kHeight});
    Document document;
    engine_.post(replace_with(document, points));
    Box2 extent;
    for (const Vec2 p : points) extent.add(p);
    camera_.fit(extent, 20.0);
  }
  ~Window() { device_.destroy_framebuffer(target_); }
  Window(const Window&) = delete;
  Window& operator=(const Window&) = delete;

  ExperimentList& list() { return list_; }
  /// Until another version is drawn. False: there is a mistake in it.
  bool show_next(const std::string& layer) {
    for (;;) {
      bool is_good = true;
      if (auto next = list_.follow(*registry_,
                                   [&](const ExperimentList::Entry& entry) { is_good = entry.problem.empty(); })) {
        registry_ = std::move(next);
        engine_.set_registry(registry_);
        const LayerIndex shown{registry_->find_layer(layer)};
        engine_.set_demand(main_layers(std::vector{shown}));
        views_ = {{shown, registry_->layers()[shown].style}};
        while (auto patch = engine_.sync()) {
          scene_.apply(*patch);
          engine_.recycle(std::move(patch));
        }
        device_.clear(target_, {0, 0, kWidth, kHeight}, {1, 1, 1, 1});
        scene_.draw(camera_, views_, {.target = target_, .overlays = false});
        device_.finish();
        return true;
      }
      if (!is_good) return false;
      std::unique_lock lock(mutex_);
      is_awake_.wait(lock, [this] { return std::exchange(has_news_, false); });
    }
  }

 private:
  void wake() {
    const std::lock_guard lock(mutex_);
    has_news_ = true;
    is_awake_.notify_one();
  }

  std::mutex mutex_;
  std::condition_variable is_awake_;
  bool has_news_ = false;
  std::shared_ptr<const Registry> registry_{std::shared_ptr<void>(), &builtins()};
  render::GlDevice device_;
  render::Scene scene_{device_};
  render::Camera camera_;
  render::FramebufferId target_{};
  std::vector<render::LayerView> views_;
  Engine engine_{builtins(), {}};
  ExperimentList list_;
};

void reload(benchmark::State& state, RatioTable& table, const std::vector<Vec2>& points) {
  const auto context = render::EglContext::create();
  if (!context) {
    state.SkipWithError(context.error().text.c_str());
    return;
  }
  const TemporaryFolder folder;
  ::setenv("XDG_CACHE_HOME", (folder.path() / "cache").c_str(), 1);
  ::setenv("MESECINA_INCLUDE", MESECINA_SOURCES "/core/library", 1);
  const TimedCompiler compiler(folder.path());
  const fs::path source = folder.path() / "gabriel.cpp";
  const std::string text = text_of(MESECINA_SOURCES "/examples/experiments/gabriel.cpp");
  // Each version is another library, so that it is tried.
  const auto save = [&](int version) {
    std::ofstream(source) << text << "int version() { return " << version << "; }\n";
  };
  save(0);
  Window window(points, compiler.words());
  std::vector<double> times;
  if (!window.list().add(source) || !window.show_next("gabriel")) return state.SkipWithError("it does not compile");
  for (auto _ : state) {
    const int version = static_cast<int>(times.size()) + 1;
    // Saved at any time between two looks of the watch.
    std::this_thread::sleep_for(std::chrono::milliseconds(37 * version % 100));
    const double saved = clock_us();
    save(version);
    if (!window.show_next("gabriel")) return state.SkipWithError("a version does not compile");
    times.push_back(clock_us() - saved - compiler.us());
    state.SetIterationTime(1e-6 * times.back());
  }
  table.add({"experiment, from saving to picture", points.size(), median(times), kGoalUs, 1.0, "200 ms"});
  table.add_note(
      fmt::format("from saving an experiment to its picture at {} samples, without the compiler: {:.0f} to "
                  "{:.0f} ms",
                  points.size(), 1e-3 * *std::ranges::min_element(times), 1e-3 * *std::ranges::max_element(times)));
}

std::vector<Vec2> lizard() {
  const auto read = read_sample_file(MESECINA_SOURCES "/assets/shapes/lizard.poff");
  return read ? read->data.positions : std::vector<Vec2>{};
}

}  // namespace

void register_reloading(RatioTable& table) {
  const auto add = [&table](const std::string& name, std::vector<Vec2> (*points)()) {
    benchmark::RegisterBenchmark(("experiment/reload/" + name).c_str(),
                                 [&table, points](benchmark::State& state) { reload(state, table, points()); })
        ->UseManualTime()
        ->Iterations(kVersions)
        ->Unit(benchmark::kMillisecond);
  };
  add("lizard", lizard);
  add("10000", [] { return test::benchmark_curve(10000); });
}

}  // namespace mes::bench
