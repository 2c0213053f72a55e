// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/core.h>
#include <catch2/catch.hpp>

#include "tests/window/window_driver.h"

using namespace mes;
using namespace mes::test;

TEST_CASE("the card of an element opens in the corner where no samples are, and stays where it was dragged") {
  DrivenProgram window;
  // Samples near the lower corners of the view, none near the upper ones.
  window.folder.write("house.poff", kHouse);
  window.start("house.poff");
  const Screenshot before = window.drawn();
  const auto is_axis = [](Color c) { return c.r > 180 && c.g > 70 && c.g < 110 && c.b < 40; };
  const std::array<int, 2> axis = before.box_of(kCanvas, is_axis).middle();
  constexpr PixelBox kLowerLeft{64, 640, 240, 770};
  constexpr PixelBox kUpperLeft{70, 40, 240, 120};
  window.screen.click(axis);
  REQUIRE(eventually([&] { return window.screen.shoot().changes(kUpperLeft, before) > 300; }));
  const Screenshot shown = window.screen.settled();
  // Highlights of the element may reach there; a card would change all of it.
  CHECK(shown.changes(kLowerLeft, before) < 2000);
  // The card is dragged to the right by its header.
  window.screen.drag({120, 50}, {620, 60}, 4);
  window.screen.xdotool("mouseup 1");
  CHECK(eventually([&] { return window.screen.shoot().changes(kUpperLeft, before) == 0; }));
  window.press("Escape");
  window.screen.click({axis[0], axis[1] + 60});
  static_cast<void>(window.screen.settled());
  CHECK(eventually([&] { return window.screen.shoot().changes({600, 60, 960, 110}, before) > 300; }));
  CHECK(window.screen.settled().changes(kUpperLeft, before) == 0);
}

TEST_CASE("the card of an element does not lie on the scale bar where other corners are free") {
  DrivenProgram window;
  // No corner of the view has a sample.
  window.folder.write("diamond.poff", "POFF 4 0 0\n0 -1\n1 0\n0 1\n-1 0\n");
  std::filesystem::create_directories(window.folder / "config" / "mesecina");
  window.folder.write("config/mesecina/settings.json", R"({"schema": 1, "show_scale_bar": true})");
  window.start("diamond.poff");
  constexpr PixelBox kBar{66, 725, 240, 765};
  const auto is_ink = [](Color c) { return c.r < 60 && c.g < 60 && c.b < 70; };
  REQUIRE(eventually([&] { return !window.screen.shoot().box_of(kBar, is_ink).is_empty(); }));
  const Screenshot before = window.drawn();
  window.screen.click(kCanvas.middle());
  constexpr PixelBox kLowerRight{700, 700, 920, 765};
  REQUIRE(eventually([&] { return window.screen.shoot().changes(kLowerRight, before) > 300; }));
  // A highlighted ray may cross it; a card would change all of it.
  CHECK(window.screen.settled().changes(kBar, before) < 500);
}

TEST_CASE("a scale bar leaves its corner when the drawing comes there, and stays where it was dragged") {
  DrivenProgram window;
  // No corner of the view has a sample.
  window.folder.write("diamond.poff", "POFF 4 0 0\n0 -1\n1 0\n0 1\n-1 0\n");
  std::filesystem::create_directories(window.folder / "config" / "mesecina");
  window.folder.write("config/mesecina/settings.json", R"({"schema": 1, "show_scale_bar": true})");
  window.start("diamond.poff");
  constexpr PixelBox kLowerLeft{56, 725, 300, 768};
  constexpr PixelBox kLowerRight{690, 725, 936, 768};
  const auto is_ink = [](Color c) { return c.r < 60 && c.g < 60 && c.b < 70; };
  const auto bar_in = [&](const PixelBox& where) {
    const PixelBox box = window.screen.settled().box_of(where, is_ink);
    return box.right - box.left > 80 ? box : PixelBox{};
  };
  // The wheel button moves the view until its lowest sample lies on the bar.
  const auto move_view = [&](int right, int down) {
    window.screen.xdotool("mousemove 500 200 mousedown 2");
    for (int i = 1; i <= 4; ++i)
      window.screen.xdotool(fmt::format("mousemove {} {}", 500 + right * i / 4, 200 + down * i / 4));
    window.screen.xdotool("mouseup 2");
  };
  const Screenshot fitted = window.drawn();
  const PixelBox bar = bar_in(kLowerLeft);
  REQUIRE_FALSE(bar.is_empty());
  const PixelBox lowest = fitted.box_of({400, 700, 600, 745}, is_ink);
  REQUIRE_FALSE(lowest.is_empty());
  move_view(bar.middle()[0] - lowest.middle()[0], bar.middle()[1] - lowest.middle()[1]);
  CHECK(eventually([&] { return !bar_in(kLowerRight).is_empty(); }));
  CHECK(bar_in(kLowerLeft).is_empty());
  // It is dragged back, onto the sample.
  const PixelBox there = bar_in(kLowerRight);
  const std::array<int, 2> from{there.middle()[0], there.bottom - 6};
  window.screen.drag(from, {bar.middle()[0], bar.bottom - 6}, 4);
  window.screen.xdotool("mouseup 1 mousemove 500 300");
  CHECK(eventually([&] { return !bar_in(kLowerLeft).is_empty(); }));
  CHECK(bar_in(kLowerRight).is_empty());
}

