// SPDX-License-Identifier: GPL-3.0-or-later
#include <catch2/catch.hpp>

#include "core/io/format.h"
#include "tests/window/window_driver.h"

using namespace mes;
using namespace mes::test;

namespace {

struct EditedWindow : DrivenProgram {
  explicit EditedWindow(const std::string& samples) {
    folder.write("shape.poff", samples);
    start("shape.poff");
    static_cast<void>(drawn());
  }
  SampleData saved() const {
    static_cast<void>(screen.settled());
    REQUIRE(title().starts_with("* "));
    press("ctrl+s");
    REQUIRE(eventually([&] { return title().starts_with("shape.poff"); }));
    const auto read = read_sample_file(folder / "shape.poff");
    REQUIRE(read);
    return read->data;
  }
  void move_to(std::array<int, 2> at) const {
    screen.xdotool("mousemove " + std::to_string(at[0]) + ' ' + std::to_string(at[1]));
  }
  void drag(std::array<int, 2> from, std::array<int, 2> to) const {
    screen.drag(from, to, 4);
    screen.xdotool("mouseup 1");
  }
  /// What holds the samples on the screen.
  PixelBox samples() const {
    const auto is_black = [](Color c) { return c.r < 40 && c.g < 40 && c.b < 40; };
    return screen.settled().box_of(kCanvas, is_black);
  }
};

// With a sample in its middle.
constexpr const char* kSquare = "POFF 5 0 0\n0 0\n4 0\n4 4\n0 4\n2 2\n";
constexpr const char* kOctagon = "POFF 8 0 0\n3 0\n2 2\n0 3\n-2 2\n-3 0\n-2 -2\n0 -3\n2 -2\n";

PixelBox around(std::array<int, 2> at, int reach) {
  return {at[0] - reach, at[1] - reach, at[0] + reach, at[1] + reach};
}

}  // namespace

TEST_CASE("a sample under the pointer is marked in the middle of the canvas, too") {
  const EditedWindow window(kSquare);
  const auto middle = window.samples().middle();
  const Screenshot before = window.screen.settled();
  window.move_to({middle[0] + 2, middle[1] + 1});
  CHECK(window.screen.settled().changes(around(middle, 14), before) > 20);
}

TEST_CASE("a handle of the frame widens what is selected, and what is opposite stays") {
  const EditedWindow window(kSquare);
  const PixelBox samples = window.samples();
  window.press("ctrl+a");
  static_cast<void>(window.screen.settled());
  const int y = samples.middle()[1];
  // The frame is twelve pixels away from the samples, whose marks are some five wide.
  window.drag({samples.right + 9, y}, {samples.right + 109, y});
  const SampleData data = window.saved();
  REQUIRE(data.positions.size() == 5);
  CHECK(data.positions[0] == Vec2{0, 0});
  CHECK(data.positions[3] == Vec2{0, 4});
  CHECK(data.positions[1].x > 4.2);
  CHECK(data.positions[2] == Vec2{data.positions[1].x, 4});
  CHECK(data.positions[4].x == Approx(0.5 * data.positions[1].x));
  window.press("ctrl+z");
  CHECK(window.saved().positions[1] == Vec2{4, 0});
}

TEST_CASE("by how much a handle widens is said where no panel hides it") {
  const EditedWindow window(kSquare);
  const PixelBox samples = window.samples();
  window.press("ctrl+a");
  static_cast<void>(window.screen.settled());
  const int y = samples.middle()[1];
  window.screen.drag({samples.right + 9, y}, {1010, y}, 4);
  // Left of the panels, below the frame.
  const auto is_blue = [](Color c) { return c.b > c.r + 60; };
  const PixelBox words =
      window.screen.settled().box_of({kCanvas.right - 110, samples.bottom + 13, kCanvas.right, 768}, is_blue);
  window.screen.xdotool("mouseup 1");
  CHECK(words.right - words.left > 20);
  CHECK(words.bottom - words.top > 5);
}

