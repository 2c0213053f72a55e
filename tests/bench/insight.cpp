// SPDX-License-Identifier: GPL-3.0-or-later
// Filters of the axis and feature sizes: from scratch against the triangulation alone, and what they add to an edit.
#include <benchmark/benchmark.h>

#include <algorithm>
#include <cmath>
#include <ctime>
#include <limits>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "core/base/rng.h"
#include "core/builtins/builtins.h"
#include "core/structures/balls/scale_axis.h"
#include "tests/bench/ratios.h"
#include "tests/bench/raw_delaunay.h"
#include "tests/bench/setup.h"
#include "tests/support/shapes/shapes_benchmark.h"

namespace mes::bench {
namespace {

using Names = std::initializer_list<std::string_view>;

ComputationSettings filtered(double lambda, double angle, bool keeps_topology) {
  ComputationSettings out;
  out[Parameter::lambda_limit] = lambda;
  out[Parameter::angle_limit] = angle;
  out[Parameter::keep_topology] = keeps_topology ? 1.0 : 0.0;
  return out;
}

double time_of(const FramePatch& patch, Names structures) {
  double ms = 0.0;
  for (const NodeReport& node : patch.nodes)
    for (const std::string_view name : structures)
      if (node.structure == name) ms += node.update_ms;
  return 1e3 * ms;
}

/// The time that some structures take of a run from scratch.
void scratch(benchmark::State& state, RatioTable& table, const char* what, std::size_t n, Names layers,
             Names structures, const ComputationSettings& settings, double goal) {
  const std::vector<Vec2> points = test::rough_curve(n);
  const Document document;
  const auto delta = replace_with(document, points);
  std::vector<double> ours;
  std::vector<double> raw;
  for (auto _ : state) {
    {
      RawDelaunay peer;
      const double start = now_us();
      peer.insert_range(points);
      raw.push_back(now_us() - start);
    }
    Graph graph{builtins()};
    graph.set_demand(layers_named(layers));
    graph.post_settings(settings);
    graph.post(delta);
    FramePatch patch;
    JobControl job;
    graph.run(patch, job);
    ours.push_back(time_of(patch, structures));
    state.SetIterationTime(1e-6 * ours.back());
  }
  table.add({what, n, median(ours), median(raw), goal, "insert(range)"});
}

/// The exponent of cover dates between a thousand and a hundred thousand samples, by the least times, which other programs
/// disturb least.
void exponent_of_cover_dates(benchmark::State& state, RatioTable& table) {
  constexpr std::size_t kFew = 1000;
  constexpr std::size_t kMany = 100'000;
  const auto least = [&table](std::size_t n, int runs) {
    const Document document;
    const auto delta = replace_with(document, test::rough_curve(n));
    double out = std::numeric_limits<double>::infinity();
    for (int i = 0; i < runs; ++i) {
      Graph graph{builtins()};
      graph.set_demand(layers_named({"cover-dates"}));
      graph.post(delta);
      FramePatch patch;
      JobControl job;
      graph.run(patch, job);
      out = std::min(out, time_of(patch, {"cover-dates"}));
    }
    table.add_note("cover dates of " + std::to_string(n) + " samples: " + std::to_string(1e-3 * out) +
                   " ms at least");
    return out;
  };
  for (auto _ : state) {
    const double few = least(kFew, 50);
    const double many = least(kMany, 7);
    const double exponent = std::log(many / few) / std::log(static_cast<double>(kMany / kFew));
    table.add({"cover dates: exponent", kMany, exponent, 1.0, 1.2, "its time at a thousand, by logarithms"});
    state.SetIterationTime(1e-6 * many);
  }
}

/// Of all threads, so that other programs do not count.
double process_us() {
  timespec now{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
  return 1e6 * static_cast<double>(now.tv_sec) + 1e-3 * static_cast<double>(now.tv_nsec);
}

/// Alpha filtrations against the triangulation alone: of samples, and of balls about them with small radii.
void alpha(benchmark::State& state, RatioTable& table, const char* what, std::size_t n,
           const std::vector<Vec2>& points, bool are_balls) {
  SampleData data;
  Rng rng(11);
  if (are_balls)
    for (const Vec2 p : points) data.balls.push_back({p, 0.3 * rng.uniform() / std::sqrt(static_cast<double>(n))});
  else
    data.positions = points;
  const Document document;
  const auto delta = std::make_shared<const DocumentDelta>(*replace_all(document, data));
  std::vector<double> ours;
  std::vector<double> raw;
  for (auto _ : state) {
    {
      RawDelaunay peer;
      const double start = process_us();
      peer.insert_range(points);
      raw.push_back(process_us() - start);
    }
    Graph graph{builtins()};
    graph.set_demand(layers_named({are_balls ? "b-alpha-edges" : "alpha-edges"}));
    graph.post(delta);
    FramePatch patch;
    JobControl job;
    const double start = process_us();
    graph.run(patch, job);
    ours.push_back(process_us() - start);
    state.SetIterationTime(1e-6 * ours.back());
  }
  table.add({what, n, median(ours), median(raw), 0.0, "insert(range)"});
}

std::vector<Vec2> lattice(std::size_t n) {
  std::vector<Vec2> out;
  const auto side = static_cast<std::size_t>(std::sqrt(static_cast<double>(n)));
  for (std::size_t i = 0; i < side * side; ++i)
    out.push_back({static_cast<double>(i % side), static_cast<double>(i / side)});
  return out;
}

/// The scale axis against the union of as many balls, given as one's own: the same pipeline, without the samples.
void scale_axis(benchmark::State& state, RatioTable& table, std::size_t n) {
  ComputationSettings settings;
  settings[Parameter::scale_axis_factor] = 1.3;
  const Document document;
  const auto samples = replace_with(document, test::rough_curve(n));
  std::vector<double> ours;
  std::vector<double> raw;
  for (auto _ : state) {
    Graph graph{builtins()};
    graph.set_demand(layers_named({"scale-axis"}));
    graph.post_settings(settings);
    graph.post(samples);
    FramePatch patch;
    JobControl job;
    graph.run(patch, job);
    ours.push_back(time_of(patch, {"axis-sampling", "scale-union"}));
    state.SetIterationTime(1e-6 * ours.back());
    const auto& balls = graph.structures().get<ScaleUnion>();
    SampleData own;
    for (const FamilySlot ball : balls.tables().balls.rows())
      if (balls.family().is_ball(ball)) own.balls.push_back(balls.family().disk(ball));
    Graph other{builtins()};
    other.set_demand(layers_named({"b-ball-medial-axis"}));
    other.post(std::make_shared<const DocumentDelta>(*replace_all(document, own)));
    other.run(patch, job);
    raw.push_back(time_of(patch, {"b-union"}));
  }
  table.add({"scale axis, s = 1.3", n, median(ours), median(raw), n == 10000 ? 2.0 : 0.0, "union of as many balls"});
}

/// One sample is moved along the curve, with and without a layer more.
void edit(benchmark::State& state, RatioTable& table, const char* what, std::size_t n, std::string_view layer,
          const ComputationSettings& settings, double goal) {
  Document document;
  const auto first = replace_with(document, test::benchmark_curve(n));
  document.apply(*first);
  struct Side {
    Graph graph{builtins()};
    FramePatch patch;
    std::vector<double> times;
  };
  Side with, without;
  JobControl job;
  with.graph.set_demand(
      layers_named({"points", "delaunay", "voronoi", "curve", "medial-axis", "interior-voronoi-disks", layer}));
  without.graph.set_demand(
      layers_named({"points", "delaunay", "voronoi", "curve", "medial-axis", "interior-voronoi-disks"}));
  for (Side* side : {&with, &without}) {
    side->graph.post_settings(settings);
    side->graph.post(first);
    side->graph.run(side->patch, job);
  }
  Rng rng(7);
  for (auto _ : state) {
    const SampleSlot slot(1 + rng.below(n - 1));
    const Vec2 p = document.position(slot);
    const Vec2 to =
        p + (0.25 * (rng.uniform() - 0.5)) * (document.position(SampleSlot(slot.index() - std::size_t{1})) - p);
    const auto delta =
        std::make_shared<const DocumentDelta>(*move_samples(document, std::vector{std::pair{document.id(slot), to}}));
    document.apply(*delta);
    for (Side* side : {&with, &without}) {
      const double start = own_us();
      side->graph.post(delta);
      side->graph.run(side->patch, job);
      side->times.push_back(own_us() - start);
    }
    state.SetIterationTime(1e-6 * with.times.back());
  }
  table.add({what, n, median(with.times), median(without.times), goal, "ours, without the layer"});
}

}  // namespace

void register_insight(RatioTable& table) {
  benchmark::RegisterBenchmark("insight/cover dates, exponent",
                               [&table](benchmark::State& state) { exponent_of_cover_dates(state, table); })
      ->UseManualTime()
      ->Iterations(1)
      ->Unit(benchmark::kMillisecond);
  for (const std::size_t n : {std::size_t{10000}, std::size_t{100000}}) {
    const bool is_large = n == 100000;
    const std::string suffix = "/" + std::to_string(n);
    const auto add_scratch = [&](const char* what, Names layers, Names structures,
                                 const ComputationSettings& settings, double goal) {
      benchmark::RegisterBenchmark((std::string("insight/") + what + suffix).c_str(),
                                   [&table, what, n, layers, structures, settings, goal](benchmark::State& state) {
                                     scratch(state, table, what, n, layers, structures, settings, goal);
                                   })
          ->UseManualTime()
          ->Iterations(is_large ? 9 : 30)
          ->Unit(benchmark::kMillisecond);
    };
    static const Names kMeasures{"lambda-medial-axis", "angle-medial-axis", "feature-size"};
    static const Names kMeasuring{"lambda-axis", "angle-axis", "feature-size"};
    static const Names kFiltersOnly{"lambda-medial-axis", "angle-medial-axis"};
    static const Names kFiltering{"lambda-axis", "angle-axis"};
    static const Names kLambda{"lambda-medial-axis"};
    static const Names kPruning{"lambda-axis"};
    add_scratch("lambda, angle, feature size", kMeasures, kMeasuring, filtered(1.0, 20.0, false),
                is_large ? 0.6 : 0.0);
    add_scratch("lambda and angle", kFiltersOnly, kFiltering, filtered(1.0, 20.0, false), 0.0);
    static const Names kCover{"cover-dates"};
    add_scratch("cover dates", kCover, kCover, {}, is_large ? 8.0 : 0.0);
    if (!is_large)
      benchmark::RegisterBenchmark(("insight/scale axis" + suffix).c_str(),
                                   [&table, n](benchmark::State& state) { scale_axis(state, table, n); })
          ->UseManualTime()
          ->Iterations(7)
          ->Unit(benchmark::kMillisecond);
    const auto add_alpha = [&](const char* what, std::vector<Vec2> points, bool are_balls) {
      benchmark::RegisterBenchmark((std::string("insight/") + what + suffix).c_str(),
                                   [&table, what, n, points = std::move(points), are_balls](benchmark::State& state) {
                                     alpha(state, table, what, n, points, are_balls);
                                   })
          ->UseManualTime()
          ->Iterations(is_large ? 5 : 15)
          ->Unit(benchmark::kMillisecond);
    };
    add_alpha("alpha, random samples", test::uniform_square(n), false);
    add_alpha("alpha, samples of a curve", test::rough_curve(n), false);
    add_alpha("alpha, samples of a lattice", lattice(n), false);
    add_alpha("alpha, random balls", test::uniform_square(n), true);
    add_scratch("lambda, pruned", kLambda, kPruning, filtered(1.0, 0.0, true), is_large ? 1.0 : 0.0);
    const auto add_edit = [&](const char* what, std::string_view layer, const ComputationSettings& settings,
                              double goal, std::int64_t iterations) {
      benchmark::RegisterBenchmark((std::string("insight/") + what + suffix).c_str(),
                                   [&table, what, n, layer, settings, goal](benchmark::State& state) {
                                     edit(state, table, what, n, layer, settings, goal);
                                   })
          ->UseManualTime()
          ->Iterations(iterations)
          ->Unit(benchmark::kMicrosecond);
    };
    add_edit("move, lambda axis shown", "lambda-medial-axis", filtered(1.0, 0.0, false), is_large ? 1.5 : 0.0, 4000);
    add_edit("move, angle axis shown", "angle-medial-axis", filtered(0.0, 20.0, false), 0.0, 4000);
    add_edit("move, feature size shown", "feature-size", {}, 0.0, 2000);
    add_edit("move, pruned lambda axis shown", "lambda-medial-axis", filtered(1.0, 0.0, true), 0.0, 30);
  }
}

}  // namespace mes::bench
