// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <array>
#include <catch2/catch.hpp>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "core/builtins/builtins.h"
#include "core/document/commands.h"
#include "core/engine/graph.h"
#include "tests/support/builtin_layers.h"

using namespace mes;

namespace {

std::set<std::string> computed(const FramePatch& patch) {
  std::set<std::string> out;
  for (const NodeReport& node : patch.nodes)
    if (node.state == NodeState::up_to_date) out.insert(node.structure);
  return out;
}

}  // namespace

TEST_CASE("a graph computes the structures that are needed, with what they read, and no others") {
  Document document;
  document.apply(*insert_samples(document, std::array{Vec2{0.0, 0.0}, Vec2{1.0, 0.0}, Vec2{0.0, 1.0}}));
  const auto delta = std::make_shared<const DocumentDelta>(*replace_all(document, data_of(document)));
  Graph graph(builtins());
  graph.post(delta);
  FramePatch patch;
  JobControl job;
  const auto run = [&] {
    REQUIRE(graph.run(patch, job));
    return computed(patch);
  };
  const std::set<std::string> sources = run();
  CHECK_FALSE(sources.contains("delaunay"));

  graph.set_needed_structures(std::array<std::string_view, 2>{"medial-axis", "no-such-structure"});
  const std::set<std::string> needed = run();
  CHECK(patch.layer_count == 0);
  for (const char* id : {"medial-axis", "one-step-crust", "delaunay"}) CHECK(needed.contains(id));
  CHECK_FALSE(needed.contains("alpha-complex"));

  // They are the same as a layer needs that reads them, and both kinds of demand go together.
  Graph other(builtins());
  other.post(delta);
  other.set_demand(std::array{find_layer("medial-axis")});
  FramePatch other_patch;
  REQUIRE(other.run(other_patch, job));
  CHECK(std::ranges::includes(computed(other_patch), needed));
  graph.set_demand(std::array{find_layer("alpha-edges")});
  CHECK(std::ranges::includes(run(), needed));
  CHECK(computed(patch).contains("alpha-complex"));
  CHECK(patch.layer_count == 1);

  graph.set_needed_structures({});
  graph.set_demand(std::vector<LayerIndex>());
  CHECK(run() == sources);
}
