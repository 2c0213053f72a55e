// SPDX-License-Identifier: GPL-3.0-or-later
// Variants beside the main computation: each is what a graph of its own gives, after every edit; what they share is
// there once; and they come and go without a trace.
#include <algorithm>
#include <catch2/catch.hpp>
#include <memory>
#include <string>
#include <vector>

#include "core/base/rng.h"
#include "core/builtins/builtins.h"
#include "core/document/commands.h"
#include "core/draw/layer_mirror.h"
#include "core/draw/variant.h"
#include "core/engine/engine.h"
#include "core/engine/graph.h"
#include "core/structures/balls/ball_union.h"
#include "core/structures/delaunay/delaunay.h"
#include "tests/support/builtin_layers.h"
#include "tests/support/layer_contents.h"
#include "tests/support/shapes/shapes_benchmark.h"

using namespace mes;
using namespace mes::test;

namespace {

const std::vector<std::string_view> kShown = {
    "points",           "curve",       "medial-axis",    "a-union-boundary", "a-ball-medial-axis",
    "p-union-boundary", "power-crust", "label-conflicts"};

std::vector<LayerIndex> shown_layers() {
  std::vector<LayerIndex> out;
  for (const std::string_view id : kShown) {
    REQUIRE(find_layer(id) != kNoLayer);
    out.push_back(find_layer(id));
  }
  return out;
}

std::vector<Vec2> noisy_ring(std::size_t n, std::uint64_t seed) {
  std::vector<Vec2> out;
  Rng random(seed);
  for (std::size_t i = 0; i < n; ++i) {
    const double angle = 6.283185307179586 * static_cast<double>(i) / static_cast<double>(n);
    const double radius = 1.0 + 0.15 * random.uniform() + 0.4 * std::cos(3.0 * angle);
    out.push_back({radius * std::cos(angle), radius * std::sin(angle)});
  }
  return out;
}

/// A graph and what its patches have drawn.
struct Bed {
  Graph graph{builtins()};
  FramePatch patch;
  LayerMirror mirror;
  LayerContents contents;

  void run() {
    JobControl job;
    REQUIRE(graph.run(patch, job));
    mirror.apply(patch);
    contents.apply(patch);
    for (const NodeReport& node : patch.nodes) REQUIRE(node.state != NodeState::failed);
  }
};

struct Edited {
  Document document;
  std::vector<std::shared_ptr<const DocumentDelta>> apply(const Expected<DocumentDelta>& delta) {
    REQUIRE(delta);
    document.apply(*delta);
    return {std::make_shared<const DocumentDelta>(*delta)};
  }
};

/// Equal to what a fresh graph with these settings draws of the document.
void check_variant(const Bed& bed, VariantIndex variant, bool has_document, const Document& document,
                   const ComputationSettings& settings) {
  Document copy;
  Bed fresh;
  SampleData data;
  for (const SampleSlot slot : document.slots_in_input_order()) data.positions.push_back(document.position(slot));
  const auto delta = replace_all(copy, data);
  REQUIRE(delta);
  fresh.graph.set_demand(shown_layers());
  fresh.graph.post_settings(settings);
  fresh.graph.post(std::make_shared<const DocumentDelta>(*delta));
  fresh.run();
  for (const LayerIndex layer : shown_layers()) {
    INFO("variant " << variant << ", layer " << layer_descriptors()[layer].id);
    CHECK(bed.mirror.digest(layer_in(variant, has_document, layer)) == fresh.mirror.digest(layer));
  }
}

std::vector<VariantLayer> demand_of(std::span<const VariantRequest> variants) {
  std::vector<VariantLayer> out = main_layers(shown_layers());
  for (VariantIndex v = 1; v <= variants.size(); ++v)
    for (const LayerIndex layer : shown_layers()) out.push_back(layer_in(v, variants[v - 1].has_document, layer));
  std::ranges::sort(out);
  const auto [first, last] = std::ranges::unique(out);
  out.erase(first, last);
  return out;
}

ComputationSettings with(Precision precision) {
  ComputationSettings out;
  out.precision = precision;
  return out;
}

}  // namespace

