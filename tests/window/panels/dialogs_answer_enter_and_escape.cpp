// SPDX-License-Identifier: GPL-3.0-or-later
#include <catch2/catch.hpp>

#include "tests/window/window_driver.h"

using namespace mes;
using namespace mes::test;

namespace {

struct AskedWindow : DrivenProgram {
  AskedWindow() {
    folder.write("house.poff", kHouse);
    start("house.poff");
    static_cast<void>(drawn());
    press("ctrl+a Delete");
    REQUIRE(eventually([&] { return title().starts_with("* house.poff"); }));
  }
  /// Asks for a new document, and waits for the question.
  Screenshot ask() const {
    const Screenshot before = screen.settled();
    press("ctrl+n");
    REQUIRE(eventually([&] { return screen.shoot().changes(kCanvas, before) > 10'000; }));
    return screen.settled();
  }
};

}  // namespace

TEST_CASE("Enter gives the answer that stands out, another one after an arrow key, and Esc none") {
  const AskedWindow window;
  const std::string saved = bytes_of(window.folder / "house.poff");
  const auto is_accent = [](Color c) { return c.r < 30 && c.b > 140 && c.b < 175; };
  CHECK_FALSE(window.ask().box_of(kCanvas, is_accent).is_empty());
  window.press("Escape");
  static_cast<void>(window.screen.settled());
  CHECK(window.title().starts_with("* house.poff"));
  CHECK(bytes_of(window.folder / "house.poff") == saved);
  static_cast<void>(window.ask());
  window.press("Right");
  window.press("Return");  // "Don't save"
  CHECK(eventually([&] { return window.title().starts_with("Untitled"); }));
  CHECK(bytes_of(window.folder / "house.poff") == saved);
}

TEST_CASE("Enter saves what would be lost") {
  const AskedWindow window;
  const std::string saved = bytes_of(window.folder / "house.poff");
  static_cast<void>(window.ask());
  window.press("Return");
  CHECK(eventually([&] { return window.title().starts_with("Untitled"); }));
  CHECK(bytes_of(window.folder / "house.poff") != saved);
}

TEST_CASE("menus answer arrow keys and Enter") {
  const AskedWindow window;
  const Screenshot closed = window.screen.settled();
  window.screen.click({61, 13});
  REQUIRE(eventually([&] { return window.screen.shoot().changes({0, 24, 1280, 780}, closed) > 3'000; }));
  static_cast<void>(window.screen.settled());
  // The first key marks the first row of the menu Edit, which is Undo.
  window.press("Down");
  static_cast<void>(window.screen.settled());
  window.press("Return");
  CHECK(eventually([&] { return window.title().starts_with("house.poff"); }));
}
