// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <catch2/catch.hpp>

#include "app/window/work/workspace.h"
#include "tests/support/added_to_registry.h"

using namespace mes;
using namespace mes::test;

TEST_CASE("a workspace lists, computes and saves what was added to its registry") {
  const Registry& registry = registry_with_additions();
  Messages messages;
  Workspace work(registry, "assets", messages, [] {});
  const LayerIndex added = work.layers().find("doubled-points");
  REQUIRE(added != kNoLayer);
  // What the panel of parameters and the palette list.
  CHECK(std::ranges::count(work.computation().parameters(), kDoublingFactor) == 1);
  const auto evolutions = work.evolution().evolutions();
  const auto doubling =
      std::ranges::find_if(evolutions, [](const auto& evolution) { return evolution->descriptor.id == "doubling"; });
  REQUIRE(doubling != evolutions.end());

  REQUIRE(work.editor().load({.positions = {{0, 0}, {1, 0}, {0, 1}}}));
  work.layers().set_visible(added, true);
  work.computation().set(kDoublingFactor, 3.0);
  CHECK(work.follow_layers(false, true));
  LayerMirror mirror;
  while (auto patch = work.engine().sync()) {
    mirror.apply(*patch);
    work.engine().recycle(std::move(patch));
  }
  const auto shown = mirror.instances(added, PrimitiveKind::point);
  REQUIRE(shown.size() == 3 * stride_of(PrimitiveKind::point));
  CHECK(*std::ranges::max_element(shown) == 3.0);

  work.evolution().choose(*doubling);
  CHECK(work.evolution_now().id == "doubling");
  const Session carried = work.session_for_picture("Additions", {}, {});
  CHECK(std::ranges::count(carried.layers.layers, std::string("doubled-points"), &LayerConfiguration::Entry::layer) ==
        1);
  CHECK(carried.settings[kDoublingFactor] == 3.0);
}
