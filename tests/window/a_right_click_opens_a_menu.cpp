// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/core.h>
#include <catch2/catch.hpp>

#include "core/io/format.h"
#include "tests/window/window_driver.h"

using namespace mes;
using namespace mes::test;

namespace {

struct MenuWindow : DrivenProgram {
  Screenshot before;
  std::array<int, 2> roof{};  // the sample (2, 5) on the screen

  MenuWindow() : before(0, 0, {}) {
    folder.write("house.poff", kHouse);
    start("house.poff");
    before = drawn();
    const auto is_black = [](Color c) { return c.r < 40 && c.g < 40 && c.b < 40; };
    const PixelBox samples = before.box_of(kCanvas, is_black);
    roof = {samples.middle()[0], samples.top + 3};
  }
  void right_click(std::array<int, 2> at) const {
    screen.xdotool(fmt::format("mousemove {} {} click 3", at[0], at[1]));
  }
  /// Waits until a menu hides much of the drawing, to the lower right of this point.
  PixelBox menu_at(std::array<int, 2> at) const {
    PixelBox out;
    INFO("there is no menu");
    REQUIRE(eventually([&] {
      out = screen.shoot().box_of_changes({at[0] + 2, at[1] + 12, kCanvas.right, kCanvas.bottom}, before);
      return out.right - out.left > 100 && out.bottom - out.top > 60;
    }));
    static_cast<void>(screen.settled());
    return out;
  }
  SampleData saved() const {
    REQUIRE(eventually([&] { return title().starts_with("* house.poff"); }));
    press("ctrl+s");
    REQUIRE(eventually([&] { return title().starts_with("house.poff"); }));
    const auto read = read_sample_file(folder / "house.poff");
    REQUIRE(read);
    return read->data;
  }
};

constexpr std::array<int, 2> kPaper{130, 420};  // beside the house

}  // namespace

TEST_CASE("the menu of a sample deletes it, and Esc or a click elsewhere closes the menu") {
  const MenuWindow window;
  window.right_click(window.roof);
  window.menu_at(window.roof);
  window.press("Escape");
  CHECK(eventually([&] {
    return window.screen.shoot().changes({kCanvas.left, kCanvas.top + 300, kCanvas.right, kCanvas.bottom},
                                         window.before) == 0;
  }));
  window.right_click(window.roof);
  window.menu_at(window.roof);
  window.screen.click(kPaper);
  static_cast<void>(window.screen.settled());
  CHECK(window.title().starts_with("house.poff"));
  window.right_click(window.roof);
  window.menu_at(window.roof);
  // The first key marks the first row.
  window.press("Down");
  static_cast<void>(window.screen.settled());
  window.press("Return");
  const SampleData left = window.saved();
  REQUIRE(left.positions.size() == 4);
  for (const Vec2 p : left.positions) CHECK(p.y < 5);
}

TEST_CASE("the menu of empty paper, also by key, inserts a sample where it was opened") {
  const MenuWindow window;
  window.screen.xdotool(fmt::format("mousemove {} {}", kPaper[0], kPaper[1]));
  static_cast<void>(window.screen.settled());
  window.press("shift+F10");
  window.menu_at(kPaper);
  window.press("Down");
  static_cast<void>(window.screen.settled());
  window.press("Return");
  const SampleData more = window.saved();
  REQUIRE(more.positions.size() == 6);
  CHECK(more.positions.back().x < -0.5);
  CHECK(more.positions.back().y > 0);
  CHECK(more.positions.back().y < 5);
}

TEST_CASE("the menu of empty paper writes words where it was opened") {
  const MenuWindow window;
  window.right_click(kPaper);
  window.menu_at(kPaper);
  for (const char* key : {"Down", "Down", "Return"}) {
    window.press(key);
    static_cast<void>(window.screen.settled());
  }
  window.screen.xdotool("type --delay 30 Here");
  REQUIRE(eventually([&] { return window.title().starts_with("* house.poff"); }));
  window.press("Escape");
  const PixelBox around{kPaper[0] - 10, kPaper[1] - 20, kPaper[0] + 60, kPaper[1] + 20};
  const auto words = [&] { return window.screen.settled().box_of_changes(around, window.before); };
  const PixelBox shown = words();
  CHECK(shown.right - shown.left > 15);
  CHECK(shown.bottom - shown.top > 6);
  // They are one step of undo.
  window.press("ctrl+z");
  CHECK(eventually([&] { return words().is_empty() && window.title().starts_with("house.poff"); }));
}

TEST_CASE("a drag with the right button pans and opens no menu") {
  const MenuWindow window;
  window.screen.xdotool(fmt::format("mousemove {} {} mousedown 3 mousemove {} {} mouseup 3", kPaper[0], kPaper[1],
                                    kPaper[0] + 60, kPaper[1]));
  const Screenshot after = window.screen.settled();
  CHECK(after.is_dark(window.roof[0] + 60, window.roof[1]));
  CHECK(after.is_white(kPaper[0] + 70, kPaper[1] + 40));
}