TEST_CASE("a legend that is too large for the canvas is left out, and a message says so") {
  DrivenProgram window;
  window.folder.write("house.poff", kHouse);
  std::filesystem::create_directories(window.folder / "config" / "mesecina");
  // In this window the legend of one layer has room, and that of four layers has none.
  window.folder.write("config/mesecina/settings.json",
                      R"({"schema": 1, "show_key": true, "window_width": 380, "window_height": 290})");
  window.start("house.poff");
  const auto letters_on = [](const Screenshot& shot) {
    const auto is_ink = [](Color c) { return c.r < 60 && c.g < 60 && c.b < 70; };
    int out = 0;
    for (int y = 30; y < 255; ++y)
      for (int x = 100; x < 300; ++x) out += is_ink(shot.at(x, y)) ? 1 : 0;
    return out;
  };
  window.press("1");
  const int of_legend = letters_on(window.screen.settled());
  window.press("5");
  CHECK(eventually([&] { return letters_on(window.screen.shoot()) > 2 * of_legend; }));
  CHECK(letters_on(window.screen.settled()) < of_legend);
}

TEST_CASE("a legend leaves the corner to which a line is drawn, and a snapshot has it where the window has it") {
  DrivenProgram window;
  // One ray of the Voronoi diagram goes into the lower right corner, none into the lower left one.
  window.folder.write("triangle.poff", "POFF 3 0 0\n0.94 0.34\n-0.64 0.77\n-0.17 -0.98\n");
  std::filesystem::create_directories(window.folder / "config" / "mesecina");
  window.folder.write("config/mesecina/settings.json", R"({"schema": 1, "show_key": true})");
  window.start("triangle.poff", {{"HOME", window.folder.path().string()}});
  static_cast<void>(window.drawn());
  constexpr PixelBox kLowerLeft{60, 676, 180, 768};
  constexpr PixelBox kLowerRight{700, 640, 936, 768};
  const auto letters_in = [](const Screenshot& shot, const PixelBox& where) {
    int out = 0;
    for (int y = where.top; y < where.bottom; ++y)
      for (int x = where.left; x < where.right; ++x) {
        const Color c = shot.at(x, y);
        out += c.r < 150 && c.g < 150 ? 1 : 0;  // the ray is lighter
      }
    return out;
  };
  window.press("1");
  CHECK(eventually([&] { return letters_in(window.screen.shoot(), kLowerRight) > 50; }));
  CHECK(letters_in(window.screen.settled(), kLowerLeft) == 0);
  window.press("2");
  CHECK(eventually([&] { return letters_in(window.screen.shoot(), kLowerLeft) > 100; }));
  CHECK(letters_in(window.screen.settled(), kLowerRight) == 0);
  window.press("F3");
  Screenshot snapshot(0, 0, {});
  REQUIRE(eventually([&] {
    std::error_code error;
    for (const auto& entry : std::filesystem::directory_iterator(window.folder / "mesecina", error))
      if (entry.path().extension() == ".png") snapshot = read_picture(entry.path());
    return !snapshot.is_empty();
  }));
  const int width = snapshot.width();
  const int height = snapshot.height();
  CHECK(letters_in(snapshot, {0, 3 * height / 4, width / 5, height}) > 100);
  CHECK(letters_in(snapshot, {4 * width / 5, 3 * height / 4, width, height}) == 0);
}
