// SPDX-License-Identifier: GPL-3.0-or-later
// What happens when a structure cannot be computed. The program's own structures do not fail on any input we know, so
// this executable brings its own small registry: samples, a structure that fails on request, and one that needs it.
#include <algorithm>
#include <catch2/catch.hpp>
#include <new>

#include "core/document/commands.h"
#include "core/engine/engine.h"
#include "core/engine/graph.h"
#include "core/engine/memory_lack.h"
#include "core/engine/theorem_light.h"
#include "core/graph/explain.h"
#include "core/graph/size_refusal.h"
#include "tests/support/layer_contents.h"

using namespace mes;
using namespace mes::test;

namespace {

// Follows the samples row by row, and fails when one of them lies at a place that asks for it.
class Shaky final : public Structure {
 public:
  explicit Shaky(Samples& samples) : Structure("shaky", {&samples}), samples_(samples) {}
  const Samples& samples() const { return samples_; }
  const ChangeSet<SampleSlot>& changes() const { return samples_.changes(); }

  void rebuild(JobControl&) override { attempt(); }
  bool update(JobControl&) override {
    attempt();
    return true;
  }
  void clear_changes() override {}
  std::size_t touched() const override { return changes().size(); }
  StatList statistics() const override { return {{"attempts", std::int64_t{attempts_}}}; }

 private:
  void attempt() {
    ++attempts_;
    for (const SampleSlot slot : slots_below<SampleSlot>(samples_.row_count())) {
      if (!samples_.is_alive(slot)) continue;
      const double y = samples_.position(slot).y;
      if (y == -1.0) throw GeometryError("a sample lies at -1", {samples_.id(slot)});
      if (y == -2.0) throw std::bad_alloc();
      if (y == -3.0) MES_ASSERT(y > 0.0);
      if (y == -4.0) throw SizeRefusal("it takes too many");
    }
  }
  Samples& samples_;
  int attempts_ = 0;
};

class Dependent final : public Structure {
 public:
  explicit Dependent(Shaky& shaky) : Structure("dependent", {&shaky}), shaky_(shaky) {}
  const Shaky& shaky() const { return shaky_; }
  void rebuild(JobControl&) override {}
  bool update(JobControl&) override { return true; }
  void clear_changes() override {}
  std::size_t touched() const override { return shaky_.touched(); }
  StatList statistics() const override { return {}; }

 private:
  Shaky& shaky_;
};

Layer points_of(std::string_view id, const Structure& structure, const Samples& samples) {
  Layer layer;
  layer.descriptor.id = id;
  layer.descriptor.kinds = {PrimitiveKind::point};
  layer.structures = {&structure};
  layer.parts.push_back(table_part(
      {PrimitiveKind::point}, [&samples] { return samples.row_count(); }, samples.changes(),
      [&samples](SampleSlot slot, Instance& out) {
        if (samples.is_alive(slot)) out.point(samples.position(slot));
      }));
  return layer;
}

constexpr LayerIndex kSteady = 0;
constexpr LayerIndex kShaky = 1;
constexpr LayerIndex kDependent = 2;

/// Three structures, the second of which may throw.
const Registry& shaky_registry() {
  static const Registry registry = [] {
    Registry out;
    out.add_structure<Samples>();
    out.add_structure<Shaky, Samples>();
    out.add_structure<Dependent, Shaky>();
    out.add_layer(
        [](const StructureSet& set) { return points_of("steady", set.get<Samples>(), set.get<Samples>()); });
    out.add_layer([](const StructureSet& set) { return points_of("shaky", set.get<Shaky>(), set.get<Samples>()); });
    out.add_layer(
        [](const StructureSet& set) { return points_of("dependent", set.get<Dependent>(), set.get<Samples>()); });
    return out;
  }();
  return registry;
}

constexpr PrimitiveKind kPoint = PrimitiveKind::point;

struct FailingBench {
  Document document;
  Graph graph{shaky_registry()};
  FramePatch patch;
  LayerContents contents;

  FailingBench() { graph.set_demand(std::vector<LayerIndex>{kSteady, kShaky, kDependent}); }

  void post(const Expected<DocumentDelta>& delta) {
    REQUIRE(delta.has_value());
    document.apply(*delta);
    graph.post(std::make_shared<const DocumentDelta>(*delta));
    run();
  }
  void insert(Vec2 p) { post(insert_samples(document, std::vector{p})); }
  void remove_last() { post(remove_samples(document, std::vector{last()})); }
  void run() {
    JobControl job;
    REQUIRE(graph.run(patch, job));
    contents.apply(patch);
  }
  SampleId last() const { return document.id(document.slots_in_input_order().back()); }
  bool brings(LayerIndex layer) const {
    return std::any_of(patch.layers.begin(), patch.layers.begin() + static_cast<std::ptrdiff_t>(patch.layer_count),
                       [&](const LayerPatch& p) { return p.layer == layer; });
  }
  const NodeReport& report(std::string_view id) const {
    return *std::ranges::find(patch.nodes, id, &NodeReport::structure);
  }
};

}  // namespace

