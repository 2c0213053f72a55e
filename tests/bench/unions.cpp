// SPDX-License-Identifier: GPL-3.0-or-later
// The union of the inner Voronoi balls: general pipeline, certified shortcut, and the one-step axis.
#include <benchmark/benchmark.h>

#include <algorithm>
#include <cstdio>
#include <string>

#include "core/base/rng.h"
#include "core/builtins/builtins.h"
#include "core/structures/balls/ball_union.h"
#include "core/structures/balls/local_balls.h"
#include "core/structures/poles/polar_diagram.h"
#include "tests/bench/ratios.h"
#include "tests/bench/raw_delaunay.h"
#include "tests/bench/raw_regular.h"
#include "tests/bench/setup.h"
#include "tests/support/shapes/shapes.h"
#include "tests/support/shapes/shapes_benchmark.h"

namespace mes::bench {
namespace {

/// A graph that shows the axis of the union.
struct Bed {
  SampleData data;
  Document document;
  Graph graph{builtins()};
  FramePatch patch;
  JobControl job;

  explicit Bed(SampleData samples,
               std::initializer_list<std::string_view> layers = {"medial-axis", "a-ball-medial-axis"})
      : data(std::move(samples)) {
    graph.set_demand(layers_named(layers));
    load_again();
  }
  void load_again() {
    const auto delta = std::make_shared<const DocumentDelta>(*replace_all(document, data));
    document.apply(*delta);
    graph.post(delta);
    graph.run(patch, job);
  }
  void choose(Precision precision, bool use_shortcut, double scale = 1.0) {
    ComputationSettings settings;
    settings.precision = precision;
    settings[Parameter::a_scale] = scale;
    settings[Parameter::p_scale] = scale;
    settings[Parameter::union_shortcut] = use_shortcut ? 1.0 : 0.0;
    graph.post_settings(settings);
    graph.run(patch, job);
  }
  double ms(std::string_view structure) const {
    for (const NodeReport& node : patch.nodes)
      if (node.structure == structure) return node.update_ms;
    return 0.0;
  }
  std::int64_t count(std::string_view key) const {
    for (const Stat& stat : graph.structures().get<AUnion>().statistics())
      if (stat.key == key) return std::get<std::int64_t>(stat.value);
    return 0;
  }
};

SampleData data_of(std::vector<Vec2> points) {
  SampleData data;
  data.positions = std::move(points);
  return data;
}

void pipeline(benchmark::State& state, RatioTable& table, std::size_t n) {
  Bed bed(data_of(test::benchmark_curve(n)));
  const AUnion& balls = bed.graph.structures().get<AUnion>();
  const double one_step_ms =
      bed.ms("one-step-crust") + bed.ms("labels") + bed.ms("inner-balls") + bed.ms("medial-axis");
  std::vector<Disk> disks;
  JobControl job;
  for (const PipelineBall& ball : local_balls(balls.family(), job).balls) disks.push_back(ball.disk);
  std::vector<double> raw, general, certified;
  for (auto _ : state) {
    const double start = now_us();
    benchmark::DoNotOptimize(raw_regular_insert_range(disks));
    raw.push_back(now_us() - start);
    bed.choose(Precision::fast, false);
    general.push_back(1e3 * bed.ms("a-union"));
    bed.choose(Precision::exact, true);
    // The certificate was made once for the samples; its cost belongs to each exact result.
    certified.push_back(1e3 * (bed.ms("a-union") + bed.ms("axis-certificate")));
    state.SetIterationTime(1e-6 * general.back());
  }
  const std::string against = "regular triangulation insert(range)";
  table.add({"general pipeline, fast", n, median(general), median(raw), n >= 10000 ? 2.5 : 0.0, against});
  table.add({"exact with certificate", n, median(certified), median(general), 3.0, "general pipeline, fast"});
  table.add({"one-step axis", n, 1e3 * one_step_ms, median(general), 0.0, "general pipeline, fast"});
  state.counters["ratio"] = median(general) / median(raw);
  if (n > 10000) return;
  bed.choose(Precision::exact, false);
  table.add({"one-step axis", n, 1e3 * one_step_ms, 1e3 * bed.ms("a-union"), 0.0, "general pipeline, exact"});
}

void power_crust(benchmark::State& state, RatioTable& table, std::size_t n) {
  Bed bed(data_of(test::benchmark_curve(n)), {"power-crust"});
  std::vector<Disk> disks;
  JobControl job;
  for (const PipelineBall& ball : local_balls(bed.graph.structures().get<PolarDiagram>().family(), job).balls)
    disks.push_back(ball.disk);
  std::vector<double> raw, ours;
  for (auto _ : state) {
    const double start = now_us();
    benchmark::DoNotOptimize(raw_regular_insert_range(disks));
    raw.push_back(now_us() - start);
    bed.load_again();
    ours.push_back(1e3 * (bed.ms("poles") + bed.ms("pole-labels") + bed.ms("polar-diagram") + bed.ms("power-crust")));
    state.SetIterationTime(1e-6 * ours.back());
  }
  table.add({"power crust", n, median(ours), median(raw), 2.0, "regular triangulation of the poles, insert(range)"});
  state.counters["ratio"] = median(ours) / median(raw);
}

/// Of `structure`: exact, as it is by default, against rounded numbers.
void exact(benchmark::State& state, RatioTable& table, std::size_t n, const char* what, const char* structure,
           const char* layer, double scale) {
  Bed bed(data_of(test::benchmark_curve(n)), {layer});
  std::vector<double> exact, rounded;
  for (auto _ : state) {
    bed.choose(Precision::fast, false, scale);
    rounded.push_back(1e3 * bed.ms(structure));
    bed.choose(Precision::fast, true, scale);
    exact.push_back(1e3 * bed.ms(structure));
    state.SetIterationTime(1e-6 * exact.back());
  }
  table.add({what, n, median(exact), median(rounded), 20.0, "the same in doubles"});
  state.counters["ratio"] = median(exact) / median(rounded);
}

/// The polar union of outlines drawn by hand, as it is shown by default, against rounded numbers; another outline each
/// time.
void exact_of_a_hand(benchmark::State& state, RatioTable& table, std::size_t n, double grid) {
  const std::string what =
      "exact union of polar balls, drawn by hand" + std::string(grid == 1.0 ? ", on pixels" : "");
  Bed bed(data_of(test::drawn_by_hand(n, 1, grid)), {"p-ball-medial-axis", "p-union-boundary"});
  std::vector<double> exact, rounded, ratios;
  std::uint64_t seed = 0;
  for (auto _ : state) {
    bed.data = data_of(test::drawn_by_hand(n, ++seed, grid));
    bed.choose(Precision::fast, true);
    bed.load_again();
    exact.push_back(1e3 * bed.ms("p-union"));
    bed.choose(Precision::fast, false);
    rounded.push_back(1e3 * bed.ms("p-union"));
    ratios.push_back(exact.back() / rounded.back());
    state.SetIterationTime(1e-6 * exact.back());
  }
  table.add({what, n, median(exact), median(rounded), 20.0, "the same in doubles"});
  state.counters["ratio"] = median(ratios);
  state.counters["largest_ratio"] = *std::ranges::max_element(ratios);
}

void drag(benchmark::State& state, RatioTable& table, std::size_t n) {
  std::vector<Vec2> points = test::benchmark_curve(n);
  Bed bed(data_of(points));
  RawDelaunay raw;
  raw.insert_range_and_index(points);
  std::vector<SampleId> ids;
  for (const SampleSlot slot : slots_below<SampleSlot>(points.size())) ids.push_back(bed.document.id(slot));
  Rng rng(42);
  std::vector<double> ours, theirs;
  for (auto _ : state) {
    const std::size_t i = 1 + rng.below(points.size() - 1);
    const Vec2 to = points[i] + (0.25 * (rng.uniform() - 0.5)) * (points[i - 1] - points[i]);
    const auto delta = move_samples(bed.document, std::vector{std::pair{ids[i], to}});
    bed.document.apply(*delta);
    auto shared = std::make_shared<const DocumentDelta>(*delta);
    double start = now_us();
    bed.graph.post(std::move(shared));
    bed.graph.run(bed.patch, bed.job);
    ours.push_back(now_us() - start);
    state.SetIterationTime(1e-6 * ours.back());
    start = now_us();
    raw.move(i, to);
    theirs.push_back(now_us() - start);
    points[i] = to;
  }
  table.add({"drag with the axis of the union", n, median(ours), median(theirs), 60.0, "move_if_no_collision"});
}

// The paper's "numerically more stable" as figures.
void stability(benchmark::State& state, RatioTable& table) {
  for (auto _ : state) {
    for (const Precision precision : {Precision::naive, Precision::fast}) {
      std::int64_t runs = 0, failed = 0, faces = 0, wrong_faces = 0, v_points = 0, foreign = 0, chi = 0;
      for (std::uint64_t seed = 1; runs < 1000; ++seed) {
        for (const test::TestShape& shape :
             {test::ellipse(2, 1, 120, {.offset = 0.3, .jitter = 0.25, .seed = seed}),
              test::ellipse(5, 1, 200, {.offset = 0.3, .jitter = 0.25, .seed = seed}),
              test::annulus(1, 2, 0.2, {.offset = 0.3, .jitter = 0.25, .seed = seed}),
              test::eccentric_hole(1, 3, 1, 0.2, {.offset = 0.3, .jitter = 0.25, .seed = seed}),
              test::two_ellipses(2, 1, 1, 100, {.offset = 0.3, .jitter = 0.25, .seed = seed}),
              test::disk_with_holes(2, 3, 0.5, 1.5, 0.2, {.offset = 0.3, .jitter = 0.25, .seed = seed})}) {
          if (++runs > 1000) break;
          Bed bed(shape.data);
          bed.choose(precision, false);
          if (bed.graph.structures().get<AUnion>().tables().v_points.empty()) {
            ++failed;
            continue;
          }
          faces += bed.count("dual_faces");
          wrong_faces += bed.count("sign_flips");
          v_points += bed.count("v_points");
          foreign += bed.count("foreign_v_points");
          chi += bed.count("chi") != bed.count("chi_dual") ? 1 : 0;
        }
      }
      char text[400];
      std::snprintf(
          text, sizeof text,
          "1000 random samplings of 6 shapes, general pipeline in %s: %lld failed, %lld dual triangles "
          "misjudged (%lld found), %lld of %lld v-points are not samples, chi wrong in %lld; one-step: none",
          std::string(id_of(precision)).c_str(), static_cast<long long>(failed), static_cast<long long>(wrong_faces),
          static_cast<long long>(faces), static_cast<long long>(foreign), static_cast<long long>(v_points),
          static_cast<long long>(chi));
      table.add_note(text);
    }
  }
}

}  // namespace

void register_unions(RatioTable& table) {
  for (const std::size_t n : {std::size_t{1000}, std::size_t{10000}, std::size_t{100000}}) {
    benchmark::RegisterBenchmark(("union/pipeline/" + std::to_string(n)).c_str(),
                                 [&table, n](benchmark::State& state) { pipeline(state, table, n); })
        ->UseManualTime()
        ->Iterations(n >= 100000 ? 5 : 15)
        ->Unit(benchmark::kMillisecond);
    benchmark::RegisterBenchmark(("union/power_crust/" + std::to_string(n)).c_str(),
                                 [&table, n](benchmark::State& state) { power_crust(state, table, n); })
        ->UseManualTime()
        ->Iterations(n >= 100000 ? 5 : 15)
        ->Unit(benchmark::kMillisecond);
    struct Exact {
      const char *name, *what, *structure, *layer;
      double scale;
    };
    for (const Exact& row :
         {Exact{"polar", "exact union of polar balls", "p-union", "p-ball-medial-axis", 1.0},
          Exact{"scaled", "exact union of balls scaled by 1.1", "a-union", "a-ball-medial-axis", 1.1}})
      benchmark::RegisterBenchmark(("union/exact_" + std::string(row.name) + '/' + std::to_string(n)).c_str(),
                                   [&table, n, row](benchmark::State& state) {
                                     exact(state, table, n, row.what, row.structure, row.layer, row.scale);
                                   })
          ->UseManualTime()
          ->Iterations(n >= 100000 ? 3 : 9)
          ->Unit(benchmark::kMillisecond);
    benchmark::RegisterBenchmark(("union/drag/" + std::to_string(n)).c_str(),
                                 [&table, n](benchmark::State& state) { drag(state, table, n); })
        ->UseManualTime()
        ->Iterations(2000)
        ->Unit(benchmark::kMicrosecond);
  }
  for (const double grid : {0x1p-40, 1.0})
    benchmark::RegisterBenchmark(
        (std::string("union/exact_hand") + (grid == 1.0 ? "_on_pixels" : "") + "/600").c_str(),
        [&table, grid](benchmark::State& state) { exact_of_a_hand(state, table, 600, grid); })
        ->UseManualTime()
        ->Iterations(30)
        ->Unit(benchmark::kMillisecond);
  benchmark::RegisterBenchmark("union/stability", [&table](benchmark::State& state) { stability(state, table); })
      ->Iterations(1)
      ->Unit(benchmark::kMillisecond);
}

}  // namespace mes::bench
