// SPDX-License-Identifier: GPL-3.0-or-later
// From samples to pictures: everything of the one-step pipeline against the triangulation alone.
#include <benchmark/benchmark.h>

#include "core/builtins/builtins.h"
#include "tests/bench/ratios.h"
#include "tests/bench/raw_delaunay.h"
#include "tests/bench/setup.h"
#include "tests/support/builtin_layers.h"
#include "tests/support/shapes/shapes_benchmark.h"

namespace mes::bench {
namespace {

std::size_t resident_bytes() {
  std::size_t pages = 0;
  std::size_t resident = 0;
  if (std::FILE* file = std::fopen("/proc/self/statm", "r")) {
    if (std::fscanf(file, "%zu %zu", &pages, &resident) != 2) resident = 0;
    std::fclose(file);
  }
  return resident * 4096;
}

void scratch(benchmark::State& state, RatioTable& table, const char* what, std::vector<Vec2> points, double goal) {
  const Document document;
  const auto delta = replace_with(document, points);
  const auto layers = layers_named({"points", "delaunay", "curve", "interior-voronoi-disks", "medial-axis"});
  std::vector<double> ours;
  std::vector<double> raw;
  std::vector<double> ours_of_processors;
  std::vector<double> raw_of_processors;
  std::string slowest;
  for (auto _ : state) {
    {
      RawDelaunay peer;
      const double start = now_us();
      const double start_of_processors = process_us();
      peer.insert_range(points);
      raw.push_back(now_us() - start);
      raw_of_processors.push_back(process_us() - start_of_processors);
    }
    Graph graph{builtins()};
    graph.set_demand(layers);
    FramePatch patch;
    JobControl job;
    const double start = now_us();
    const double start_of_processors = process_us();
    graph.post(delta);
    graph.run(patch, job);
    ours.push_back(now_us() - start);
    ours_of_processors.push_back(process_us() - start_of_processors);
    state.SetIterationTime(1e-6 * ours.back());
    slowest.clear();
    for (const NodeReport& node : patch.nodes)
      if (node.state == NodeState::up_to_date) slowest += " " + node.structure + " " + std::to_string(node.update_ms);
    for (const LayerReport& report : patch.reports)
      if (report.state == NodeState::up_to_date)
        slowest +=
            " " + std::string(layer_descriptors()[report.layer.layer].id) + " " + std::to_string(report.emit_ms);
  }
  state.counters["raw_us"] = median(raw);
  state.counters["ratio"] = median(ours) / median(raw);
  table.add({what, points.size(), median(ours), median(raw), goal, "insert(range)"});
  table.add({std::string(what) + ", CPU", points.size(), median(ours_of_processors), median(raw_of_processors), 0.0,
             "insert(range), CPU"});
  if (points.size() >= 1000000) table.add_note(std::string(what) + ", ms by part:" + slowest);
}

void memory(benchmark::State& state, RatioTable& table, std::vector<Vec2> points) {
  for (auto _ : state) {
    const std::size_t before = resident_bytes();
    Graph graph{builtins()};
    graph.set_demand(
        layers_named({"points", "delaunay", "voronoi", "curve", "interior-voronoi-disks", "medial-axis"}));
    graph.post(replace_with(Document(), points));
    JobControl job;
    {
      FramePatch patch;
      graph.run(patch, job);
    }
    const double bytes = static_cast<double>(resident_bytes() - before) / static_cast<double>(points.size());
    state.counters["bytes_per_sample"] = bytes;
    table.add_note("resident memory of graph and document, six layers: " + std::to_string(static_cast<int>(bytes)) +
                   " bytes a sample at " + std::to_string(points.size()));
  }
}

}  // namespace

void register_scratch(RatioTable& table) {
  for (const std::size_t n : {std::size_t{1000}, std::size_t{10000}, std::size_t{100000}, std::size_t{1000000}}) {
    const double goal = n >= 100000 ? 1.35 : 0.0;
    const int repeats = n >= 1000000 ? 5 : (n >= 100000 ? 15 : 60);
    const std::string suffix = "/" + std::to_string(n);
    benchmark::RegisterBenchmark(("scratch/curve" + suffix).c_str(),
                                 [&table, n, goal](benchmark::State& state) {
                                   scratch(state, table, "from scratch, curve", test::benchmark_curve(n), goal);
                                 })
        ->UseManualTime()
        ->Iterations(repeats)
        ->Unit(benchmark::kMillisecond);
    benchmark::RegisterBenchmark(("scratch/square" + suffix).c_str(),
                                 [&table, n](benchmark::State& state) {
                                   scratch(state, table, "from scratch, uniform square", test::uniform_square(n),
                                           n >= 100000 ? 2.0 : 0.0);
                                 })
        ->UseManualTime()
        ->Iterations(repeats)
        ->Unit(benchmark::kMillisecond);
  }
  benchmark::RegisterBenchmark("memory/curve/1000000", [&table](benchmark::State& state) {
    memory(state, table, test::benchmark_curve(1000000));
  })->Iterations(1);
}

}  // namespace mes::bench
