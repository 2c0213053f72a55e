// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <array>
#include <catch2/catch.hpp>
#include <set>
#include <string>
#include <vector>

#include "app/settings/panel_choice.h"
#include "core/base/rng.h"

using namespace mes;

namespace {

using Pages = std::vector<PanelPage>;

Pages shown_in(const PanelChoice& panels) {
  return {panels.shown().begin(), panels.shown().end()};
}

}  // namespace

TEST_CASE("a panel that opens takes the place of those that are not pinned") {
  PanelChoice panels;
  REQUIRE(shown_in(panels) == Pages{PanelPage::layers, PanelPage::bundles});
  REQUIRE(panels.pinned() == PanelPage::layers);
  panels.toggle(PanelPage::log);
  CHECK(shown_in(panels) == Pages{PanelPage::layers, PanelPage::log});
  panels.toggle_pin(PanelPage::layers);
  CHECK(shown_in(panels) == Pages{PanelPage::layers, PanelPage::log});
  panels.toggle(PanelPage::curves);
  CHECK(shown_in(panels) == Pages{PanelPage::curves});
  panels.toggle(PanelPage::curves);
  CHECK(shown_in(panels).empty());
}

TEST_CASE("the pinned panel is above, also when it is pinned or opened last") {
  PanelChoice panels;
  panels.toggle_pin(PanelPage::bundles);
  CHECK(shown_in(panels) == Pages{PanelPage::bundles, PanelPage::layers});
  panels.toggle(PanelPage::bundles);
  CHECK(shown_in(panels) == Pages{PanelPage::layers});
  panels.toggle(PanelPage::log);
  CHECK(shown_in(panels) == Pages{PanelPage::log});
  panels.toggle(PanelPage::bundles);
  CHECK(shown_in(panels) == Pages{PanelPage::bundles, PanelPage::log});
}

TEST_CASE("without room for two the last one is shown, and the other returns with the room") {
  PanelChoice panels;
  panels.open(PanelPage::persistence);
  panels.set_room(1);
  CHECK(shown_in(panels) == Pages{PanelPage::persistence});
  CHECK_FALSE(panels.is_shown(PanelPage::layers));
  // The key of a panel without room shows it.
  panels.toggle(PanelPage::layers);
  CHECK(shown_in(panels) == Pages{PanelPage::layers});
  panels.set_room(2);
  CHECK(shown_in(panels) == Pages{PanelPage::layers, PanelPage::persistence});
  panels.set_room(1);
  panels.toggle(PanelPage::layers);
  CHECK(shown_in(panels) == Pages{PanelPage::persistence});
}

TEST_CASE("a panel is in use while its diagram is large, and that is not remembered") {
  PanelChoice panels;
  const PanelChoice before = panels;
  panels.set_large(PanelPage::persistence);
  CHECK(panels.is_in_use(PanelPage::persistence));
  CHECK_FALSE(panels.is_shown(PanelPage::persistence));
  CHECK(panels == before);
}

TEST_CASE("every panel has a name of its own, by which it is found") {
  std::set<std::string_view> names;
  for (std::size_t i = 0; i < kPanelPages; ++i) {
    const auto page = static_cast<PanelPage>(i);
    CHECK(names.insert(id_of(page)).second);
    CHECK(find_panel(id_of(page)) == page);
  }
  CHECK_FALSE(find_panel("none"));
}

TEST_CASE("whatever is opened, closed and pinned, a panel that was toggled answers, and at most two are open") {
  Rng random(7);
  PanelChoice panels;
  for (int turn = 0; turn < 2000; ++turn) {
    const auto page = static_cast<PanelPage>(random.below(kPanelPages));
    panels.set_room(1 + random.below(2));
    const bool was_shown = panels.is_shown(page);
    const bool pins = random.below(4) == 0;
    if (pins)
      panels.toggle_pin(page);
    else
      panels.toggle(page);
    if (!pins) CHECK(panels.is_shown(page) == !was_shown);
    const auto all = panels.all();
    REQUIRE(all.size() <= 2);
    CHECK((all.size() < 2 || all[0] != all[1]));
    // The pinned panel is nowhere but above.
    CHECK((all.size() < 2 || panels.pinned() != all[1]));
    CHECK(panels.shown().empty() == all.empty());
    CHECK(PanelChoice(all, panels.pinned()) == panels);
  }
}

TEST_CASE("without room for any the panels are hidden until one is opened, and return with the room") {
  PanelChoice panels;
  const PanelChoice before = panels;
  panels.set_room(0);
  CHECK(shown_in(panels).empty());
  CHECK(panels == before);
  panels.toggle(PanelPage::layers);
  CHECK(shown_in(panels) == Pages{PanelPage::layers});
  panels.set_room(0);
  CHECK(shown_in(panels) == Pages{PanelPage::layers});
  panels.set_room(2);
  CHECK(shown_in(panels) == Pages{PanelPage::layers, PanelPage::bundles});
  panels.set_room(0);
  CHECK(shown_in(panels).empty());
  // Another panel is shown alone, and closing it leaves no other one over the drawing.
  panels.toggle(PanelPage::log);
  CHECK(shown_in(panels) == Pages{PanelPage::log});
  panels.toggle(PanelPage::log);
  CHECK(shown_in(panels).empty());
  panels.set_room(1);
  CHECK(shown_in(panels) == Pages{PanelPage::layers});
}
