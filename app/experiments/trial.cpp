// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/experiments/trial.h"

#include <fmt/core.h>

#include <chrono>
#include <cmath>
#include <csignal>
#include <cstdio>
#include <cstring>
#include <fstream>
#include <string>
#include <vector>

#include "app/system/child_process.h"
#include "core/base/rng.h"
#include "core/evolutions/evolution.h"
#include "core/io/files/file_fingerprint.h"
#include "core/library/experiments.h"
#include "core/shapes/shape.h"
#include "core/workbench/workbench.h"

namespace mes {
namespace {

namespace fs = std::filesystem;

constexpr auto kLongestTrial = std::chrono::seconds(20);

// If a signal ends the process, its last line tells the user what it was doing.
void say(const std::string& text) {
  std::fprintf(stderr, "%s\n", text.c_str());
  std::fflush(stderr);
}

std::vector<std::vector<Vec2>> documents() {
  std::vector<std::vector<Vec2>> out{
      {}, {{0.0, 0.0}}, {{0.0, 0.0}, {1.0, 0.0}}, {{0.0, 0.0}, {1.0, 0.0}, {2.0, 0.0}}};
  std::vector<Vec2> grid;
  for (int x = 0; x < 5; ++x)
    for (int y = 0; y < 5; ++y) grid.push_back({static_cast<double>(x), static_cast<double>(y)});
  grid.push_back({2.0, 2.0});
  out.push_back(std::move(grid));
  std::vector<Vec2> ring;
  constexpr int kSamples = 120;
  for (int i = 0; i < kSamples; ++i) {
    const double angle = 2.0 * std::acos(-1.0) * i / kSamples;
    ring.push_back({3.0 * std::cos(angle), 2.0 * std::sin(angle)});
  }
  out.push_back(std::move(ring));
  return out;
}

void compute_all(const Registry& registry, const ExperimentContents& added) {
  const std::vector<std::string_view> structures(added.structures.begin(), added.structures.end());
  const std::vector<std::string_view> layers(added.layers.begin(), added.layers.end());
  Rng rng(1);
  for (const std::vector<Vec2>& samples : documents()) {
    Workbench bench(registry);
    JobControl job;
    std::string at;
    bench.set_want_statistics(true);
    bench.set_on_task([&](std::string_view task) {
      if (task != at) say(fmt::format("computing {} of {} samples", at = task, samples.size()));
    });
    static_cast<void>(bench.insert(samples));
    static_cast<void>(bench.need(std::span<const std::string_view>(structures)));
    static_cast<void>(bench.show(std::span<const std::string_view>(layers)));
    static_cast<void>(bench.run(job));
    for (int edit = 0; edit < 20; ++edit) {
      const std::vector<SampleSlot> slots = bench.document().slots_in_input_order();
      const Vec2 at_random{5.0 * rng.uniform(), 5.0 * rng.uniform()};
      if (slots.empty() || edit % 3 == 0) {
        static_cast<void>(bench.insert(std::vector{at_random}));
      } else {
        const SampleId id = bench.document().id(slots[rng.below(slots.size())]);
        if (edit % 3 == 1)
          static_cast<void>(bench.move(std::vector{std::pair{id, at_random}}));
        else
          static_cast<void>(bench.remove(std::vector{id}));
      }
      static_cast<void>(bench.run(job));
    }
  }
}

void evolve(const Registry& registry, const ExperimentContents& added) {
  for (const std::string& id : added.evolutions) {
    const EvolutionChoice chosen{.evolution = registry.evolutions().find(id)};
    if (const ParameterMove* const move = chosen.moved_parameter()) {
      say("moving a parameter by " + id);
      for (std::uint64_t step = 0; step < 5; ++step)
        static_cast<void>(moved_value(*move, move->parameter.default_value, step, chosen.values));
      continue;
    }
    for (const std::vector<Vec2>& samples : documents()) {
      say(fmt::format("moving {} samples by {}", samples.size(), id));
      Workbench bench(registry);
      static_cast<void>(bench.insert(samples));
      JobControl job;
      const EvolutionChoice choice{.evolution = registry.evolutions().find(id)};
      auto state = begin_evolution(state_of(bench.document()), choice, job);
      for (std::uint64_t step = 0; step < 2 && state; ++step) state = next_state(*state, step, choice, job);
    }
  }
}

void make_shapes(const Registry& registry, const ExperimentContents& added) {
  for (const std::string& id : added.shapes) {
    say("making " + id);
    const auto shape = registry.shapes().find(id);
    static_cast<void>(make_shape(*shape, {.values = values_of(*shape)}));
  }
}

}  // namespace

int run_trial(const Registry& registry, const fs::path& library) {
  constexpr int kRefused = 3;
  say("loading");
  const auto loaded = ExperimentLibrary::load(library);
  // The program itself reports a load error when it loads the library.
  if (!loaded) return 0;
  Registry changed = registry;
  say("adding");
  const auto added = loaded->add_to(changed);
  if (!added) return 0;
  try {
    compute_all(changed, *added);
    evolve(changed, *added);
    make_shapes(changed, *added);
  } catch (const std::exception& error) {
    say(error.what());
    return kRefused;
  }
  return 0;
}

Expected<void> try_experiment(const fs::path& program, const fs::path& cache, const fs::path& library,
                              const std::stop_token& stop) {
  const auto failure = [&library](ErrorCode code, std::string text) {
    return std::unexpected(Error{.code = code, .text = std::move(text), .file = library.string()});
  };
  const auto print = fingerprint_of_file(library);
  if (!print) return failure(ErrorCode::bad_input, "there is no such file");
  std::error_code error;
  const fs::path passed = cache / fmt::format("{:x}-{:016x}.passed", print->size, print->hash);
  if (fs::exists(passed, error)) return {};
  ChildProcess process;
  const fs::path full = fs::absolute(library, error);
  if (const int reason = process.start({program.string(), kTrialCommand, full.string()}, "/"); reason != 0)
    return failure(ErrorCode::bad_input, std::string("it cannot be tried: ") + std::strerror(reason));
  const auto until = std::chrono::steady_clock::now() + kLongestTrial;
  if (process.wait(stop, until)) {
    fs::create_directories(cache, error);
    std::ofstream(passed) << '\n';
    return {};
  }
  if (stop.stop_requested()) return failure(ErrorCode::cancelled, "stopped");
  const std::string at = process.complaint();
  if (std::chrono::steady_clock::now() > until)
    return failure(ErrorCode::bad_input,
                   fmt::format("it takes more than {} s for a trial ({})", kLongestTrial.count(), at));
  if (process.signal() != 0)
    return failure(ErrorCode::bad_input,
                   fmt::format("it crashes in a trial ({}): {}", at, ::strsignal(process.signal())));
  return failure(ErrorCode::bad_input, "a trial fails: " + at);
}

}  // namespace mes
