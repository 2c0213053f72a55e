// SPDX-License-Identifier: GPL-3.0-or-later
// The rail of icons at the right edge, the panels beside it, and a diagram in a window of its own.
#include <fmt/core.h>
#include <array>
#include <catch2/catch.hpp>
#include <string>

#include "tests/window/window_driver.h"

using namespace mes;
using namespace mes::test;

namespace {

constexpr std::array<int, 2> kPersistenceIcon{1259, 276};
constexpr std::array<int, 2> kLargeButton{1167, 417};  // in the title of the lower panel
constexpr PixelBox kUpper{942, 28, 1234, 394};
constexpr PixelBox kLower{942, 402, 1234, 768};

struct RailWindow : DrivenProgram {
  RailWindow() {
    folder.write("house.poff", kHouse);
    start("house.poff");
  }
  std::string settings() const { return bytes_of(folder / "config" / "mesecina" / "settings.json"); }
  /// The screen after a click, without the pointer on anything.
  Screenshot after_click(std::array<int, 2> at) const {
    screen.click(at);
    screen.xdotool("mousemove 1200 6");
    return screen.settled();
  }
  void quit() {
    press("ctrl+q");
    REQUIRE(eventually([&] { return !program.is_running(); }));
  }
};

bool is_gone_from(const PixelBox& where, const Screenshot& now, const Screenshot& before) {
  return now.changes(where, before) > 1000;
}

}  // namespace

TEST_CASE("an icon opens a panel below the pinned one, and closes it again") {
  RailWindow window;
  const Screenshot first = window.drawn();
  const Screenshot open = window.after_click(kPersistenceIcon);
  CHECK(open.changes(kUpper, first) == 0);
  CHECK(is_gone_from(kLower, open, first));
  CHECK(open.changes(kCanvas, first) == 0);
  // The list of layers takes the height that the panel leaves.
  const Screenshot closed = window.after_click(kPersistenceIcon);
  CHECK(is_gone_from(kLower, closed, open));
  CHECK(is_gone_from(kLower, closed, first));
  // Without any panel the drawing has the column.
  window.press("l");
  CHECK(eventually([&] { return window.screen.shoot().is_white(1200, 740); }));
  window.press("l");
  CHECK(eventually([&] { return !window.screen.shoot().is_white(1200, 740); }));
}

TEST_CASE("the next window has the panels of this one") {
  RailWindow window;
  static_cast<void>(window.drawn());
  static_cast<void>(window.after_click(kPersistenceIcon));
  window.screen.xdotool("mousemove 1200 6");
  const Screenshot wide = window.screen.settled();
  window.quit();
  window.start("house.poff");
  const Screenshot again = window.drawn();
  CHECK(again.changes({742, 28, 1234, 768}, wide) == 0);
}

TEST_CASE("a diagram opens large on white paper, is moved, and Escape closes it") {
  RailWindow window;
  static_cast<void>(window.drawn());
  window.press("shift+d");
  const Screenshot before = window.after_click(kPersistenceIcon);
  const Screenshot large = window.after_click(kLargeButton);
  const auto is_paper = [](Color c) { return c.r == 255 && c.g == 255 && c.b == 255; };
  const PixelBox paper = large.box_of(kCanvas, is_paper);
  REQUIRE(paper.right - paper.left > 400);
  REQUIRE(paper.bottom - paper.top > 300);
  // The window is dragged by its title, above three rows of controls.
  const int title = large.box_of_changes(kCanvas, before).top + 12;
  // The button is up before a frame shows that it was down.
  const auto to = [](int x, int y) { return fmt::format("mousemove {} {} ", x, y); };
  window.screen.xdotool(to(paper.left + 150, title) + "mousedown 1 " + to(paper.left + 90, title + 40) + "mouseup 1");
  window.screen.xdotool("mousemove 1200 6");
  const PixelBox moved = window.screen.settled().box_of(kCanvas, is_paper);
  CHECK(moved.left == paper.left - 60);
  CHECK(moved.top == paper.top + 40);
  window.press("Escape");
  CHECK(window.shows(before));
}

TEST_CASE("the key of a panel shows it even while all panels are hidden") {
  RailWindow window;
  const Screenshot first = window.drawn();
  window.press("Tab");
  REQUIRE(eventually([&] { return window.screen.shoot().is_white(1259, 700); }));
  window.press("shift+l");
  CHECK(eventually([&] { return window.screen.settled().changes(kLower, first) == 0; }));
}

TEST_CASE("the explanation of an icon of the rail covers no panel") {
  RailWindow window;
  const Screenshot before = window.drawn();
  window.screen.xdotool(fmt::format("mousemove {} {}", kPersistenceIcon[0], kPersistenceIcon[1]));
  constexpr PixelBox kBesideThePanels{600, 30, 938, 770};
  REQUIRE(eventually([&] { return window.screen.shoot().changes(kBesideThePanels, before) > 1000; }));
  constexpr PixelBox kPanels{940, 26, 1236, 770};
  CHECK(window.screen.settled().changes(kPanels, before) == 0);
}
