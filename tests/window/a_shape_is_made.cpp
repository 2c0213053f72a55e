// SPDX-License-Identifier: GPL-3.0-or-later
// The dialog of shapes, by the command palette and with keys alone.
#include <catch2/catch.hpp>
#include <cmath>

#include "core/io/format.h"
#include "tests/window/window_driver.h"

using namespace mes;
using namespace mes::test;

TEST_CASE("a shape is made in one step of undo, and Esc makes none") {
  DrivenProgram window;
  const VirtualScreen& screen = window.screen;
  window.folder.write("house.poff", "POFF 5 0 0\n0 0\n4 0\n4 3\n2 5\n0 3\n");
  window.start("house.poff");
  const Screenshot house = window.drawn();
  const auto is_dimmed = [&] { return !screen.shoot().is_white(90, 700); };
  REQUIRE_FALSE(is_dimmed());
  const auto open_dialog = [&] {
    window.press("ctrl+shift+p");
    REQUIRE(eventually([&] { return screen.shoot().differences(house, 0) > 1000; }));
    static_cast<void>(screen.settled());
    screen.xdotool("type --delay 20 make-shape");
    static_cast<void>(screen.settled());
    window.press("Return");
    REQUIRE(eventually(is_dimmed));
    static_cast<void>(screen.settled());
  };
  open_dialog();
  window.press("Escape");
  CHECK(window.shows(house));
  open_dialog();
  window.press("Return");
  REQUIRE(eventually([&] { return !is_dimmed(); }));
  const Screenshot circle = window.drawn();
  REQUIRE(circle.changes(kCanvas, house) > 1000);
  window.press("ctrl+z");
  static_cast<void>(window.other_than(circle));
  window.press("ctrl+shift+z");
  CHECK(window.nearly_shows(circle));
  window.save_as("circle.poff");
  const auto file = read_sample_file(window.folder / "circle.poff");
  REQUIRE(file.has_value());
  REQUIRE(file->data.positions.size() == 400);
  for (const Vec2 p : file->data.positions) CHECK(std::abs(length(p) - 1.0) < 1e-14);
}
