// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <map>
#include <optional>
#include <set>
#include <string>

#include "core/base/rng.h"
#include "core/builtins/builtins.h"
#include "core/document/commands.h"
#include "core/engine/engine.h"
#include "core/engine/graph.h"
#include "core/structures/delaunay/delaunay.h"
#include "core/workbench/workbench.h"

using namespace mes;

namespace {

/// The longest edge at each site: a structure that the program does not have.
class LongestEdges final : public Structure {
 public:
  explicit LongestEdges(Delaunay& delaunay) : Structure("longest-edges", {&delaunay}), delaunay_(delaunay) {}

  void rebuild(JobControl&) override {
    longest_ = 0.0;
    for (const EdgeSlot edge : slots_below<EdgeSlot>(delaunay_.edge_rows())) {
      const EdgeRow& row = delaunay_.edge(edge);
      if (!row.is_alive()) continue;
      longest_ = std::max(longest_, distance(delaunay_.site_position(row.v[0]), delaunay_.site_position(row.v[1])));
    }
  }
  bool update(JobControl&) override { return false; }
  void clear_changes() override {}
  std::size_t touched() const override { return 0; }
  StatList statistics() const override { return {{"longest", longest_}}; }
  double longest() const { return longest_; }

 private:
  Delaunay& delaunay_;
  double longest_ = 0.0;
};

Layer make_long_edges_layer(const StructureSet& set) {
  const auto& delaunay = set.get<Delaunay>();
  const auto& longest = set.get<LongestEdges>();
  Layer layer{.descriptor = {.id = "long-edges", .kinds = {PrimitiveKind::segment}},
              .structures = {&delaunay, &longest},
              .parts = {}};
  layer.parts.push_back(table_part(
      {PrimitiveKind::segment}, [&delaunay] { return delaunay.edge_rows(); }, delaunay.edge_changes(),
      [&](EdgeSlot edge, Instance& out) {
        const EdgeRow& row = delaunay.edge(edge);
        if (!row.is_alive()) return;
        const Vec2 a = delaunay.site_position(row.v[0]);
        const Vec2 b = delaunay.site_position(row.v[1]);
        if (distance(a, b) == longest.longest()) out.segment(a, b);
      }));
  return layer;
}

}  // namespace

TEST_CASE("a registry makes what was added, under its own id, inputs before consumers") {
  const Registry& registry = builtins();
  const StructureSet set = registry.make_structures();
  REQUIRE(set.all().size() == registry.structures().size());
  std::set<const Structure*> before;
  for (std::size_t i = 0; i < set.all().size(); ++i) {
    const Structure& structure = *set.all()[i];
    INFO(structure.id());
    CHECK(structure.id() == registry.structures()[i]);
    for (const Structure* input : structure.inputs()) CHECK(before.contains(input));
    before.insert(&structure);
  }
  const std::vector<Layer> layers = registry.make_layers(set);
  REQUIRE(layers.size() == registry.layers().size());
  std::set<std::string_view> ids;
  for (LayerIndex i = 0; i < layers.size(); ++i) {
    CHECK(layers[i].descriptor.id == registry.layers()[i].id);
    CHECK(registry.find_layer(layers[i].descriptor.id) == i);
    CHECK(ids.insert(layers[i].descriptor.id).second);
    for (const Structure* structure : layers[i].structures) CHECK(before.contains(structure));
  }
  CHECK(registry.find_layer("no-such-layer") == kNoLayer);
}