TEST_CASE("each variant is what a graph of its own gives after every edit") {
  Bed bed;
  Edited main;
  Edited other;
  std::vector<VariantRequest> variants = {
      {with(Precision::naive), false}, {with(Precision::exact), false}, {with(Precision::fast), true}};
  bed.graph.set_variants(variants);
  bed.graph.set_demand(demand_of(variants));
  SampleData data;
  data.positions = noisy_ring(120, 1);
  for (const auto& delta : main.apply(replace_all(main.document, data))) bed.graph.post(delta);
  data.positions = noisy_ring(60, 2);
  for (const auto& delta : other.apply(replace_all(other.document, data))) bed.graph.post(3, delta);
  bed.run();
  const auto check_all = [&] {
    check_variant(bed, 0, false, main.document, {});
    check_variant(bed, 1, false, main.document, variants[0].settings);
    check_variant(bed, 2, false, main.document, variants[1].settings);
    check_variant(bed, 3, true, other.document, variants[2].settings);
  };
  check_all();

  Rng random(7);
  for (std::uint64_t step = 0; step < 12; ++step) {
    Edited& edited = step % 3 == 2 ? other : main;
    std::vector<SampleId> ids;
    for (const SampleSlot slot : edited.document.slots_in_input_order()) ids.push_back(edited.document.id(slot));
    const SampleId id = ids[static_cast<std::size_t>(random.uniform() * static_cast<double>(ids.size()))];
    const Vec2 to{random.uniform(-1.5, 1.5), random.uniform(-1.5, 1.5)};
    std::vector<std::shared_ptr<const DocumentDelta>> deltas;
    switch (step % 4) {
      case 0: deltas = edited.apply(move_samples(edited.document, std::vector{std::pair{id, to}})); break;
      case 1: deltas = edited.apply(insert_samples(edited.document, std::vector{to})); break;
      case 2: deltas = edited.apply(remove_samples(edited.document, std::vector{id})); break;
      default: {
        variants[step % 2].settings[Parameter::a_scale] = 1.0 + 0.05 * static_cast<double>(step);
        bed.graph.set_variants(variants);
      }
    }
    for (const auto& delta : deltas) bed.graph.post(&edited == &other ? 3 : 0, delta);
    bed.run();
    check_all();
  }
}

TEST_CASE("variants share what does not depend on what they change") {
  Graph graph{builtins()};
  graph.set_variants(std::vector<VariantRequest>{{with(Precision::exact), false}, {{}, true}});
  CHECK(&graph.structures(1).get<Delaunay>() == &graph.structures().get<Delaunay>());
  CHECK(&graph.structures(1).get<AUnion>() != &graph.structures().get<AUnion>());
  CHECK(&graph.structures(2).get<Delaunay>() != &graph.structures().get<Delaunay>());
  const LayerIndex points = find_layer("points");
  const LayerIndex boundary = find_layer("a-union-boundary");
  CHECK(layer_in(1, false, points) == VariantLayer(kMainVariant, points));
  CHECK(layer_in(1, false, boundary) == VariantLayer(1, boundary));
  CHECK(layer_in(2, true, points) == VariantLayer(2, points));

  // An edit of the main document leaves the other one alone.
  Bed bed;
  const std::vector<VariantRequest> variants = {{with(Precision::naive), false}, {{}, true}};
  bed.graph.set_variants(variants);
  bed.graph.set_demand(demand_of(variants));
  Edited main;
  SampleData data;
  data.positions = noisy_ring(80, 3);
  for (const auto& delta : main.apply(replace_all(main.document, data))) bed.graph.post(delta);
  bed.run();
  std::size_t delaunays = 0;
  for (const NodeReport& node : bed.patch.nodes)
    if (node.structure == "delaunay" && node.state == NodeState::up_to_date) ++delaunays;
  CHECK(delaunays == 2);  // the main one, and that of the empty document
  CHECK(bed.mirror.count(layer_in(2, true, points), PrimitiveKind::point) == 0);
  CHECK(bed.mirror.count(points, PrimitiveKind::point) == 80);
  for (const auto& delta : main.apply(insert_samples(main.document, std::vector{Vec2{0.1, 0.2}})))
    bed.graph.post(delta);
  bed.run();
  for (std::size_t i = 0; i < bed.patch.layer_count; ++i) {
    const auto [variant, layer] = bed.patch.layers[i].layer;
    CHECK(variant < 2);
    // Unions of a noisy ring may be made anew, what is shared follows the edit.
    if (!layer_descriptors()[layer].follows_settings)
      CHECK(std::ranges::none_of(bed.patch.layers[i].kinds, &KindPatch::reset));
  }
}

