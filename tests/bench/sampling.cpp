// SPDX-License-Identifier: GPL-3.0-or-later
// What sampling by local feature size costs, against the Delaunay triangulation of the samples that come out.
#include <benchmark/benchmark.h>

#include <cmath>
#include <cstddef>
#include <memory>
#include <numbers>
#include <vector>

#include "core/curves/curve.h"
#include "core/resampling/resampling.h"
#include "tests/bench/ratios.h"
#include "tests/bench/raw_delaunay.h"
#include "tests/bench/setup.h"

namespace mes::bench {
namespace {

/// A curve of bends of many sizes, as cubic pieces.
std::shared_ptr<const CurveSet> bends(int petals) {
  const auto place = [petals](double turn) {
    const double radius =
        1.0 + 0.3 * std::cos(3.0 * turn) + 0.4 / petals * (1.0 + std::cos(turn)) * std::cos(petals * turn);
    return Vec2{radius * std::cos(turn), radius * std::sin(turn)};
  };
  const int pieces = 4 * petals;
  const double step = 2.0 * std::numbers::pi / pieces;
  const auto speed = [&](double turn) {
    constexpr double kNear = 1e-6;
    return 1.0 / (2.0 * kNear) * (place(turn + kNear) - place(turn - kNear));
  };
  PlaneCurve curve(place(0.0));
  for (int i = 0; i < pieces; ++i) {
    const double from = step * i;
    const double to = i + 1 == pieces ? 0.0 : step * (i + 1);
    curve.cubic_to(place(from) + step / 3.0 * speed(from), place(to) - step / 3.0 * speed(to), place(to));
  }
  curve.close();
  auto out = std::make_shared<CurveSet>();
  out->curves.push_back(std::move(curve));
  return out;
}

void sampling(benchmark::State& state, RatioTable& table, int petals) {
  const auto curves = bends(petals);
  std::vector<double> ours;
  std::vector<double> raw;
  std::size_t samples = 0;
  for (auto _ : state) {
    JobControl job;
    double start = process_us();
    const auto taken = take_samples(curves, {.rule = SamplingRule::feature_size, .count = kUsualSamples}, job);
    ours.push_back(process_us() - start);
    if (!taken || !taken->is_proved()) {
      state.SkipWithError("it was not sampled");
      return;
    }
    samples = taken->data.positions.size();
    RawDelaunay peer;
    start = process_us();
    peer.insert_range(taken->data.positions);
    raw.push_back(process_us() - start);
  }
  table.add({"sampling by local feature size", samples, median(ours), median(raw), 12.0, "Delaunay of the samples"});
}

}  // namespace

void register_sampling(RatioTable& table) {
  constexpr int kPetals = 22000;
  benchmark::RegisterBenchmark("sampling", [&table](benchmark::State& state) { sampling(state, table, kPetals); })
      ->Iterations(3)
      ->Unit(benchmark::kMillisecond);
}

}  // namespace mes::bench
