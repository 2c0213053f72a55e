// SPDX-License-Identifier: GPL-3.0-or-later
// The axis of a coast, exact for doubles and with what lies inside, against the segment Voronoi diagram of Boost.Polygon
// for integers, which has no inside.
#include <benchmark/benchmark.h>
#include <fmt/format.h>

#include <boost/polygon/polygon.hpp>
#include <boost/polygon/segment_data.hpp>
#include <boost/polygon/voronoi.hpp>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <numeric>
#include <vector>

#include "core/base/rng.h"
#include "tests/bench/ratios.h"
#include "tests/bench/setup.h"

namespace mes::bench {
namespace {

namespace bp = boost::polygon;

/// A closed curve around the origin with bays of all sizes; vertices are integers.
std::vector<Vec2> coast(std::size_t count) {
  Rng rng(1);
  constexpr int kWaves = 200;
  std::vector<double> phase;
  for (int k = 0; k < kWaves; ++k) phase.push_back(rng.uniform(0.0, 2.0 * std::numbers::pi));
  std::vector<Vec2> out;
  for (std::size_t i = 0; i < count; ++i) {
    const double turn = 2.0 * std::numbers::pi * static_cast<double>(i) / static_cast<double>(count);
    double radius = 1.0;
    for (int k = 1; k < kWaves; ++k)
      radius += 0.25 * std::pow(k, -1.3) * std::sin(3 * k * turn + phase[static_cast<std::size_t>(k)]);
    out.push_back({std::round(1e8 * radius * std::cos(turn)), std::round(1e8 * radius * std::sin(turn))});
  }
  return out;
}

double time_of_axis(const std::vector<Vec2>& vertices) {
  SampleData data;
  data.positions = vertices;
  data.contours.emplace_back().points.resize(vertices.size());
  std::iota(data.contours.front().points.begin(), data.contours.front().points.end(), 0U);
  Graph graph{builtins()};
  graph.set_demand(layers_named({"outline-axis"}));
  graph.post(std::make_shared<const DocumentDelta>(*replace_all(Document(), data)));
  FramePatch patch;
  JobControl job;
  graph.run(patch, job);
  for (const NodeReport& node : patch.nodes)
    if (node.structure == "outline-axis") return 1e3 * node.update_ms;
  return 0.0;
}

double time_of_boost(const std::vector<Vec2>& vertices) {
  const auto point = [](Vec2 p) { return bp::point_data<int>(static_cast<int>(p.x), static_cast<int>(p.y)); };
  std::vector<bp::segment_data<int>> sides;
  for (std::size_t i = 0; i < vertices.size(); ++i)
    sides.emplace_back(point(vertices[i]), point(vertices[(i + 1) % vertices.size()]));
  const double start = now_us();
  bp::voronoi_diagram<double> diagram;
  bp::construct_voronoi(sides.begin(), sides.end(), &diagram);
  benchmark::DoNotOptimize(diagram.num_vertices());
  return now_us() - start;
}

void axis_of_coast(benchmark::State& state, RatioTable& table, std::size_t count) {
  const std::vector<Vec2> vertices = coast(count);
  std::vector<double> ours, raw;
  for (auto _ : state) {
    ours.push_back(time_of_axis(vertices));
    raw.push_back(time_of_boost(vertices));
  }
  table.add({"axis of a coast", count, median(ours), median(raw), 2.0, "segment Voronoi diagram of Boost.Polygon"});
}

}  // namespace

void register_outlines(RatioTable& table) {
  for (const std::size_t count : {std::size_t{10'000}, std::size_t{100'000}})
    benchmark::RegisterBenchmark(fmt::format("outlines/{}", count).c_str(),
                                 [&table, count](benchmark::State& state) { axis_of_coast(state, table, count); })
        ->Iterations(count == 10'000 ? 9 : 3)
        ->Unit(benchmark::kMillisecond);
}

}  // namespace mes::bench