TEST_CASE("a failure keeps the last picture of its layers and of those that need it, and says why") {
  FailingBench bench;
  bench.insert({0, 0});
  bench.insert({1, 0});
  CHECK(bench.contents.count(kShaky, kPoint) == 2);
  bench.insert({2, -1});
  CHECK(bench.report("shaky").state == NodeState::failed);
  CHECK(bench.report("shaky").reason == "a sample lies at -1");
  CHECK(bench.report("shaky").witnesses == std::vector{bench.last()});
  CHECK(bench.report("dependent").state == NodeState::blocked);
  CHECK(bench.report("dependent").reason == "shaky: a sample lies at -1");
  CHECK(bench.patch.reports[kShaky].state == NodeState::failed);
  CHECK(bench.patch.reports[kDependent].state == NodeState::blocked);
  CHECK(bench.patch.complete);
  CHECK_FALSE(bench.brings(kShaky));
  CHECK_FALSE(bench.brings(kDependent));
  CHECK(bench.contents.count(kShaky, kPoint) == 2);
  CHECK(bench.contents.count(kDependent, kPoint) == 2);
  // Others go on.
  CHECK(bench.contents.count(kSteady, kPoint) == 3);
  CHECK(bench.report("samples").state == NodeState::up_to_date);
  // It stays like that while the reason stays.
  bench.insert({3, 0});
  CHECK(bench.report("shaky").state == NodeState::failed);
  CHECK(bench.contents.count(kShaky, kPoint) == 2);
  CHECK(bench.contents.count(kSteady, kPoint) == 4);
}

TEST_CASE("when the reason is gone everything is there again") {
  FailingBench bench;
  for (int i = 0; i < 5; ++i) bench.insert({1.0 * i, 0});
  bench.insert({7, -1});
  bench.remove_last();
  for (const char* id : {"shaky", "dependent"}) {
    CHECK(bench.report(id).state == NodeState::up_to_date);
    CHECK(bench.report(id).reason.empty());
    CHECK(bench.report(id).witnesses.empty());
    CHECK(bench.report(id).rebuilt);
  }
  for (const LayerIndex layer : {kShaky, kDependent}) {
    CHECK(bench.patch.reports[layer].state == NodeState::up_to_date);
    CHECK(bench.contents.sorted(layer) == bench.contents.sorted(kSteady));
  }
  // And follows edits again.
  bench.insert({9, 9});
  CHECK_FALSE(bench.report("shaky").rebuilt);
  CHECK(bench.contents.sorted(kDependent) == bench.contents.sorted(kSteady));
}

TEST_CASE("a failure and its picture stay while nothing changes") {
  FailingBench bench;
  bench.insert({0, 0});
  bench.insert({2, -1});
  bench.graph.set_demand(std::vector<LayerIndex>{kShaky});
  bench.run();
  CHECK(bench.report("shaky").state == NodeState::failed);
  CHECK_FALSE(bench.brings(kShaky));
  CHECK(bench.contents.count(kShaky, kPoint) == 1);
  // A layer that comes into demand while its structure is down has no good picture to show.
  bench.graph.set_demand(std::vector<LayerIndex>{kSteady, kShaky, kDependent});
  bench.run();
  CHECK(bench.brings(kSteady));
  CHECK_FALSE(bench.brings(kDependent));
  CHECK(bench.report("shaky").reason == "a sample lies at -1");
  CHECK(bench.report("dependent").state == NodeState::blocked);
}

TEST_CASE("what failed is tried again when its inputs have changed, and not before") {
  FailingBench bench;
  bench.graph.set_want_statistics(true);
  bench.insert({0, 0});
  bench.insert({2, -1});
  REQUIRE(bench.report("shaky").state == NodeState::failed);
  for (const LayerIndex layer : {kShaky, kSteady}) {
    bench.graph.set_demand(std::vector{layer, kDependent});
    bench.run();
  }
  bench.remove_last();
  REQUIRE(bench.report("shaky").stats.size() == 1);
  CHECK(std::get<std::int64_t>(bench.report("shaky").stats[0].value) == 3);
}

TEST_CASE("a structure that fails from the beginning has no picture, and recovers") {
  FailingBench bench;
  bench.insert({0, -1});
  CHECK(bench.report("shaky").state == NodeState::failed);
  CHECK(bench.contents.count(kShaky, kPoint) == 0);
  bench.insert({1, 1});
  CHECK(bench.contents.count(kShaky, kPoint) == 0);
  bench.post(move_samples(bench.document, std::vector{std::pair{bench.document.id(SampleSlot(0)), Vec2{0, 5}}}));
  CHECK(bench.report("shaky").state == NodeState::up_to_date);
  CHECK(bench.contents.count(kShaky, kPoint) == 2);
}

TEST_CASE("out of memory and broken invariants are failures like others") {
  FailingBench bench;
  bench.insert({0, 0});
  bench.insert({1, -2});
  CHECK(bench.report("shaky").state == NodeState::failed);
  CHECK(bench.report("shaky").reason == "out of memory");
  bench.remove_last();
  CHECK(bench.report("shaky").state == NodeState::up_to_date);
  bench.insert({1, -3});
  CHECK(bench.report("shaky").state == NodeState::failed);
  CHECK(bench.report("shaky").reason.starts_with("broken invariant: y > 0.0"));
  bench.remove_last();
  CHECK(bench.contents.sorted(kShaky) == bench.contents.sorted(kSteady));
}

