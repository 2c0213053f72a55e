// SPDX-License-Identifier: GPL-3.0-or-later
// In a window of 640 x 480 pixels with letters twice as large, no control of a dialog, a menu or a popup is out of
// reach: it is in the window, or can be scrolled there. The program itself tells which parts are not
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

TEST_CASE("menus are reached in a small window with large letters") {
  // The highest one, the widest one, and the one with those that have no room in the bar.
  for (const int x : {52, 126, 559}) {
    SmallWindow window;
    const Screenshot closed = window.screen.settled();
    window.screen.click({x, 26});
    INFO("the menu at " << x);
    REQUIRE(eventually([&] { return window.screen.settled().changes(kSmallWindow, closed) > 5'000; }));
    CHECK(window.news() == "");
  }
}
