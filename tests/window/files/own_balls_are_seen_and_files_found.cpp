// SPDX-License-Identifier: GPL-3.0-or-later
// Own balls under the bundles of the union, and the file dialog by keyboard.
#include <catch2/catch.hpp>
#include <cmath>
#include <filesystem>
#include <fstream>

#include "tests/window/window_driver.h"

using namespace mes;
using namespace mes::test;

namespace {

struct BallWindow : DrivenProgram {
  explicit BallWindow(const std::string& name) {
    folder.write("balls.wpoff", "WPOFF 5 0 0\n0 0 2\n2 1 1.5\n4 0 2\n5 3 1\n1 3 1.2\n");
    folder.write("house.poff", "POFF 5 0 0\n0 0\n4 0\n4 3\n2 5\n0 3\n");
    folder.write("square.poff", "POFF 4 0 0\n0 0\n4 0\n4 4\n0 4\n");
    start(name);
  }
  /// Pixels of the canvas with the green of the dual complex.
  int green() const {
    const Screenshot shot = screen.shoot();
    int out = 0;
    for (int y = kCanvas.top; y < kCanvas.bottom; ++y)
      for (int x = kCanvas.left; x < kCanvas.right; ++x) {
        const Color c = shot.at(x, y);
        out += c.g > c.r + 30 && c.g > c.b + 10 ? 1 : 0;
      }
    return out;
  }
};

}  // namespace

TEST_CASE("the bundles of the union show one's own balls where they are all there is") {
  const BallWindow window("balls.wpoff");
  static_cast<void>(window.screen.settled());
  CHECK(window.green() == 0);
  // The dual complex: faces and edges in green.
  window.press("7");
  CHECK(eventually([&] { return window.green() > 500; }));
  // What is taken back is only that.
  window.press("ctrl+z");
  CHECK(eventually([&] { return window.green() == 0; }));
}

TEST_CASE("layers that have nothing to show say so, and a click shows what is there") {
  const BallWindow window("balls.wpoff");
  const Screenshot first = window.screen.settled();
  // The one-step axis is of samples, and there are none.
  window.press("4");
  const auto is_note = [](Color c) { return c.r == 0xF7 && c.g == 0xF8 && c.b == 0xF9; };
  const PixelBox middle{300, 250, 800, 550};
  REQUIRE(eventually([&] { return !window.screen.shoot().box_of(middle, is_note).is_empty(); }));
  const Screenshot shown = window.screen.settled();
  const PixelBox note = shown.box_of(middle, is_note);
  // The button is at its foot.
  window.screen.click({note.left + 60, note.bottom - 24});
  CHECK(eventually([&] {
    const Screenshot shot = window.screen.shoot();
    return shot.box_of(middle, is_note).is_empty() && shot.differences(shown, 30) > 5000;
  }));
  static_cast<void>(first);
}

TEST_CASE("a file is found and opened by keyboard alone, and an old error goes") {
  const BallWindow window("house.poff");
  static_cast<void>(window.screen.settled());
  const auto ask = [&] {
    window.press("ctrl+o");
    // The dialog dims what is below it.
    REQUIRE(eventually([&] { return !window.screen.shoot().is_white(500, 770 - 30); }));
    static_cast<void>(window.screen.settled());
  };
  ask();
  // Letters jump to the first file that begins with them.
  window.screen.xdotool("type sq");
  static_cast<void>(window.screen.settled());
  window.press("Return");
  CHECK(eventually([&] { return window.title().starts_with("square.poff"); }));
  static_cast<void>(window.screen.settled());
  ask();
  // config, data, then the three files; the third of them is the last.
  window.press("Up");
  static_cast<void>(window.screen.settled());
  window.press("Up");
  static_cast<void>(window.screen.settled());
  window.press("Return");
  CHECK(eventually([&] { return window.title().starts_with("house.poff"); }));
}
