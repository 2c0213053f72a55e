// SPDX-License-Identifier: GPL-3.0-or-later
// How dense the samples are is computed for a page that shows it, also while no layer does.
#include <catch2/catch.hpp>
#include <cmath>
#include <string>

#include "app/editing/editor.h"
#include "app/panes/engine_demand.h"
#include "app/window/work/workspace.h"
#include "core/builtins/builtins.h"
#include "core/engine/sampling_verdict.h"
#include "tests/support/builtin_layers.h"

using namespace mes;

TEST_CASE("the engine keeps the density of samples up to date while it is looked at") {
  Engine engine(builtins(), {});
  LayerStack layers(layer_descriptors());
  layers.set_visible(find_layer("sampling-epsilon"), false);
  layers.set_visible(find_layer("feature-size"), false);
  PaneList list;
  const ComputationSettings settings;
  EngineDemand demand;
  Editor editor([&](std::shared_ptr<const DocumentDelta> delta) { engine.post(std::move(delta)); });
  SampleData data;
  for (int i = 0; i < 40; ++i) data.positions.push_back({std::cos(0.157 * i), 0.7 * std::sin(0.157 * i)});
  REQUIRE(editor.load(data));
  engine.set_want_findings(true);
  const auto summary_where = [&](bool with_density) {
    EngineDemand::Wanted wanted{builtins(), layers, list, settings, editor.document().revision()};
    wanted.with_density = with_density;
    CHECK(demand.follow(engine, wanted, false));
    CHECK_FALSE(demand.follow(engine, wanted, false));
    std::string out;
    while (auto patch = engine.sync()) {
      if (const auto epsilon = sampling_verdict(patch->nodes).epsilon) out = epsilon->text();
      engine.recycle(std::move(patch));
    }
    return out;
  };
  CHECK(summary_where(false).empty());
  CHECK(summary_where(true).starts_with("estimated epsilon "));
  CHECK(summary_where(false).empty());
  layers.set_visible(find_layer("sampling-epsilon"), true);
  CHECK(summary_where(true).starts_with("estimated epsilon "));
}

TEST_CASE("a workspace measures the density of so many samples without a layer") {
  Messages messages;
  Workspace work(builtins(), "assets", messages, [] {});
  work.layers().set_visible(find_layer("sampling-epsilon"), false);
  work.layers().set_visible(find_layer("feature-size"), false);
  work.engine().set_want_findings(true);
  const auto verdict_on = [&](int samples) {
    SampleData data;
    for (int i = 0; i < samples; ++i) data.positions.push_back({std::cos(0.15 * i), 0.7 * std::sin(0.15 * i)});
    REQUIRE(work.editor().load(data));
    work.follow_layers(false, true);
    std::string out;
    while (auto patch = work.engine().sync()) {
      out = sampling_verdict(patch->nodes).text();
      work.engine().recycle(std::move(patch));
    }
    return out;
  };
  work.measure_density(40);
  CHECK(verdict_on(40).starts_with("estimated epsilon "));
  CHECK_FALSE(verdict_on(41).contains("epsilon"));
  work.measure_density(41);
  CHECK(verdict_on(41).starts_with("estimated epsilon "));
}
