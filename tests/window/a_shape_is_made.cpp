// SPDX-License-Identifier: GPL-3.0-or-later
// The dialogs of shapes and of texts, by the command palette and with keys alone.
#include <catch2/catch.hpp>
#include <cmath>

#include "core/io/format.h"
#include "tests/window/window_driver.h"

using namespace mes;
using namespace mes::test;

namespace {

/// Both dialogs dim what is below them.
bool is_dimmed(const VirtualScreen& screen) {
  return !screen.shoot().is_white(90, 700);
}

void open_dialog(const DrivenProgram& window, const Screenshot& before, const std::string& action) {
  const VirtualScreen& screen = window.screen;
  window.press("ctrl+shift+p");
  REQUIRE(eventually([&] { return screen.shoot().differences(before, 0) > 1000; }));
  static_cast<void>(screen.settled());
  screen.xdotool("type --delay 20 " + action);
  static_cast<void>(screen.settled());
  window.press("Return");
  REQUIRE(eventually([&] { return is_dimmed(screen); }));
  static_cast<void>(screen.settled());
}

}  // namespace

TEST_CASE("a shape is made as a document of its own, and Esc makes none") {
  DrivenProgram window;
  const VirtualScreen& screen = window.screen;
  window.folder.write("house.poff", "POFF 5 0 0\n0 0\n4 0\n4 3\n2 5\n0 3\n");
  window.start("house.poff");
  const Screenshot house = window.drawn();
  REQUIRE_FALSE(is_dimmed(screen));
  open_dialog(window, house, "make-shape");
  window.press("Escape");
  CHECK(window.shows(house));
  open_dialog(window, house, "make-shape");
  window.press("Return");
  REQUIRE(eventually([&] { return !is_dimmed(screen); }));
  const Screenshot circle = window.drawn();
  REQUIRE(circle.changes(kCanvas, house) > 1000);
  CHECK(window.title().starts_with("* Circle"));
  window.press("ctrl+z");
  CHECK(window.nearly_shows(circle));
  // No file holds it: a name is asked for, and the file that was open is left alone.
  window.press("ctrl+s");
  REQUIRE(eventually([&] { return is_dimmed(screen); }));
  window.press("Escape");
  REQUIRE(eventually([&] { return !is_dimmed(screen); }));
  CHECK(bytes_of(window.folder / "house.poff") == "POFF 5 0 0\n0 0\n4 0\n4 3\n2 5\n0 3\n");
  window.save_as("circle.poff");
  const auto file = read_sample_file(window.folder / "circle.poff");
  REQUIRE(file.has_value());
  REQUIRE(file->data.positions.size() == 400);
  for (const Vec2 p : file->data.positions) CHECK(std::abs(length(p) - 1.0) < 1e-14);
}

TEST_CASE("arrow keys choose a shape") {
  DrivenProgram window;
  window.folder.write("house.poff", "POFF 5 0 0\n0 0\n4 0\n4 3\n2 5\n0 3\n");
  window.start("house.poff");
  open_dialog(window, window.drawn(), "make-shape");
  window.press("Down");
  static_cast<void>(window.screen.settled());
  window.press("Return");
  REQUIRE(eventually([&] { return !is_dimmed(window.screen); }));
  static_cast<void>(window.drawn());
  CHECK(window.title().starts_with("* "));
  CHECK_FALSE(window.title().starts_with("* Circle"));
}

TEST_CASE("what a parameter of a shape may be is typed, also where its slider ends before") {
  constexpr std::array<int, 2> kRadius{601, 167};
  DrivenProgram window;
  window.folder.write("house.poff", "POFF 5 0 0\n0 0\n4 0\n4 3\n2 5\n0 3\n");
  window.start("house.poff");
  open_dialog(window, window.drawn(), "make-shape");
  window.screen.click(kRadius);
  static_cast<void>(window.screen.settled());
  window.screen.type_over("50");
  window.press("Return");
  static_cast<void>(window.screen.settled());
  window.press("Return");
  REQUIRE(eventually([&] { return !is_dimmed(window.screen); }));
  static_cast<void>(window.drawn());
  window.save_as("circle.poff");
  const auto file = read_sample_file(window.folder / "circle.poff");
  REQUIRE(file.has_value());
  REQUIRE_FALSE(file->data.positions.empty());
  for (const Vec2 p : file->data.positions) CHECK(length(p) == Approx(50.0));
}

TEST_CASE("a parameter of a shape is typed as an expression, and one that has no value or cannot be is refused") {
  const char* const wrong = GENERATE("1/0", "-1");
  constexpr std::array<int, 2> kRadius{601, 167};
  DrivenProgram window;
  window.folder.write("house.poff", "POFF 5 0 0\n0 0\n4 0\n4 3\n2 5\n0 3\n");
  window.start("house.poff");
  open_dialog(window, window.drawn(), "make-shape");
  window.screen.click(kRadius);
  static_cast<void>(window.screen.settled());
  window.screen.type_over(wrong);
  window.press("Return");
  static_cast<void>(window.screen.settled());
  // The field has the keyboard: Enter makes nothing.
  window.press("Return");
  static_cast<void>(window.screen.settled());
  CHECK(is_dimmed(window.screen));
  window.screen.type_over("sqrt(2)/2");
  window.press("Return");
  static_cast<void>(window.screen.settled());
  window.press("Return");
  REQUIRE(eventually([&] { return !is_dimmed(window.screen); }));
  static_cast<void>(window.drawn());
  window.save_as("circle.poff");
  const auto file = read_sample_file(window.folder / "circle.poff");
  REQUIRE(file.has_value());
  REQUIRE_FALSE(file->data.positions.empty());
  for (const Vec2 p : file->data.positions) CHECK(length(p) == Approx(std::sqrt(0.5)));
}

TEST_CASE("a text is written as a document of its own") {
  DrivenProgram window;
  const VirtualScreen& screen = window.screen;
  window.folder.write("house.poff", "POFF 5 0 0\n0 0\n4 0\n4 3\n2 5\n0 3\n");
  window.start("house.poff");
  const Screenshot house = window.drawn();
  open_dialog(window, house, "write-text");
  window.press("Return");
  REQUIRE(eventually([&] { return !is_dimmed(screen); }));
  const Screenshot text = window.drawn();
  REQUIRE(text.changes(kCanvas, house) > 1000);
  window.save_as("text.poff");
  const auto file = read_sample_file(window.folder / "text.poff");
  REQUIRE(file.has_value());
  // Mesecina, in the font of the program: four of its letters have a second contour.
  CHECK(file->data.contours.size() == 12);
  CHECK(bytes_of(window.folder / "house.poff") == "POFF 5 0 0\n0 0\n4 0\n4 3\n2 5\n0 3\n");
}