TEST_CASE("variants come and go without a trace") {
  Bed bed;
  Edited main;
  SampleData data;
  data.positions = noisy_ring(90, 4);
  for (const auto& delta : main.apply(replace_all(main.document, data))) bed.graph.post(delta);
  std::vector<VariantRequest> variants;
  const auto show = [&] {
    bed.graph.set_variants(variants);
    bed.graph.set_demand(demand_of(variants));
    bed.run();
    check_variant(bed, 0, false, main.document, {});
    for (VariantIndex v = 1; v <= variants.size(); ++v)
      if (!variants[v - 1].has_document) check_variant(bed, v, false, main.document, variants[v - 1].settings);
    CHECK(bed.patch.reports.size() == (variants.size() + 1) * layer_descriptors().size());
  };
  show();
  variants = {{with(Precision::naive), false}};
  show();
  variants = {{with(Precision::exact), false}, {with(Precision::naive), false}};
  show();
  variants = {{{}, true}, {with(Precision::naive), false}};
  show();
  CHECK(bed.mirror.count(layer_in(1, true, find_layer("points")), PrimitiveKind::point) == 0);
  variants = {};
  show();
  variants = {{with(Precision::exact), false}};
  show();
}

TEST_CASE("the engine computes variants in the steps of the main computation") {
  Engine engine(builtins(), {});
  Edited main;
  Edited other;
  SampleData data;
  data.positions = noisy_ring(70, 5);
  const std::vector<VariantRequest> variants = {{with(Precision::exact), false}, {{}, true}};
  EngineStep step{
      .deltas = main.apply(replace_all(main.document, data)), .settings = {}, .demand = demand_of(variants)};
  data.positions = noisy_ring(30, 6);
  step.beside.variants = variants;
  for (const auto& delta : other.apply(replace_all(other.document, data))) step.beside.deltas.push_back({2, delta});
  engine.post(step);
  LayerMirror mirror;
  const auto take = [&] {
    while (auto patch = engine.sync()) {
      mirror.apply(*patch);
      engine.recycle(std::move(patch));
    }
  };
  take();
  const LayerIndex points = find_layer("points");
  CHECK(mirror.count(points, PrimitiveKind::point) == 70);
  CHECK(mirror.count(layer_in(2, true, points), PrimitiveKind::point) == 30);

  // Before the engine sees any of it, a variant is changed, replaced, and given another document.
  for (int round = 0; round < 20; ++round) {
    EngineStep change{.deltas = {}, .settings = {}, .demand = demand_of(variants)};
    const Vec2 at{0.01 * round, 0.3};
    for (const auto& delta : other.apply(insert_samples(other.document, std::vector{at})))
      change.beside.deltas.push_back({2, delta});
    engine.post(change);
    EngineStep gone{.deltas = {}, .settings = {}, .demand = main_layers(shown_layers())};
    gone.beside.variants.emplace();
    if (round % 5 == 4) {
      engine.post(gone);
      other = {};
      EngineStep back{.deltas = {}, .settings = {}, .demand = demand_of(variants)};
      back.beside.variants = variants;
      data.positions = noisy_ring(20, 8);
      for (const auto& delta : other.apply(replace_all(other.document, data)))
        back.beside.deltas.push_back({2, delta});
      engine.post(back);
    }
    if (round % 3 == 0) take();
  }
  take();
  CHECK(mirror.count(layer_in(2, true, points), PrimitiveKind::point) == other.document.sample_count());
  CHECK(mirror.count(points, PrimitiveKind::point) == 70);
}
