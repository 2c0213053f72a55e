// SPDX-License-Identifier: GPL-3.0-or-later
// One edit with four panes beside each other, against the same edit with one pane.
#include <benchmark/benchmark.h>

#include "core/base/rng.h"
#include "core/builtins/builtins.h"
#include "core/draw/variant.h"
#include "tests/bench/ratios.h"
#include "tests/bench/setup.h"
#include "tests/support/builtin_layers.h"
#include "tests/support/shapes/shapes_benchmark.h"

namespace mes::bench {
namespace {

constexpr std::size_t kSamples = 100'000;

/// What differs in the panes beside the main one.
enum class Difference { styles, scale, documents };

/// A graph with panes, and the documents of these.
struct Panes {
  Graph graph{builtins()};
  FramePatch patch;
  JobControl job;
  std::vector<VariantRequest> variants;

  Panes(Difference difference, std::size_t beside, const std::shared_ptr<const DocumentDelta>& first) {
    const std::vector<LayerIndex> shown =
        layers_named({"points", "curve", "medial-axis", "a-union-boundary", "a-ball-medial-axis"});
    for (std::size_t i = 1; i <= beside && difference != Difference::styles; ++i) {
      VariantRequest& variant = variants.emplace_back();
      variant.has_document = difference == Difference::documents;
      if (difference == Difference::scale) variant.settings[Parameter::p_scale] = 1.0 + 0.1 * static_cast<double>(i);
    }
    graph.set_variants(variants);
    std::vector<VariantLayer> demand = main_layers(shown);
    for (VariantIndex variant = 1; variant <= variants.size(); ++variant)
      for (const LayerIndex layer : shown)
        demand.push_back(layer_in(variant, variants[variant - 1].has_document, layer));
    graph.set_demand(demand);
    run(first);
  }
  double run(const std::shared_ptr<const DocumentDelta>& delta) {
    const double start = now_us();
    graph.post(delta);
    for (VariantIndex variant = 1; variant <= variants.size(); ++variant)
      if (variants[variant - 1].has_document) graph.post(variant, delta);
    graph.run(patch, job);
    const double taken = now_us() - start;
    if (!patch.complete) std::abort();
    return taken;
  }
};

void edit_panes(benchmark::State& state, RatioTable& table, Difference difference, const char* what, double goal) {
  Document document;
  const auto first = replace_with(document, test::benchmark_curve(kSamples, 1));
  document.apply(*first);
  Panes one(difference, 0, first);
  Panes four(difference, 3, first);
  Rng rng(5);
  std::vector<double> ours;
  std::vector<double> theirs;
  for (auto _ : state) {
    const SampleSlot slot(rng.below(kSamples));
    const SampleSlot next(slot.index() == 0 ? 1 : slot.index() - 1);
    const Vec2 p = document.position(slot);
    const Vec2 to = p + (0.25 * (rng.uniform() - 0.5)) * (document.position(next) - p);
    const auto delta =
        std::make_shared<const DocumentDelta>(*move_samples(document, std::vector{std::pair{document.id(slot), to}}));
    document.apply(*delta);
    theirs.push_back(one.run(delta));
    ours.push_back(four.run(delta));
    state.SetIterationTime(1e-6 * ours.back());
  }
  table.add({what, kSamples, median(ours), median(theirs), goal, "ours, one pane"});
}

}  // namespace

void register_panes(RatioTable& table) {
  const auto add = [&table](const char* name, Difference difference, const char* what, double goal) {
    benchmark::RegisterBenchmark(name,
                                 [&table, difference, what, goal](benchmark::State& state) {
                                   edit_panes(state, table, difference, what, goal);
                                 })
        ->UseManualTime()
        ->Iterations(5000)
        ->Unit(benchmark::kMicrosecond);
  };
  add("panes/styles", Difference::styles, "move, four panes, other styles", 1.5);
  add("panes/scale", Difference::scale, "move, four panes, other parameter", 4.5);
  add("panes/documents", Difference::documents, "move, four panes, all their own", 4.5);
}

}  // namespace mes::bench
