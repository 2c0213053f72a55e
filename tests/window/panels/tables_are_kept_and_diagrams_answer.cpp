// SPDX-License-Identifier: GPL-3.0-or-later
// Pages of numbers, by hand: what they ask, say and keep.
#include <fmt/core.h>
#include <array>
#include <catch2/catch.hpp>
#include <cstdlib>
#include <string>

#include "tests/window/window_driver.h"

using namespace mes;
using namespace mes::test;

namespace {

constexpr PixelBox kPanel{939, 25, 1238, 770};
constexpr PixelBox kRemark{0, 773, 500, 800};
// On a page that has the panel for itself.
constexpr std::array<int, 2> kSearch{1048, 72};
constexpr std::array<int, 2> kRun{1192, 101};             // of the one parameter that is found
constexpr std::array<int, 2> kParameterField{1188, 129};  // the field beside its slider
constexpr std::array<int, 2> kSteps{1040, 203};           // in the popup of the button
constexpr std::array<int, 2> kMakeTable{1075, 290};
constexpr std::array<int, 2> kPlay{405, 745};  // of the strip of evolutions, in one row

/// Samples, and a page in a panel of its own.
struct Page {
  DrivenProgram window;

  explicit Page(const std::string& key, const std::string& samples = "POFF 3 0 0\n0 0\n4 0\n0 3\n") {
    window.folder.write("samples.poff", samples);
    window.start("samples.poff");
    static_cast<void>(window.drawn());
    window.press("l");
    window.press("shift+l");
    window.press(key);
    static_cast<void>(window.screen.settled());
  }
  const VirtualScreen& screen() const { return window.screen; }
  Screenshot at_rest() const {
    screen().xdotool("mousemove 1200 6");
    return screen().settled();
  }
  void find_parameter(const std::string& words) const {
    screen().click(kSearch);
    static_cast<void>(screen().settled());
    screen().type_over(words);
    static_cast<void>(screen().settled());
  }
  void open_table(const std::string& steps) const {
    screen().click(kRun);
    static_cast<void>(screen().settled());
    screen().click(kSteps);
    static_cast<void>(screen().settled());
    screen().type_over(steps);
    window.press("Return");
    static_cast<void>(screen().settled());
  }
  /// What lies behind a dialog is dimmed, as the empty end of the page.
  bool is_asking() const { return screen().shoot().at(1200, 700).g < 220; }
  void answer(const std::string& file) const {
    screen().type_over(file);
    window.press("Return");
    static_cast<void>(screen().settled());
  }
};

}  // namespace

TEST_CASE("a table that cannot be written is not lost: another file is asked for") {
  const Page page("p");
  page.find_parameter("alpha complex: radius");
  page.open_table("4");
  REQUIRE_FALSE(page.is_asking());
  page.screen().click(kMakeTable);
  REQUIRE(eventually([&] { return page.is_asking(); }));
  static_cast<void>(page.screen().settled());
  page.answer("/proc/table.csv");
  REQUIRE(page.is_asking());
  const auto file = page.window.folder / "table.csv";
  page.answer(file.string());
  CHECK(eventually([&] { return !page.is_asking(); }));
  const std::string text = bytes_of(file);
  CHECK(text.starts_with("alpha-radius,"));
  std::size_t lines = 0;
  for (const char c : text) lines += c == '\n' ? 1U : 0U;
  CHECK(lines == 6);
  static_cast<void>(page.screen().settled());
  CHECK_FALSE(page.is_asking());
}

TEST_CASE("a table that is made while something else is asked waits for its turn") {
  const Page page("p");
  page.find_parameter("alpha complex: radius");
  page.open_table("20000");
  page.screen().xdotool("mousemove 1075 290 click 1 key Escape key ctrl+shift+s");
  REQUIRE(eventually([&] { return page.is_asking(); }));
  // At rest the table is there.
  static_cast<void>(page.screen().settled());
  const auto session = page.window.folder / "kept.json";
  page.screen().type_over(session.string());
  page.window.press("Return");
  REQUIRE(eventually([&] { return page.window.title().starts_with("kept.json"); }));
  CHECK(bytes_of(session).starts_with("{"));
  REQUIRE(eventually([&] { return page.is_asking(); }));
  static_cast<void>(page.screen().settled());
  const auto file = page.window.folder / "table.csv";
  page.answer(file.string());
  CHECK(bytes_of(file).starts_with("alpha-radius,"));
}

TEST_CASE("a number that is typed out of range is brought within it, and that is said") {
  const Page page("p");
  page.find_parameter("scale axis: factor");
  const auto type = [&](const std::string& number) {
    page.screen().click(kParameterField);
    static_cast<void>(page.screen().settled());
    page.screen().type_over(number);
    page.window.press("Return");
    return page.at_rest();
  };
  const Screenshot largest = type("3");
  const Screenshot beyond = type("99");
  CHECK(beyond.changes(kPanel, largest) == 0);
  CHECK(beyond.changes(kRemark, largest) > 100);
  CHECK(type("98").changes(kRemark, beyond) > 5);
}

