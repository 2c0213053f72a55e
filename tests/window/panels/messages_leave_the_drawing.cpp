// SPDX-License-Identifier: GPL-3.0-or-later
#include <catch2/catch.hpp>

#include "tests/window/window_driver.h"

using namespace mes;
using namespace mes::test;

namespace {

struct ToldWindow : DrivenProgram {
  Screenshot before;
  ToldWindow() : before(0, 0, {}) {
    folder.write("house.poff", kHouse);
    start("house.poff");
    before = drawn();
  }
  bool shows_panels() const { return screen.shoot().changes({0, 0, 60, 700}, before) == 0; }
};

constexpr PixelBox kTop{80, 26, 970, 110};  // where messages are
// The colour of problems.
const auto kIsOrange = [](Color c) { return c.r > 140 && c.g < 110 && c.b < 40; };

}  // namespace

TEST_CASE("hidden panels say how they come back, which fades, and Esc shows them again") {
  const ToldWindow window;
  window.press("Tab");
  CHECK(eventually([&] { return !window.shows_panels(); }));
  const auto is_text = [](Color c) { return c.r < 60 && c.g < 60 && c.b < 60; };
  const PixelBox top{200, 0, 1080, 50};
  CHECK(eventually([&] { return window.screen.shoot().box_of(top, is_text).right > 600; }));
  const Screenshot rested = window.screen.settled();
  const PixelBox left = rested.box_of(top, is_text);
  CHECK(left.right - left.left < 40);  // at most a sample
  window.press("Escape");
  CHECK(eventually([&] { return window.shows_panels(); }));
}

TEST_CASE("Esc closes a problem, and none is over the drawing of a presentation") {
  const ToldWindow window;
  window.press("ctrl+v");
  CHECK(eventually([&] { return !window.screen.shoot().box_of(kTop, kIsOrange).is_empty(); }));
  window.press("F5");
  const Screenshot presented = window.screen.settled();
  CHECK(presented.box_of({0, 0, 1280, 110}, kIsOrange).is_empty());
  window.press("F5");
  CHECK(eventually([&] { return !window.screen.shoot().box_of(kTop, kIsOrange).is_empty(); }));
  window.press("Escape");
  CHECK(eventually([&] { return window.screen.shoot().box_of(kTop, kIsOrange).is_empty(); }));
}

TEST_CASE("a key that cannot act shows nothing over the drawing of a presentation") {
  const ToldWindow window;
  window.press("F5");
  const Screenshot presented = window.screen.settled();
  window.press("Right");
  // Once the pointer is seen, the key was heard.
  constexpr PixelBox kPointer{30, 30, 90, 90};
  window.screen.xdotool("mousemove 60 60");
  Screenshot pointed(0, 0, {});
  REQUIRE(eventually([&] {
    pointed = window.screen.shoot();
    return pointed.changes(kPointer, presented) > 100;
  }));
  const int all = pointed.changes({0, 0, pointed.width(), pointed.height()}, presented);
  CHECK(all == pointed.changes(kPointer, presented));
}

TEST_CASE("a problem appears where the drawing leaves room, and stays there") {
  DrivenProgram window;
  std::string samples;
  for (int x = 0; x <= 40; ++x)
    for (int y = 8; y <= 36; ++y) samples += std::to_string(x) + ' ' + std::to_string(y) + '\n';
  window.folder.write("upper.txt", samples + "0 0\n");
  window.start("upper.txt");
  static_cast<void>(window.drawn());
  window.press("1");  // samples alone
  CHECK(eventually([&] { return window.screen.shoot().box_of(kTop, kIsOrange).is_empty(); }));
  window.press("ctrl+v");
  constexpr PixelBox kBottom{80, 600, 970, 780};
  CHECK(eventually([&] { return !window.screen.shoot().box_of(kBottom, kIsOrange).is_empty(); }));
  const Screenshot rested = window.screen.settled();
  CHECK(rested.box_of(kTop, kIsOrange).is_empty());
  const PixelBox there = rested.box_of(kBottom, kIsOrange);
  // The view moves, the message does not.
  window.press("minus");
  CHECK(eventually([&] { return window.screen.shoot().changes({100, 200, 900, 500}, rested) > 0; }));
  const PixelBox later = window.screen.settled().box_of(kBottom, kIsOrange);
  CHECK(later.left == there.left);
  CHECK(later.top == there.top);
}