TEST_CASE("what is added to the program's own is computed with it, and is nowhere else") {
  Registry registry;
  add_builtins(registry);
  registry.add_structure<LongestEdges, Delaunay>();
  registry.add_layer(make_long_edges_layer);
  const LayerIndex added = registry.find_layer("long-edges");
  CHECK(added == builtins().layers().size());
  CHECK(builtins().find_layer("long-edges") == kNoLayer);
  CHECK_FALSE(registry.layers()[added].follows_settings);
  CHECK(registry.layers()[registry.find_layer("a-union-boundary")].follows_settings);

  Graph graph{registry};
  graph.set_demand(std::array{added});
  Document document;
  FramePatch patch;
  JobControl job;
  const auto run = [&](const Expected<DocumentDelta>& delta) {
    REQUIRE(delta);
    document.apply(*delta);
    graph.post(std::make_shared<const DocumentDelta>(*delta));
    REQUIRE(graph.run(patch, job));
    REQUIRE(patch.layer_count == 1);
    return patch.layers.front()[PrimitiveKind::segment];
  };
  const KindPatch first = run(insert_samples(document, std::vector<Vec2>{{0, 0}, {1, 0}, {0, 2}}));
  CHECK(first.data == std::vector<double>{1, 0, 0, 2, 0});
  const KindPatch second = run(insert_samples(document, std::vector<Vec2>{{0, 9}}));
  CHECK(second.count == 1);
}

namespace {

/// Layer number i of some that read nothing but the samples, all in one call or each in its own.
Layer make_numbered_layer(const StructureSet& set, int i) {
  const auto& delaunay = set.get<Delaunay>();
  return {.descriptor = {.id = "numbered-" + std::to_string(i), .kinds = {PrimitiveKind::segment}},
          .structures = {&delaunay},
          .parts = {}};
}

Registry with_longest_edges() {
  Registry registry = builtins();
  registry.add_structure<LongestEdges, Delaunay>();
  registry.add_layer(make_long_edges_layer);
  return registry;
}

const std::vector<Vec2> kFive{{0, 0}, {4, 0}, {5, 3}, {1, 6}, {2, 2}};

std::vector<double> instances_of(const Workbench& bench, std::string_view layer) {
  const auto found = bench.instances(layer, PrimitiveKind::segment);
  REQUIRE(found);
  return {found->begin(), found->end()};
}

}  // namespace

TEST_CASE("a layer keeps its index while others come and go, and has it again") {
  Rng rng(5);
  Registry registry = builtins();
  const std::size_t own = registry.layers().size();
  std::map<std::string, LayerIndex> index_of;
  std::set<std::string> there;
  for (int step = 0; step < 300; ++step) {
    const int first = static_cast<int>(rng.below(12));
    const std::string id = "numbered-" + std::to_string(first);
    if (there.contains(id)) {
      CHECK(registry.remove_layer(id));
      CHECK_FALSE(registry.remove_layer(id));
      there.erase(id);
    } else {
      // Together with the next one, where that is not there either.
      const std::string next = "numbered-" + std::to_string(first + 1);
      const bool is_pair = !there.contains(next) && rng.below(2) == 0;
      registry.add_layers([first, is_pair](const StructureSet& set) {
        std::vector<Layer> out;
        out.push_back(make_numbered_layer(set, first));
        if (is_pair) out.push_back(make_numbered_layer(set, first + 1));
        return out;
      });
      there.insert(id);
      if (is_pair) there.insert(next);
    }
    if (rng.below(8) == 0) registry = Registry(registry);
    for (const std::string& one : there) {
      const LayerIndex index = registry.find_layer(one);
      REQUIRE(index != kNoLayer);
      CHECK(index >= own);
      CHECK(index_of.try_emplace(one, index).first->second == index);
    }
    const std::vector<Layer> layers = registry.make_layers(registry.make_structures());
    REQUIRE(layers.size() == registry.layers().size());
    for (LayerIndex i = 0; i < layers.size(); ++i) {
      const LayerDescriptor& descriptor = registry.layers()[i];
      CHECK(layers[i].descriptor.id == descriptor.id);
      CHECK(layers[i].descriptor.is_removed == descriptor.is_removed);
      CHECK(descriptor.is_removed == (registry.find_layer(descriptor.id) == kNoLayer));
      CHECK((i < own || descriptor.is_removed != there.contains(descriptor.id)));
    }
  }
  CHECK(index_of.size() == 13);
}

