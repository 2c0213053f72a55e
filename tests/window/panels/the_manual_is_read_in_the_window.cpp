// SPDX-License-Identifier: GPL-3.0-or-later
// The manual opens over the window, is searched and scrolled by keys, and leaves everything as it was.
#include <catch2/catch.hpp>

#include "tests/window/window_driver.h"

using namespace mes;
using namespace mes::test;

namespace {

constexpr PixelBox kText{380, 90, 1150, 740};

struct ReadingWindow : DrivenProgram {
  ReadingWindow() {
    folder.write("house.poff", kHouse);
    start("house.poff");
  }
  Screenshot pressed(const std::string& keys) const {
    press(keys);
    return screen.settled();
  }
  Screenshot typed(const std::string& text) const {
    screen.xdotool("type --delay 20 '" + text + "'");
    return screen.settled();
  }
};

}  // namespace

TEST_CASE("a key opens the manual, words are found in it one after the other, and Esc leaves everything as it was") {
  const ReadingWindow window;
  const Screenshot before = window.drawn();
  const Screenshot open = window.pressed("shift+F1");
  CHECK(open.changes(kText, before) > 1000);
  const Screenshot first = window.typed("sampling-epsilon");
  CHECK(first.changes(kText, open) > 1000);
  const Screenshot second = window.pressed("Return");
  CHECK(second.changes(kText, first) > 100);
  CHECK(window.pressed("shift+Return").changes(kText, first) == 0);
  // Words that are not there move nothing.
  const Screenshot nothing = window.typed("no such words");
  CHECK(window.pressed("Return").changes(kText, nothing) == 0);
  window.press("Escape");
  CHECK(window.shows(before));
  window.press("shift+F1");
  static_cast<void>(window.screen.settled());
  window.press("shift+F1");
  CHECK(window.shows(before));
}

TEST_CASE("the manual is scrolled by keys, and a heading of the list and of the palette lead to the same text") {
  const ReadingWindow window;
  const Screenshot before = window.drawn();
  const Screenshot top = window.pressed("shift+F1");
  const Screenshot lower = window.pressed("Next");
  CHECK(lower.changes(kText, top) > 1000);
  CHECK(window.pressed("Prior").changes(kText, top) == 0);
  CHECK(window.pressed("Down").changes(kText, top) > 1000);
  CHECK(window.pressed("Up").changes(kText, top) == 0);
  const Screenshot end = window.pressed("End");
  CHECK(end.changes(kText, lower) > 1000);
  CHECK(window.pressed("Home").changes(kText, top) == 0);
  window.screen.click({150, 271});
  const Screenshot gestures = window.screen.settled();
  CHECK(gestures.changes(kText, top) > 1000);
  window.press("Escape");
  CHECK(window.shows(before));
  window.press("ctrl+k");
  static_cast<void>(window.typed("gestures manual"));
  CHECK(window.pressed("Return").changes(kText, gestures) == 0);
}
