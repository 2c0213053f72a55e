// SPDX-License-Identifier: GPL-3.0-or-later
// A drawing that takes long to paint stays in view while the next one is made, and ends as it began.
#include <fmt/core.h>
#include <catch2/catch.hpp>
#include <cmath>
#include <string>

#include "tests/window/window_driver.h"

using namespace mes;
using namespace mes::test;

namespace {

struct HeavyWindow : DrivenProgram {
  HeavyWindow() {
    constexpr int kSamples = 20000;
    std::string text = fmt::format("POFF {} 0 0\n", kSamples);
    for (int i = 0; i < kSamples; ++i) {
      const double t = 6.283185307179586 * i / kSamples;
      const double r = 1.0 + 0.3 * std::cos(5.0 * t);
      text += fmt::format("{} {}\n", r * std::cos(t), r * std::sin(t));
    }
    folder.write("flower.poff", text);
    start("flower.poff");
  }
  /// The drawing in a screenshot: what is not paper, between toolbar and panels.
  static PixelBox drawing_in(const Screenshot& shot) {
    return shot.box_of({kCanvas.left + 20, kCanvas.top, kCanvas.right, kCanvas.bottom}, is_ink);
  }
  static bool is_ink(Color c) { return c.r < 240 || c.g < 240 || c.b < 200; }
};

}  // namespace

TEST_CASE("a heavy drawing stays in view while it is panned and zoomed, and the view comes back exactly") {
  const HeavyWindow window;
  const Screenshot first = window.drawn();
  // The balls of a union: disks and circles, which are counted, and arcs, which are painted one by one.
  window.press("6");
  // While they are computed, the drawing before stays.
  Screenshot waiting = window.screen.shoot();
  for (; waiting.changes(kCanvas, first) < 1000; waiting = window.screen.shoot())
    CHECK_FALSE(HeavyWindow::drawing_in(waiting).is_empty());
  CHECK_FALSE(HeavyWindow::drawing_in(waiting).is_empty());
  const Screenshot balls = window.other_than(first);
  const PixelBox before = HeavyWindow::drawing_in(balls);
  REQUIRE_FALSE(before.is_empty());

  window.screen.xdotool("mousemove 520 400 mousedown 3");
  for (int x = 520; x <= 600; x += 20) {
    window.screen.xdotool(fmt::format("mousemove {} 400", x));
    CHECK_FALSE(HeavyWindow::drawing_in(window.screen.shoot()).is_empty());
  }
  const PixelBox beside = HeavyWindow::drawing_in(window.screen.settled());
  CHECK(std::abs(beside.left - before.left - 80) <= 1);
  for (int x = 600; x >= 520; x -= 20) window.screen.xdotool(fmt::format("mousemove {} 400", x));
  window.screen.xdotool("mouseup 3 mousemove 3 3");
  CHECK(window.shows(balls));

  window.screen.xdotool("mousemove 520 400 click --repeat 3 4");
  for (int i = 0; i < 3; ++i) CHECK_FALSE(HeavyWindow::drawing_in(window.screen.shoot()).is_empty());
  window.screen.xdotool("mousemove 3 3");
  const Screenshot magnified = window.other_than(balls);
  CHECK(magnified.changes(kCanvas, balls) > 1000);
  window.press("f");
  CHECK(window.shows(balls));

  // Another bundle in the middle of the way: its drawing is the same as without that.
  window.screen.xdotool("mousemove 520 400 click --repeat 2 4 key 4 key 6 mousemove 3 3");
  window.press("f");
  CHECK(window.shows(balls));

  // The engine hears of layers that are hidden and shown again within one computation as of no change.
  window.press("4 6 4 6 4 6");
  CHECK(window.shows(balls));
}
