// SPDX-License-Identifier: GPL-3.0-or-later
#include <catch2/catch.hpp>

#include "core/io/format.h"
#include "tests/window/window_driver.h"

using namespace mes;
using namespace mes::test;

namespace {

struct TypedWindow : DrivenProgram {
  TypedWindow() {
    folder.write("square.poff", "POFF 4 0 0\n0 0\n4 0\n4 4\n0 4\n");
    start("square.poff");
    static_cast<void>(drawn());
  }
  /// The samples of the file once it is saved.
  std::vector<Vec2> saved() const {
    REQUIRE(eventually([&] { return title().starts_with("* "); }));
    press("ctrl+s");
    REQUIRE(eventually([&] { return title().starts_with("square.poff"); }));
    const auto read = read_sample_file(folder / "square.poff");
    REQUIRE(read);
    return read->data.positions;
  }
};

constexpr std::array<int, 2> kMiddleX{1067, 467};  // the field, in the panel at the lower right

}  // namespace

TEST_CASE("the middle of what is selected is typed as an expression, and taken back as one step") {
  const TypedWindow window;
  window.press("n");
  window.press("ctrl+a");
  static_cast<void>(window.screen.settled());
  window.screen.click(kMiddleX);
  static_cast<void>(window.screen.settled());
  window.screen.type_over("2 + 1/4");
  window.press("Return");
  CHECK(window.saved() == std::vector<Vec2>{{0.25, 0}, {4.25, 0}, {4.25, 4}, {0.25, 4}});
  window.screen.xdotool("mousemove 500 400");
  static_cast<void>(window.screen.settled());
  window.press("ctrl+z");
  CHECK(window.saved() == std::vector<Vec2>{{0, 0}, {4, 0}, {4, 4}, {0, 4}});
}

TEST_CASE("a refused number keeps the keyboard and what was typed, until it is corrected or given up") {
  const TypedWindow window;
  window.press("n");
  window.press("ctrl+a");
  static_cast<void>(window.screen.settled());
  window.screen.click(kMiddleX);
  constexpr PixelBox kNote{240, 28, 800, 66};
  const Screenshot before = window.screen.settled();
  window.screen.type_over("1 + ");
  window.press("Return");
  CHECK(window.screen.settled().changes(kNote, before) > 20);
  SECTION("corrected") {
    window.press("End");
    window.screen.xdotool("type --delay 20 '1/4'");
    static_cast<void>(window.screen.settled());
    window.press("Return");
    CHECK(window.saved() == std::vector<Vec2>{{-0.75, 0}, {3.25, 0}, {3.25, 4}, {-0.75, 4}});
  }
  SECTION("given up") {
    window.press("Escape");
    // What was refused is not said any more.
    CHECK(window.screen.settled().changes(kNote, before) == 0);
    CHECK_FALSE(window.title().starts_with("* "));
    // Keys mean the drawing again, and everything is still selected.
    window.press("ctrl+d");
    CHECK(window.saved().size() == 8);
  }
}

TEST_CASE("a number with more digits than its field has room for shows its exponent") {
  DrivenProgram window;
  window.folder.write("three.poff", "POFF 3 0 0\n1.2345678901234567e-5 0\n1.2345678901234567 0\n0.6 0.9\n");
  window.start("three.poff");
  static_cast<void>(window.drawn());
  window.press("n");
  const auto is_black = [](Color c) { return c.r < 40 && c.g < 40 && c.b < 40; };
  const PixelBox samples = window.screen.settled().box_of(kCanvas, is_black);
  REQUIRE_FALSE(samples.is_empty());
  window.screen.click({samples.left + 3, samples.bottom - 4});
  const Screenshot small = window.screen.settled();
  window.screen.click({samples.right - 4, samples.bottom - 4});
  constexpr PixelBox kFieldX{1024, 459, 1112, 476};
  CHECK(window.screen.settled().changes(kFieldX, small) > 20);
}

