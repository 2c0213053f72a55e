// SPDX-License-Identifier: GPL-3.0-or-later
// Thousands of contours against one: what opening a drawing costs, up to its curve and axis, if its samples lie on many
// small circles. And the labels of circles in an exact lattice, in which nearly all edges are equally certain, against
// those of circles that are moved a little.
#include <benchmark/benchmark.h>
#include <fmt/format.h>

#include <cmath>
#include <cstddef>
#include <iterator>
#include <numbers>
#include <string>
#include <vector>

#include "core/base/rng.h"
#include "core/builtins/builtins.h"
#include "core/io/format.h"
#include "tests/bench/ratios.h"
#include "tests/bench/setup.h"

namespace mes::bench {
namespace {

constexpr std::size_t kSamplesEach = 8;

std::string svg_of(const std::string& content) {
  return R"(<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 10000 10000">)" + content + "</svg>";
}

std::string circles(std::size_t side, bool is_jittered) {
  Rng rng(1);
  std::string out;
  for (std::size_t i = 0; i < side * side; ++i) {
    Vec2 at{10.0 * static_cast<double>(i % side) + 5.0, 10.0 * static_cast<double>(i / side) + 5.0};
    double radius = 3.0;
    if (is_jittered) {
      at = at + Vec2{rng.uniform(0.0, 1.0), rng.uniform(0.0, 1.0)};
      radius = rng.uniform(2.0, 3.0);
    }
    fmt::format_to(std::back_inserter(out), R"(<circle cx="{:.6f}" cy="{:.6f}" r="{:.6f}"/>)", at.x, at.y, radius);
  }
  return svg_of(out);
}

std::string one_curve(std::size_t samples) {
  std::string out = R"(<path d="M)";
  for (std::size_t i = 0; i < samples; ++i) {
    const double turn = 2.0 * std::numbers::pi * static_cast<double>(i) / static_cast<double>(samples);
    const double radius = 4000.0 + 500.0 * std::sin(40.0 * turn);
    fmt::format_to(std::back_inserter(out), "{}{:.6f} {:.6f}", i == 0 ? "" : "L", radius * std::cos(turn),
                   radius * std::sin(turn));
  }
  return svg_of(out + R"(Z"/>)");
}

struct Opened {
  std::size_t samples = 0;
  double us = 0.0;
  double labels_ms = 0.0;
};

Opened open(const std::string& bytes) {
  Opened out;
  const double start = now_us();
  const auto file = read_sample_bytes(bytes, "a.svg");
  if (!file) return out;
  Graph graph{builtins()};
  graph.set_demand(layers_named({"points", "curve", "medial-axis"}));
  graph.post(std::make_shared<const DocumentDelta>(*replace_all(Document(), file->data)));
  FramePatch patch;
  JobControl job;
  graph.run(patch, job);
  out.us = now_us() - start;
  out.samples = file->data.positions.size();
  for (const NodeReport& node : patch.nodes)
    if (node.structure == "labels") out.labels_ms = node.update_ms;
  return out;
}

void opening(benchmark::State& state, RatioTable& table, std::size_t side) {
  const std::string many = circles(side, true);
  const std::string lattice = circles(side, false);
  const std::string one = one_curve(kSamplesEach * side * side);
  std::vector<double> ours, raw, labels_of_lattice, labels_of_jittered;
  for (auto _ : state) {
    const Opened of_many = open(many);
    const Opened of_lattice = open(lattice);
    const Opened of_one = open(one);
    if (of_many.samples != kSamplesEach * side * side || of_one.samples != of_many.samples) {
      state.SkipWithError("it was not read");
      return;
    }
    ours.push_back(of_many.us);
    raw.push_back(of_one.us);
    labels_of_lattice.push_back(1e3 * of_lattice.labels_ms);
    labels_of_jittered.push_back(1e3 * of_many.labels_ms);
  }
  const std::size_t samples = kSamplesEach * side * side;
  table.add({fmt::format("opening of {} circles", side * side), samples, median(ours), median(raw), 4.0,
             "one curve of as many samples"});
  table.add({fmt::format("labels, lattice of {} circles", side * side), samples, median(labels_of_lattice),
             median(labels_of_jittered), 0.0, "circles moved a little"});
}

}  // namespace

void register_cities(RatioTable& table) {
  for (const std::size_t side : {std::size_t{100}, std::size_t{316}})
    benchmark::RegisterBenchmark(fmt::format("cities/{}", side * side).c_str(),
                                 [&table, side](benchmark::State& state) { opening(state, table, side); })
        ->Iterations(side == 100 ? 9 : 3)
        ->Unit(benchmark::kMillisecond);
}

}  // namespace mes::bench