TEST_CASE("contours made of the crust are cut and joined, and saved with the samples") {
  const EditedWindow window(kOctagon);
  window.press("ctrl+k");
  static_cast<void>(window.screen.settled());
  window.screen.xdotool("type 'contours along'");
  static_cast<void>(window.screen.settled());
  window.press("Return");
  const SampleData along = window.saved();
  REQUIRE(along.contours.size() == 1);
  CHECK(along.contours.front().closed);
  CHECK(along.contours.front().points.size() == 8);
  // The rightmost sample and its neighbours: the whole of the box around the right end.
  const PixelBox samples = window.samples();
  const int middle = samples.middle()[1];
  window.drag({samples.right + 20, middle - 10}, {samples.right - 20, middle + 10});
  window.press("greater");
  static_cast<void>(window.screen.settled());
  window.press("shift+j");
  const SampleData cut = window.saved();
  REQUIRE(cut.contours.size() == 1);
  CHECK_FALSE(cut.contours.front().closed);
  CHECK(cut.contours.front().points.size() == 7);
  // Its two ends are what is selected beside the sample that is free now.
  window.screen.xdotool("keydown ctrl keydown shift");
  window.screen.click({samples.right - 3, middle});
  window.screen.xdotool("keyup shift keyup ctrl");
  static_cast<void>(window.screen.settled());
  window.press("j");
  const SampleData joined = window.saved();
  REQUIRE(joined.contours.size() == 1);
  CHECK(joined.contours.front().closed);
  CHECK(joined.contours.front().points.size() == 7);
}

TEST_CASE("while Alt is held structures stay as they are, and follow when it is released") {
  const EditedWindow window(kSquare);
  const PixelBox samples = window.samples();
  window.screen.xdotool("keydown alt");
  window.drag({samples.left + 3, samples.top + 3}, {samples.left + 150, samples.top + 120});
  window.move_to({990, 780});
  const Screenshot held = window.screen.settled();
  window.screen.xdotool("keyup alt");
  const Screenshot released = window.screen.settled();
  CHECK(held.changes(kCanvas, released) > 200);
  CHECK(window.saved().positions[3].x > 0.2);
}

TEST_CASE("keys that are held count in the order of the events, however late these come") {
  const EditedWindow window(kSquare);
  const PixelBox samples = window.samples();
  window.program.pause();
  window.screen.xdotool("keydown alt");
  window.drag({samples.left + 3, samples.top + 3}, {samples.left + 150, samples.top + 120});
  window.move_to({990, 780});
  window.program.go_on();
  const Screenshot held = window.screen.settled();
  window.screen.xdotool("keyup alt");
  const Screenshot released = window.screen.settled();
  CHECK(held.changes(kCanvas, released) > 200);
  CHECK(window.saved().positions[3].x > 0.2);
  // A drag with the space bar held moves the view.
  const PixelBox before = window.samples();
  window.program.pause();
  window.screen.xdotool("keydown space");
  window.drag({samples.left + 50, samples.bottom - 50}, {samples.left + 80, samples.bottom - 50});
  window.screen.xdotool("keyup space");
  window.move_to({990, 780});
  window.program.go_on();
  CHECK(window.samples().left == before.left + 30);
}

TEST_CASE("Ctrl holds off snapping, and lets it go on, under a pointer that rests") {
  const EditedWindow window(kSquare);
  const PixelBox samples = window.samples();
  window.press("shift+s");
  window.press("b");
  const std::array<int, 2> at{samples.left + 8, samples.bottom - 8};
  window.move_to(at);
  const Screenshot snapped = window.screen.settled();
  window.screen.xdotool("keydown ctrl");
  CHECK(window.screen.settled().changes(around(at, 60), snapped) > 20);
  window.screen.xdotool("keyup ctrl");
  CHECK(window.screen.settled().changes(around(at, 60), snapped) == 0);
}
