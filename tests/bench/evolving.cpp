// SPDX-License-Identifier: GPL-3.0-or-later
// Steps of smoothing: a late one against the first.
#include <benchmark/benchmark.h>

#include <cstdlib>

#include "core/evolutions/evolution.h"
#include "tests/bench/ratios.h"
#include "tests/bench/setup.h"
#include "tests/support/builtin_layers.h"
#include "tests/support/shapes/shapes_benchmark.h"

namespace mes::bench {
namespace {

constexpr std::uint64_t kLate = 1000;

double timed_step(EvolutionState& state, std::uint64_t k, const EvolutionChoice& choice) {
  JobControl job;
  const double start = now_us();
  auto next = next_state(state, k, choice, job);
  const double taken = now_us() - start;
  if (!next) std::abort();
  state = std::move(*next);
  return taken;
}

void smoothing(benchmark::State& state, RatioTable& table, const std::vector<Vec2>& points) {
  Document document;
  document.apply(*replace_with(document, points));
  const EvolutionChoice choice{.evolution = find_evolution("smooth")};
  std::vector<double> first;
  std::vector<double> late;
  for (auto _ : state) {
    const EvolutionState beginning = state_of(document);
    for (int i = 0; i < 9; ++i) {
      EvolutionState once = beginning;
      first.push_back(timed_step(once, 0, choice));
    }
    EvolutionState at = beginning;
    for (std::uint64_t k = 0; k < kLate; ++k) {
      const double taken = timed_step(at, k, choice);
      if (k + 9 >= kLate) late.push_back(taken);
    }
  }
  table.add({"smoothing, step 1000", points.size(), median(late), median(first), 1.2, "step 1"});
}

}  // namespace

void register_evolving(RatioTable& table) {
  benchmark::RegisterBenchmark(
      "evolution/smooth/10000",
      [&table](benchmark::State& state) { smoothing(state, table, test::benchmark_curve(10000)); })
      ->Iterations(1)
      ->Unit(benchmark::kMillisecond);
}

}  // namespace mes::bench