TEST_CASE("a key whose action is not possible says why in the status bar") {
  constexpr PixelBox kRemark{0, 774, 600, 800};
  const TypedWindow window;
  for (const char* key : {"j", "Delete", "shift+Left"}) {
    const Screenshot before = window.screen.settled();
    window.press(key);
    CHECK(window.screen.settled().changes(kRemark, before) > 50);
  }
  CHECK_FALSE(window.title().starts_with("* "));
}

TEST_CASE("what is selected goes through the clipboard of the desktop") {
  const TypedWindow window;
  window.press("ctrl+a");
  static_cast<void>(window.screen.settled());
  window.press("ctrl+c");
  static_cast<void>(window.screen.settled());
  window.press("ctrl+v");
  const std::vector<Vec2> twice = window.saved();
  REQUIRE(twice.size() == 8);
  const Vec2 step = twice[4];
  CHECK(step.x > 0.0);
  CHECK(step.y == -step.x);
  for (std::size_t i = 0; i < 4; ++i) CHECK(distance(twice[4 + i], twice[i] + step) < 1e-12);
}

TEST_CASE("a double click on a sample selects its curve, a single one the sample alone") {
  const TypedWindow window;
  const auto is_black = [](Color c) { return c.r < 40 && c.g < 40 && c.b < 40; };
  const PixelBox samples = window.screen.settled().box_of(kCanvas, is_black);
  REQUIRE_FALSE(samples.is_empty());
  const std::string corner = "mousemove " + std::to_string(samples.left + 3) + ' ' + std::to_string(samples.top + 3);
  window.screen.xdotool(corner + " click 1");
  static_cast<void>(window.screen.settled());
  window.press("ctrl+d");
  CHECK(window.saved().size() == 5);
  window.press("ctrl+z");
  CHECK(window.saved().size() == 4);
  // Another sample: with the click before it, a click here could be the second one.
  const std::string other =
      "mousemove " + std::to_string(samples.right - 4) + ' ' + std::to_string(samples.bottom - 4);
  window.screen.xdotool(other + " click --repeat 2 --delay 40 1");
  static_cast<void>(window.screen.settled());
  window.press("ctrl+d");
  CHECK(window.saved().size() == 8);
}

TEST_CASE("a drawing pasted into an empty plane is a document of its own, and the open file stays as it is") {
  DrivenProgram window;
  const VirtualScreen& screen = window.screen;
  const std::string nothing = "POFF 0 0 0\n";
  window.folder.write("empty.poff", nothing);
  window.start("empty.poff");
  static_cast<void>(screen.settled());
  // The field of the palette puts the text on the clipboard.
  const auto is_dimmed = [&] { return !screen.shoot().is_white(90, 700); };
  window.press("ctrl+k");
  REQUIRE(eventually(is_dimmed));
  static_cast<void>(screen.settled());
  screen.type_over("POLYGON ((0 0, 4 0, 4 4, 0 0))");
  for (const std::string key : {"a", "c"}) {
    screen.xdotool("keydown ctrl keydown " + key);
    static_cast<void>(screen.settled());
    screen.xdotool("keyup " + key + " keyup ctrl");
  }
  REQUIRE(eventually([&] { return screen.clipboard().starts_with("POLYGON"); }));
  window.press("Escape");
  REQUIRE(eventually([&] { return !is_dimmed(); }));
  window.press("ctrl+v");
  REQUIRE(eventually([&] { return window.title().starts_with("* Clipboard"); }));
  window.press("ctrl+s");
  REQUIRE(eventually(is_dimmed));
  window.press("Escape");
  REQUIRE(eventually([&] { return !is_dimmed(); }));
  CHECK(bytes_of(window.folder / "empty.poff") == nothing);
  window.save_as("pasted.poff");
  const auto saved = read_sample_file(window.folder / "pasted.poff");
  REQUIRE(saved.has_value());
  CHECK(saved->data.contours.size() == 1);
  CHECK(bytes_of(window.folder / "empty.poff") == nothing);
}