TEST_CASE("what plays is stopped where the computation is cancelled, also between two pictures") {
  const Page page("e");
  page.screen().xdotool("mousemove 1200 6");
  const Screenshot before = page.screen().settled();
  page.window.press("bracketright");
  static_cast<void>(page.window.other_than(before));
  page.screen().click(kPlay);
  page.window.press("ctrl+period");
  // What plays does not rest.
  const Screenshot stopped = page.at_rest();
  CHECK(page.screen().settled().changes(kCanvas, stopped) == 0);
}

TEST_CASE("where an evolution can go no further, that is said at once") {
  const Page page("e");
  page.screen().xdotool("key ctrl+k");
  static_cast<void>(page.screen().settled());
  page.screen().type_over("balls along the axis: grow");
  static_cast<void>(page.screen().settled());
  page.window.press("Return");
  const Screenshot before = page.at_rest();
  // With a step of 3 % the factor is 3 after 66 of them.
  page.screen().xdotool("key --repeat 60 --delay 15 bracketright");
  static_cast<void>(page.screen().settled());
  page.screen().click(kPlay);
  // No event comes meanwhile, not even the question whether all is at rest. The drawing fills the top of the canvas.
  constexpr PixelBox kNote{66, 686, 394, 716};
  CHECK(eventually([&] { return page.screen().shoot().changes(kNote, before) > 500; }));
}

TEST_CASE("how much of the shape is kept can be measured") {
  const Page page("shift+b");
  const Screenshot before = page.at_rest();
  page.screen().click({959, 101});
  const Screenshot after = page.at_rest();
  // The box, and the words about what is kept.
  CHECK(after.changes({943, 92, 973, 110}, before) > 20);
  CHECK(after.changes({943, 114, 1238, 770}, before) > 20);
}

TEST_CASE("dragging the limit of lambda shows the axis that it limits") {
  const Page page("shift+b", output_of(std::string(MESECINA_BINARY) + " shape gear --samples 300"));
  const Screenshot before = page.at_rest();
  // A press in the histogram sets the limit to a third of the greatest lambda.
  page.screen().click({1050, 280});
  const Screenshot after = page.at_rest();
  CHECK(after.changes(kCanvas, before) > 300);  // the limited axis has colours of its own
  page.window.press("ctrl+z");
  CHECK(page.at_rest().changes(kCanvas, before) == 0);
}

TEST_CASE("the words about the limit of lambda stand above the bars") {
  const Page page("shift+b", output_of(std::string(MESECINA_BINARY) + " shape gear --samples 300"));
  const Screenshot shot = page.at_rest();
  const PixelBox bars =
      shot.box_of({943, 140, 1238, 480}, [](Color c) { return c.r > 200 && c.g > 80 && c.g < 140 && c.b < 60; });
  REQUIRE(bars.right - bars.left > 100);
  REQUIRE(bars.bottom - bars.top > 40);
  const auto ink = [&](int top, int bottom) {
    int out = 0;
    for (int y = top; y < bottom; ++y)
      for (int x = bars.left + 6; x < bars.left + 60; ++x) out += shot.is_dark(x, y) ? 1 : 0;
    return out;
  };
  CHECK(ink(bars.top, bars.top + 18) == 0);
  CHECK(ink(bars.top - 20, bars.top) > 20);
}

TEST_CASE("the chosen row of the table of branches looks like no other, with the pointer on it or away") {
  const Page page("shift+b", output_of(std::string(MESECINA_BINARY) + " shape gear --samples 300"));
  constexpr int kRow = 19;
  constexpr int kBesideText = 1043;
  const auto expect_unlike_others = [&](int y) {
    const Screenshot now = page.screen().settled();
    const Color here = now.at(kBesideText, y);
    for (const int rows : {-2, -1, 1, 2}) {
      const Color there = now.at(kBesideText, y + rows * kRow);
      INFO(rows << " rows further down");
      CHECK(std::abs(here.r - there.r) + std::abs(here.g - there.g) + std::abs(here.b - there.b) > 15);
    }
  };
  // Every other row has a ground of its own.
  for (const int y : {540, 540 + kRow}) {
    page.screen().click({kBesideText, y});
    expect_unlike_others(y);
    page.screen().xdotool("mousemove 1200 6");
    expect_unlike_others(y);
  }
}

TEST_CASE("arrow keys go from row to row of the table of branches, and move no samples") {
  const Page page("shift+b", output_of(std::string(MESECINA_BINARY) + " shape gear --samples 300"));
  page.window.press("ctrl+a");
  page.screen().click({1043, 540});
  const Screenshot first = page.screen().settled();
  page.window.press("Down");
  // Another branch is marked on the canvas.
  REQUIRE(eventually([&] { return page.screen().settled().changes(kCanvas, first) > 20; }));
  const Screenshot second = page.screen().settled();
  page.window.press("Down");
  REQUIRE(eventually([&] { return page.screen().settled().changes(kCanvas, second) > 20; }));
  page.window.press("Up");
  page.window.press("Up");
  CHECK(eventually([&] { return page.screen().settled().changes(kCanvas, first) == 0; }));
  CHECK(page.window.title().starts_with("samples.poff"));
}