TEST_CASE("an old picture is withdrawn when the drawing frame it is in is gone") {
  FailingBench bench;
  bench.insert({0, 0});
  bench.insert({1, 0});
  bench.insert({2, -1});
  REQUIRE(bench.contents.count(kShaky, kPoint) == 2);
  const DrawingFrame before = bench.patch.frame;
  bench.insert({1e12, 1e12});
  CHECK(bench.patch.frame != before);
  CHECK(bench.contents.count(kShaky, kPoint) == 0);
  CHECK(bench.contents.count(kSteady, kPoint) == 4);
}

TEST_CASE("in a new drawing frame every picture is sent whole") {
  FailingBench bench;
  bench.insert({0, 0});
  bench.insert({1, 0});
  const DrawingFrame before = bench.patch.frame;
  bench.insert({1e12, 1e12});
  REQUIRE(bench.patch.frame != before);
  for (const LayerIndex layer : {kSteady, kShaky, kDependent}) {
    REQUIRE(bench.brings(layer));
    const auto patch = std::ranges::find(bench.patch.layers, layer, &LayerPatch::layer);
    CHECK((*patch)[kPoint].reset);
  }
}

TEST_CASE("where there is no room for a new picture the old one stays, and its frame with it") {
  FailingBench bench;
  bench.insert({0, 0});
  bench.insert({1, 0});
  const DrawingFrame before = bench.patch.frame;
  bench.insert({2, -2});
  REQUIRE(bench.report("shaky").reason == kOutOfMemory);
  CHECK(lacks_memory(bench.patch.nodes, bench.patch.reports));
  bench.insert({1e12, 1e12});
  CHECK(bench.patch.frame == before);
  CHECK(bench.contents.count(kShaky, kPoint) == 2);
  CHECK(bench.contents.count(kDependent, kPoint) == 2);
  CHECK(bench.contents.count(kSteady, kPoint) == 4);
  // Another document, and still no room.
  bench.post(replace_all(bench.document, {.positions = {{5e9, 5e9}, {5e9 + 1, 5e9}, {0, -2}}}));
  CHECK(bench.patch.frame == before);
  CHECK(bench.contents.count(kShaky, kPoint) == 2);
  CHECK(bench.contents.count(kSteady, kPoint) == 3);
  // With room again, everything is in a new frame.
  bench.remove_last();
  CHECK(bench.patch.frame != before);
  CHECK_FALSE(lacks_memory(bench.patch.nodes, bench.patch.reports));
  CHECK(bench.brings(kSteady));
  CHECK(bench.contents.sorted(kShaky) == bench.contents.sorted(kSteady));
  CHECK(bench.contents.sorted(kDependent) == bench.contents.sorted(kSteady));
}

TEST_CASE("lack of memory does not call the result wrong") {
  FailingBench bench;
  bench.insert({0, 0});
  bench.insert({1, -2});
  CHECK(light_of(bench.patch.nodes) == TheoremLight::none);
  bench.remove_last();
  bench.insert({1, -1});
  CHECK(light_of(bench.patch.nodes) == TheoremLight::red);
  bench.remove_last();
  bench.insert({1, -4});
  CHECK(bench.report("shaky").state == NodeState::failed);
  CHECK(bench.report("shaky").reason == "it takes too many");
  CHECK(light_of(bench.patch.nodes) == TheoremLight::none);
  // A refusal before does not excuse another failure.
  bench.remove_last();
  bench.insert({1, -1});
  CHECK(light_of(bench.patch.nodes) == TheoremLight::red);
}

TEST_CASE("the engine outlives failures") {
  Document document;
  Engine engine(shaky_registry(), {});
  LayerContents contents;
  engine.set_demand({kSteady, kShaky, kDependent});
  NodeState shaky = NodeState::inactive;
  const auto insert = [&](Vec2 p) {
    const auto delta = insert_samples(document, std::vector{p});
    document.apply(*delta);
    engine.post(std::make_shared<const DocumentDelta>(*delta));
    while (auto patch = engine.sync()) {
      contents.apply(*patch);
      shaky = patch->nodes[1].state;
      engine.recycle(std::move(patch));
    }
  };
  insert({0, 0});
  CHECK(shaky == NodeState::up_to_date);
  insert({1, -1});
  CHECK(shaky == NodeState::failed);
  insert({2, 0});
  CHECK(contents.count(kShaky, kPoint) == 1);
  CHECK(contents.count(kSteady, kPoint) == 3);
  const auto delta = remove_samples(document, std::vector{document.id(SampleSlot(1))});
  document.apply(*delta);
  engine.post(std::make_shared<const DocumentDelta>(*delta));
  insert({3, 0});
  CHECK(shaky == NodeState::up_to_date);
  CHECK(contents.sorted(kShaky) == contents.sorted(kSteady));
  CHECK(contents.sorted(kDependent) == contents.sorted(kSteady));
}