TEST_CASE("what is computed from a structure goes with it") {
  Registry registry = with_longest_edges();
  const std::size_t structures = registry.structures().size();
  CHECK_FALSE(registry.remove_structure("no-such-structure"));
  CHECK(registry.remove_structure("longest-edges"));
  CHECK(registry.structures().size() + 1 == structures);
  CHECK(registry.find_layer("long-edges") == kNoLayer);
  CHECK(registry.find_layer("delaunay") == builtins().find_layer("delaunay"));

  CHECK(registry.remove_structure("delaunay"));
  CHECK(registry.find_layer("delaunay") == kNoLayer);
  CHECK(registry.find_layer("medial-axis") == kNoLayer);
  CHECK(registry.find_layer("points") == builtins().find_layer("points"));
  const StructureSet set = registry.make_structures();
  CHECK(std::ranges::none_of(set.all(), [](const auto& structure) {
    return std::ranges::any_of(structure->inputs(), [](const Structure* input) { return input->id() == "delaunay"; });
  }));
  // A copy goes its own way.
  CHECK(with_longest_edges().find_layer("medial-axis") != kNoLayer);

  registry.add_parameter({.id = "reach"});
  REQUIRE(registry.find_parameter("reach") != nullptr);
  CHECK(registry.remove_parameter("reach"));
  CHECK(registry.find_parameter("reach") == nullptr);
  CHECK_FALSE(registry.remove_parameter("reach"));
}

TEST_CASE("a workbench whose registry changes computes what is new, and nothing else") {
  const Registry larger = with_longest_edges();
  Workbench bench(builtins());
  JobControl job;
  std::vector<std::string> computed;
  bench.set_on_task([&computed](std::string_view id) { computed.emplace_back(id); });
  const auto ids = bench.insert(kFive);
  REQUIRE(ids);
  REQUIRE(bench.show({"delaunay", "medial-axis"}));
  REQUIRE(bench.run(job));
  const std::vector<double> edges = instances_of(bench, "delaunay");
  REQUIRE_FALSE(bench.show({"long-edges"}));

  bench.set_registry(larger);
  // There are no results of a run that has not been.
  CHECK_FALSE(bench.instances("delaunay", PrimitiveKind::segment));
  REQUIRE(bench.show({"delaunay", "medial-axis", "long-edges"}));
  computed.clear();
  REQUIRE(bench.run(job));
  std::erase(computed, "layers");
  CHECK(computed == std::vector<std::string>{"longest-edges"});
  CHECK(instances_of(bench, "delaunay") == edges);
  CHECK(instances_of(bench, "long-edges") == std::vector<double>{0, 0, 1, 6, 0});

  // Structures that stayed follow the next edit locally.
  REQUIRE(bench.move(std::vector{std::pair((*ids)[2], Vec2{7, 3})}));
  REQUIRE(bench.run(job));
  const auto node = std::ranges::find(bench.nodes(), "delaunay", &NodeReport::structure);
  REQUIRE(node != bench.nodes().end());
  CHECK_FALSE(node->rebuilt);
  CHECK(instances_of(bench, "long-edges").size() == 5);

  bench.set_registry(builtins());
  CHECK_FALSE(bench.show({"long-edges"}));
  computed.clear();
  REQUIRE(bench.run(job));
  std::erase(computed, "layers");
  CHECK(computed.empty());
  CHECK(bench.instances("long-edges", PrimitiveKind::segment).error().text == "unknown layer \"long-edges\"");
  Workbench fresh(builtins());
  REQUIRE(fresh.load(data_of(bench.document())));
  REQUIRE(fresh.show({"delaunay", "medial-axis"}));
  REQUIRE(fresh.run(job));
  for (const char* layer : {"delaunay", "medial-axis"}) CHECK(*bench.digest(layer) == *fresh.digest(layer));
  CHECK(bench.undo());
  REQUIRE(bench.run(job));
  CHECK(instances_of(bench, "delaunay").size() == edges.size());
}

