// SPDX-License-Identifier: GPL-3.0-or-later
// Delaunay edges as a layer of an experiment, and through a table of its own, against the layer of the program.
#include <benchmark/benchmark.h>
#include <mesecina/experiment.h>

#include <array>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "core/base/rng.h"
#include "core/builtins/builtins.h"
#include "core/library/internal/experiment_parts.h"
#include "tests/bench/ratios.h"
#include "tests/bench/setup.h"
#include "tests/support/shapes/shapes_benchmark.h"

namespace mes::bench {
namespace {

using mesecina::Drawn;
using mesecina::Inputs;
using mesecina::OwnTable;
using mesecina::Point;
using Ends = std::array<mesecina::Row, 2>;

/// Keeps the two ends of each edge.
class OwnEdges final : public mesecina::Structure {
 public:
  void rebuild(const Inputs& inputs) override {
    const View view(inputs);
    edges_.assign(inputs.rows("delaunay/edges"), Edge());
    for (const mesecina::Row edge : inputs.live_rows("delaunay/edges")) edges_[edge] = view.edge(edge);
    touched_.clear();
    removed_.clear();
  }
  bool update(const Inputs& inputs) override {
    const View view(inputs);
    edges_.resize(inputs.rows("delaunay/edges"));
    const mesecina::RowChanges changes = inputs.changes("delaunay/edges");
    touched_.assign(changes.touched.begin(), changes.touched.end());
    removed_.assign(changes.removed.begin(), changes.removed.end());
    for (const mesecina::Row edge : touched_) edges_[edge] = view.edge(edge);
    return true;
  }
  std::vector<OwnTable> tables() const override {
    std::vector<OwnTable> out;
    out.emplace_back("edges", "Ends of Delaunay edges")
        .rows_of("delaunay/edges")
        .changes(touched_, removed_)
        .column("from", "One end", edges_, &Edge::from)
        .column("to", "The other end", edges_, &Edge::to);
    return out;
  }

 private:
  struct Edge {
    Point from, to;
  };
  struct View {
    explicit View(const Inputs& inputs)
        : ends(inputs.column<Ends>("delaunay/edges/sites")), place(inputs.column<Point>("delaunay/sites/position")) {}
    Edge edge(mesecina::Row row) const { return {place[ends[row][0]], place[ends[row][1]]}; }
    mesecina::InputColumn<Ends> ends;
    mesecina::InputColumn<Point> place;
  };
  std::vector<Edge> edges_;
  std::vector<mesecina::Row> touched_, removed_;
};

void add_layers(mesecina::Experiment& experiment) {
  experiment.add_layer(
      {.id = "edges-from-outside", .rows = "delaunay/edges", .kinds = {mesecina::PrimitiveKind::segment}},
      [](const Inputs& inputs) {
        const auto ends = inputs.column<Ends>("delaunay/edges/sites");
        const auto place = inputs.column<Point>("delaunay/sites/position");
        return [=](mesecina::Row edge, Drawn& out) { out.segment(place[ends[edge][0]], place[ends[edge][1]]); };
      });
  experiment.add_structure<OwnEdges>({.id = "own-edges", .inputs = {"delaunay"}});
  experiment.add_layer({.id = "own-edges", .rows = "own-edges/edges", .kinds = {mesecina::PrimitiveKind::segment}},
                       [](const Inputs& inputs) {
                         const auto from = inputs.column<Point>("own-edges/edges/from");
                         const auto to = inputs.column<Point>("own-edges/edges/to");
                         return [=](mesecina::Row edge, Drawn& out) { out.segment(from[edge], to[edge]); };
                       });
}

const Registry& registry() {
  static const Registry all = [] {
    Registry out = builtins();
    mesecina::Experiment::Impl impl{out};
    mesecina::Experiment experiment(impl);
    add_layers(experiment);
    return out;
  }();
  return all;
}

/// A graph that shows one layer, and a document that it follows.
struct Shown {
  Document document;
  Graph graph{registry()};
  FramePatch patch;
  JobControl job;
  std::vector<SampleId> ids;

  Shown(const std::string& layer, const std::vector<Vec2>& points) {
    graph.set_demand(std::vector{LayerIndex{registry().find_layer(layer)}});
    const auto delta = replace_with(document, points);
    document.apply(*delta);
    graph.post(delta);
    for (const SampleSlot slot : slots_below<SampleSlot>(points.size())) ids.push_back(document.id(slot));
  }
  double run() {
    const double start = process_us();
    graph.run(patch, job);
    return process_us() - start;
  }
  double move(std::size_t sample, Vec2 to) {
    const auto delta =
        std::make_shared<const DocumentDelta>(*move_samples(document, std::vector{std::pair{ids[sample], to}}));
    document.apply(*delta);
    graph.post(delta);
    return run();
  }
};

void compare(benchmark::State& state, RatioTable& table, const std::string& layer, const std::string& what,
             std::size_t samples, double goal) {
  const std::vector<Vec2> points = test::benchmark_curve(samples, 1);
  std::vector<double> ours, theirs, our_edits, their_edits;
  for (auto _ : state) {
    Shown from_outside(layer, points);
    Shown built_in("delaunay", points);
    theirs.push_back(built_in.run());
    ours.push_back(from_outside.run());
    state.SetIterationTime(1e-6 * ours.back());
    Rng rng(11);
    for (int edit = 0; edit < 1500; ++edit) {
      const std::size_t i = 1 + rng.below(samples - 1);
      const Vec2 to = points[i] + (0.25 * (rng.uniform() - 0.5)) * (points[i - 1] - points[i]);
      their_edits.push_back(built_in.move(i, to));
      our_edits.push_back(from_outside.move(i, to));
    }
  }
  table.add({what + ", scratch", samples, median(ours), median(theirs), goal, "layer delaunay"});
  table.add({what + ", edit", samples, median(our_edits), median(their_edits), goal, "layer delaunay"});
}

}  // namespace

void register_experiments(RatioTable& table) {
  for (const std::size_t samples : {std::size_t{100000}, std::size_t{1000000}}) {
    const auto add = [&](const std::string& layer, const std::string& what, double goal) {
      benchmark::RegisterBenchmark(("experiment/" + layer + "/" + std::to_string(samples)).c_str(),
                                   [&table, layer, what, samples, goal](benchmark::State& state) {
                                     compare(state, table, layer, what, samples, goal);
                                   })
          ->UseManualTime()
          ->Iterations(samples > 100000 ? 3 : 9)
          ->Unit(benchmark::kMillisecond);
    };
    add("edges-from-outside", "experiment", 1.1);
    add("own-edges", "experiment, own table", 1.3);
  }
}

}  // namespace mes::bench
