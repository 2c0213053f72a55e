// SPDX-License-Identifier: GPL-3.0-or-later
// In a window of 640 x 480 pixels, where letters are to be twice as large, no control of a panel, a dialog, a menu or a
// popup is out of reach: it is in the window, or can be scrolled there. The program itself tells which parts are not
// (MESECINA_SHOWS_REACH).
#include <catch2/catch.hpp>
#include <cmath>
#include <functional>
#include <string>
#include <vector>

#include "tests/window/window_driver.h"

using namespace mes;
using namespace mes::test;

namespace {

constexpr PixelBox kSmallWindow{0, 0, 640, 480};

struct SmallWindow : DrivenProgram {
  explicit SmallWindow(const std::string& settings = {}) {
    folder.write("house.poff", kHouse);
    std::filesystem::create_directories(folder / "config" / "mesecina");
    folder.write(
        "config/mesecina/settings.json",
        R"({"schema": 1, "interface_scale": 2.0, "window_width": 640, "window_height": 480)" + settings + "}");
    start("house.poff", {{"MESECINA_SHOWS_REACH", "1"}, {"HOME", folder.path().string()}});
    static_cast<void>(screen.settled());
  }
  /// The reports of the program since the last call.
  std::string news() {
    const std::string all = bytes_of(folder / "errors");
    const std::string out = all.substr(told_);
    told_ = all.size();
    return out;
  }
  void expect_reach(const std::string& what) {
    const Screenshot shown = screen.settled();
    INFO(what);
    CHECK(news() == "");
  }
  /// Runs what the palette finds first for these letters.
  void run(const std::string& letters) {
    press("ctrl+k");
    static_cast<void>(screen.settled());
    screen.xdotool("type --delay 20 '" + letters + "'");
    static_cast<void>(screen.settled());
    press("Return");
  }
  /// Shows something that is not there yet, and closes it.
  void expect_reach_of(const std::string& what, const std::function<void()>& open) {
    const Screenshot before = screen.settled();
    open();
    INFO(what);
    REQUIRE(eventually([&] { return screen.settled().changes(kSmallWindow, before) > 5'000; }));
    CHECK(news() == "");
    press("Escape");
    CHECK(eventually([&] { return screen.settled().changes(kSmallWindow, before) < 5'000; }));
  }

 private:
  std::size_t told_ = 0;
};

}  // namespace

TEST_CASE("every dialog fits a small window with large letters") {
  SmallWindow window;
  window.expect_reach("the window");
  for (const char* keys : {"ctrl+k", "F1", "shift+F1", "ctrl+e", "ctrl+o", "ctrl+shift+s"})
    window.expect_reach_of(keys, [&] { window.press(keys); });
  for (const char* name : {"Make a shape", "Write a text"}) window.expect_reach_of(name, [&] { window.run(name); });
  std::string disk = "P5 200 200 255\n";
  for (int y = 0; y < 200; ++y)
    for (int x = 0; x < 200; ++x) disk += static_cast<char>(std::hypot(x - 99.5, y - 99.5) <= 80.0 ? 20 : 240);
  window.folder.write("disk.pgm", disk);
  window.expect_reach_of("a picture to trace", [&] {
    window.run("Trace a picture");
    static_cast<void>(window.screen.settled());
    window.screen.xdotool("type --delay 20 disk.pgm");
    static_cast<void>(window.screen.settled());
    window.press("Return");
  });
  window.press("ctrl+a Delete");
  window.expect_reach_of("unsaved work", [&] { window.press("ctrl+n"); });
}

TEST_CASE("menus and panels are reached in a small window with large letters") {
  SmallWindow window;
  for (const int x : {29, 79, 130, 202, 277, 337, 409})
    window.expect_reach_of("the menu at " + std::to_string(x), [&] { window.screen.click({x, 15}); });
  // The rail, from top to bottom in both columns; the panel of layers is open.
  for (const int x : {568, 613})
    for (const int y : {100, 155, 200}) {
      window.screen.click({x, y});
      window.expect_reach("the panel at " + std::to_string(x) + ", " + std::to_string(y));
    }
  for (const int y : {245, 300, 345, 390}) {
    window.screen.click({568, y});
    window.expect_reach("the panel at 568, " + std::to_string(y));
  }
}

TEST_CASE("in a small window the interface is smaller than it is to be, and panels lie over the drawing") {
  SmallWindow window;
  window.screen.click({516, 54});  // closes the panel of layers
  const Screenshot alone = window.screen.settled();
  const auto is_ink = [](Color c) { return c.r < 60 && c.g < 60 && c.b < 60; };
  constexpr PixelBox kDrawing{116, 34, 160, 440};
  window.press("l");
  const Screenshot beside = window.screen.settled();
  // The rail begins at 543 pixels with letters a quarter larger, and at 440 with those of twice the size.
  CHECK(alone.changes({543, 34, 640, 440}, beside) < 5'000);
  CHECK(alone.changes({200, 34, 540, 440}, beside) > 5'000);
  CHECK(alone.changes(kDrawing, beside) == 0);
  CHECK(alone.box_of({116, 34, 540, 440}, is_ink).right > 300);
}