TEST_CASE("a registry without one of the sources is refused, and nothing changes") {
  Registry without = builtins();
  REQUIRE(without.remove_structure("balls"));
  Workbench bench(builtins());
  JobControl job;
  REQUIRE(bench.insert_balls(std::vector<Disk>{{{0, 0}, 1}, {{1, 0}, 1}}));
  REQUIRE(bench.show({"b-union-boundary"}));
  REQUIRE(bench.run(job));
  const LayerDigest before = *bench.digest("b-union-boundary");
  CHECK_THROWS_AS(bench.set_registry(without), AssertionFailure);
  REQUIRE(bench.run(job));
  CHECK(*bench.digest("b-union-boundary") == before);
}

TEST_CASE("a layer that takes the place of one of other kinds leaves no instances of that one") {
  Registry with_points = with_longest_edges();
  REQUIRE(with_points.remove_layer("long-edges"));
  with_points.add_layer([](const StructureSet& set) {
    const auto& samples = set.get<Samples>();
    Layer layer{
        .descriptor = {.id = "long-edges", .kinds = {PrimitiveKind::point}}, .structures = {&samples}, .parts = {}};
    layer.parts.push_back(table_part(
        {PrimitiveKind::point}, [&samples] { return samples.row_count(); }, samples.changes(),
        [&samples](SampleSlot row, Instance& out) {
          if (samples.is_alive(row)) out.point(samples.position(row));
        }));
    return layer;
  });
  const auto first = std::make_shared<const Registry>(with_longest_edges());
  const LayerIndex layer = first->find_layer("long-edges");
  REQUIRE(with_points.find_layer("long-edges") == layer);
  Engine engine(first, {});
  LayerMirror mirror;
  const auto take = [&] {
    while (auto patch = engine.sync()) {
      mirror.apply(*patch);
      engine.recycle(std::move(patch));
    }
    return std::pair(mirror.count(layer, PrimitiveKind::segment), mirror.count(layer, PrimitiveKind::point));
  };
  engine.set_demand({layer});
  const auto delta = insert_samples(Document(), kFive);
  REQUIRE(delta);
  engine.post(std::make_shared<const DocumentDelta>(*delta));
  CHECK(take() == std::pair(1U, 0U));
  engine.set_registry(std::make_shared<const Registry>(with_points));
  CHECK(take() == std::pair(0U, 5U));
  engine.set_registry(first);
  CHECK(take() == std::pair(1U, 0U));
}

TEST_CASE("variants and their documents outlast a change of the registry") {
  const Registry larger = with_longest_edges();
  SampleData other;
  other.positions = {{0, 0}, {3, 0}, {0, 1}};
  ComputationSettings naive;
  naive.precision = Precision::naive;
  Workbench bench(builtins());
  JobControl job;
  REQUIRE(bench.insert(kFive));
  REQUIRE(bench.compare_with(
      std::vector<WorkbenchVariant>{{.data = std::make_shared<const SampleData>(other)}, {.settings = naive}}));
  bench.set_registry(larger);
  const LayerIndex added = larger.find_layer("long-edges");
  bench.show({VariantLayer(kMainVariant, added), VariantLayer(1, added)});
  REQUIRE(bench.run(job));
  CHECK(bench.mirror().count(VariantLayer(kMainVariant, added), PrimitiveKind::segment) == 1);
  const auto longest = bench.mirror().instances(VariantLayer(1, added), PrimitiveKind::segment);
  CHECK(std::vector<double>(longest.begin(), longest.end()) == std::vector<double>{3, 0, 0, 1, 0});
}