TEST_CASE("the component that stays is on a line of its own above the others") {
  const Page page("shift+g");
  const Screenshot shot = page.at_rest();
  const auto is_dot = [](Color c) { return c.r < 70 && std::abs(c.g - 0x9E) < 30 && std::abs(c.b - 0x80) < 30; };
  const PixelBox dots = shot.box_of(kPanel, is_dot);
  REQUIRE(dots.bottom - dots.top > 40);
  // One row of pixels of the dot goes on as a line.
  const auto is_line = [&](int y) {
    for (int x = dots.right + 4; x < dots.right + 100; ++x)
      if (shot.at(x, y).r > 215) return false;
    return true;
  };
  int lines = 0;
  for (int y = dots.top; y < dots.top + 6; ++y) lines += is_line(y) ? 1 : 0;
  CHECK(lines > 0);
  // Deaths at 1.5 and 2 are below it, the second at 20/21 of the axis.
  const PixelBox others = shot.box_of({dots.left, dots.top + 8, dots.right, dots.bottom}, is_dot);
  CHECK(others.top - dots.top > 16);
}

TEST_CASE("a click on a sample chooses its component, and the diagram stays where it is") {
  const Page page("shift+g");
  const Screenshot before = page.at_rest();
  const auto is_dark = [](Color c) { return c.r < 40 && c.g < 40 && c.b < 40; };
  const PixelBox corner = before.box_of({80, 650, 200, 760}, is_dark);  // the sample at the lower left
  REQUIRE_FALSE(corner.is_empty());
  page.screen().click(corner.middle());
  const Screenshot after = page.at_rest();
  // A ring around its point, and words below; not the diagonal.
  CHECK(after.changes({960, 140, 990, 400}, before) > 20);
  CHECK(after.changes({940, 425, 1238, 470}, before) > 100);
  CHECK(after.changes({1010, 190, 1210, 360}, before) == 0);
}

TEST_CASE("arrow keys go from pair to pair of the persistence diagram, the longest first") {
  const Page page("shift+g");
  page.window.press("ctrl+a");
  page.screen().click({1043, 650});
  const Screenshot none = page.screen().settled();
  page.window.press("Down");
  REQUIRE(eventually([&] { return page.screen().settled().changes(kCanvas, none) > 20; }));
  const Screenshot first = page.screen().settled();
  page.window.press("Down");
  REQUIRE(eventually([&] { return page.screen().settled().changes(kCanvas, first) > 20; }));
  page.window.press("Up");
  CHECK(eventually([&] { return page.screen().settled().changes(kCanvas, first) == 0; }));
  // There is none before the first.
  page.window.press("Up");
  CHECK(page.screen().settled().changes(kCanvas, first) == 0);
  CHECK(page.window.title().starts_with("samples.poff"));
}

TEST_CASE("a large diagram opens where it hides the least, and comes back to where it was put") {
  // The outline of the letter L leaves the upper right corner free.
  std::string samples = "POFF 144 0 0\n";
  const auto go = [&samples](std::array<double, 2> from, std::array<double, 2> to) {
    constexpr int kSteps = 24;
    for (int i = 0; i < kSteps; ++i)
      samples +=
          fmt::format("{} {}\n", from[0] + (to[0] - from[0]) * i / kSteps, from[1] + (to[1] - from[1]) * i / kSteps);
  };
  go({0, 0}, {8, 0});
  go({8, 0}, {8, 0.5});
  go({8, 0.5}, {0.5, 0.5});
  go({0.5, 0.5}, {0.5, 6});
  go({0.5, 6}, {0, 6});
  go({0, 6}, {0, 0});
  const Page page("shift+g", samples);
  constexpr std::array<int, 2> kLarge{1165, 43};
  constexpr std::array<int, 2> kInTitle{700, 45};  // of the window in the upper right corner of the canvas
  const Screenshot before = page.at_rest();
  const auto window_of = [&] {
    page.screen().click(kLarge);
    return page.at_rest().box_of_changes(kCanvas, before);
  };
  const PixelBox first = window_of();
  REQUIRE(first.right - first.left > 300);
  CHECK(first.left > 350);
  CHECK(first.bottom < 560);
  page.screen().drag(kInTitle, {kInTitle[0] - 100, kInTitle[1] + 150}, 8);
  page.screen().xdotool("mouseup 1");
  const PixelBox moved = page.at_rest().box_of_changes(kCanvas, before);
  CHECK(std::abs(moved.left - (first.left - 100)) < 4);
  page.window.press("Escape");
  REQUIRE(eventually([&] { return page.at_rest().changes(kCanvas, before) == 0; }));
  const PixelBox again = window_of();
  CHECK(again.left == moved.left);
  CHECK(again.top == moved.top);
  CHECK(again.right == moved.right);
}
