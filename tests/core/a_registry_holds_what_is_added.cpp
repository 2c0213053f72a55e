// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <catch2/catch.hpp>
#include <set>

#include "core/builtins/builtins.h"
#include "core/document/commands.h"
#include "core/engine/graph.h"
#include "core/structures/delaunay/delaunay.h"

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