TEST_CASE("an engine takes another registry while it works") {
  const auto larger = std::make_shared<const Registry>(with_longest_edges());
  const LayerIndex added = larger->find_layer("long-edges");
  Engine engine(builtins(), {});
  LayerMirror mirror;
  const auto take = [&] {
    while (auto patch = engine.sync()) {
      mirror.apply(*patch);
      engine.recycle(std::move(patch));
    }
  };
  Document document;
  const auto post = [&](const Expected<DocumentDelta>& delta) {
    REQUIRE(delta);
    document.apply(*delta);
    engine.post(std::make_shared<const DocumentDelta>(*delta));
  };
  const LayerIndex delaunay = builtins().find_layer("delaunay");
  engine.set_demand({delaunay});
  post(insert_samples(document, kFive));
  engine.set_registry(larger);
  engine.set_demand({delaunay, added});
  post(insert_samples(document, std::vector<Vec2>{{9, 9}}));
  take();
  CHECK(mirror.count(added, PrimitiveKind::segment) == 1);
  engine.set_registry(std::make_shared<const Registry>(builtins()));
  engine.set_demand({delaunay, added});
  post(insert_samples(document, std::vector<Vec2>{{2, 9}}));
  take();
  // Demand for a layer that was removed is ignored.
  Workbench fresh(builtins());
  JobControl job;
  REQUIRE(fresh.load(data_of(document)));
  REQUIRE(fresh.show({"delaunay"}));
  REQUIRE(fresh.run(job));
  CHECK(mirror.digest(delaunay) == *fresh.digest("delaunay"));
}

TEST_CASE("structures say which parameters they read, and layers which have a say in them") {
  const Registry& registry = builtins();
  const auto find = [&registry](std::string_view id) { return registry.find_structure(id); };
  CHECK(find("a-union")->parameters == std::vector<std::string>{"union-shortcut", "a-scale"});
  CHECK(find("delaunay")->all_parameters.empty());
  CHECK(find("no-such-structure") == nullptr);
  const auto& layer = registry.layers()[registry.find_layer("lambda-kept-boundary")];
  CHECK(std::ranges::count(layer.parameters, "lambda-limit") == 1);
  std::set<std::string> read;
  for (const std::string_view id : registry.structures()) {
    const StructureSpec& spec = *find(id);
    for (const std::string& parameter : spec.parameters) CHECK(registry.find_parameter(parameter) != nullptr);
    read.insert(spec.parameters.begin(), spec.parameters.end());
  }
  CHECK(read.size() == registry.parameters().size());
}

TEST_CASE("a parameter that a structure does not name leaves it as it is") {
  Workbench bench(builtins());
  JobControl job;
  std::vector<Vec2> samples;
  for (int i = 0; i < 60; ++i) {
    const double t = 0.1047197551 * i;
    samples.push_back({3.0 * std::cos(t), (1.0 + 0.3 * std::cos(3.0 * t)) * std::sin(t)});
  }
  REQUIRE(bench.insert(samples));
  REQUIRE(bench.insert_balls(std::vector<Disk>{{{0, 0}, 1}, {{1, 0.2}, 0.7}, {{2.5, 0}, 1.1}}));
  const auto ids = builtins().structures();
  REQUIRE(bench.need(std::vector<std::string_view>(ids.begin(), ids.end())));
  REQUIRE(bench.run(job));
  std::vector<std::string> computed;
  bench.set_on_task([&computed](std::string_view id) { computed.emplace_back(id); });
  for (const Parameter& parameter : builtins().parameters()) {
    INFO(parameter.id);
    const double before = bench.settings()[parameter];
    const double other = parameter.is_whole ? (before == parameter.low ? parameter.low + 1.0 : parameter.low)
                                            : before + 0.01 * std::min(1.0, parameter.high - before);
    REQUIRE(other != before);
    computed.clear();
    REQUIRE(bench.set(parameter, other));
    REQUIRE(bench.run(job));
    CHECK_FALSE(computed.empty());
    for (const std::string& id : computed) {
      INFO(id);
      if (id == "settings") continue;
      const StructureSpec& spec = *builtins().find_structure(id);
      const bool is_named = std::ranges::count(spec.all_parameters, parameter.id) == 1;
      const auto node = std::ranges::find(bench.nodes(), id, &NodeReport::structure);
      REQUIRE(node != bench.nodes().end());
      CHECK((is_named || (node->touched == 0 && !node->rebuilt)));
    }
  }
}
