// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/core.h>
#include <catch2/catch.hpp>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <map>
#include <string>

#include "tests/io/temporary_folder.h"
#include "tests/support/effort.h"
#include "tests/window/window_driver.h"

using namespace mes;
using namespace mes::test;

namespace {

// Of the menus, in logical pixels: from the edge of a popup to the middle of its first row, and from row to row.
constexpr double kToFirstRow = 8 + 7.5;
constexpr double kRow = 21;

int scaled(double length, double scale) {
  return static_cast<int>(length * scale);
}

struct ScaledWindow {
  TemporaryFolder folder;
  VirtualScreen screen;
  Child program;
  std::map<std::string, Screenshot> seen;  // by the state of the window

  ScaledWindow() {
    const auto file = folder / "triangle.poff";
    std::ofstream(file) << "POFF 3 0 0\n0 0\n4 0\n0 3\n";
    program = Child({MESECINA_BINARY, file.string()},
                    {{"DISPLAY", screen.display()},
                     {"WAYLAND_DISPLAY", ""},
                     {"XDG_CONFIG_HOME", (folder / "config").string()},
                     {"XDG_DATA_HOME", (folder / "data").string()},
                     {"LIBGL_ALWAYS_SOFTWARE", "1"},
                     {"ASAN_OPTIONS", "detect_leaks=0"}},
                    folder / "errors");
    REQUIRE(eventually([&] { return screen.title().starts_with("triangle.poff"); }));
    rest();
  }
  /// On the empty end of the menu bar, where the pointer changes nothing.
  void rest() const { screen.xdotool("mousemove 1200 6"); }
  void press(const std::string& keys) const { screen.xdotool("key " + keys); }

  /// Toolbar and menu bar are drawn, and look as they did each time before. The chosen tool's button has this colour.
  void expect_panels(const std::string& state, double scale, Color chosen) {
    const PixelBox area{0, 0, scaled(52, scale), scaled(300, scale)};
    const auto is_drawn = [&](const Screenshot& shot) {
      const auto is_chosen = [&](Color c) { return c.r == chosen.r && c.g == chosen.g && c.b == chosen.b; };
      return shot.box_of(area, is_chosen).right > scaled(40, scale);
    };
    INFO("the panels of the state: " << state);
    const auto before = seen.find(state);
    if (before == seen.end()) {
      REQUIRE(eventually([&] { return is_drawn(screen.shoot()); }));
      seen.emplace(state, screen.settled());
      REQUIRE(is_drawn(seen.at(state)));
    } else {
      CHECK(eventually([&] { return screen.shoot().box_of_changes(area, before->second).is_empty(); }));
    }
  }

  /// Returns when the window has answered the pointer twice. After a change of scale it draws some frames until all
  /// lies in its place; two pictures in a row may look the same on a busy machine before that.
  void let_it_come_to_rest(double scale_now) const {
    const PixelBox file{0, 0, scaled(46, scale_now), scaled(22, scale_now)};
    const Screenshot before = screen.settled();
    const auto is_lit = [&] { return !screen.shoot().box_of_changes(file, before).is_empty(); };
    for (int turn = 0; turn < 2; ++turn) {
      screen.xdotool(fmt::format("mousemove {} {}", scaled(23, scale_now), scaled(12, scale_now)));
      REQUIRE(eventually(is_lit));
      rest();
      REQUIRE(eventually([&] { return !is_lit(); }));
    }
  }

  /// By the menu: "View", "Interface size" (the last row but one), and the row of the size.
  void choose_interface_size(double scale_now, int row) const {
    const PixelBox all{0, 0, 1280, 800};
    let_it_come_to_rest(scale_now);
    const Screenshot closed = screen.settled();
    screen.click({scaled(101, scale_now), scaled(12, scale_now)});
    const auto popup = [&] {
      PixelBox below_the_bar = all;
      below_the_bar.top = scaled(24, scale_now);
      return screen.shoot().box_of_changes(below_the_bar, closed);
    };
    REQUIRE(eventually([&] { return popup().bottom - popup().top > scaled(12 * kRow, scale_now); }));
    const Screenshot open = screen.settled();
    const PixelBox menu = popup();
    screen.xdotool(
        fmt::format("mousemove {} {}", menu.middle()[0], menu.bottom - scaled(kToFirstRow + kRow, scale_now)));
    const auto submenu = [&] {
      return screen.shoot().box_of_changes({menu.right + 2, 0, all.right, all.bottom}, open);
    };
    REQUIRE(eventually([&] { return submenu().bottom - submenu().top > scaled(5 * kRow, scale_now); }));
    static_cast<void>(screen.settled());
    const PixelBox sizes = submenu();
    // All before the next frame: a click counts where it happened, not where the pointer is by then.
    screen.xdotool(fmt::format("mousemove {} {} click 1 mousemove 1200 6", sizes.middle()[0],
                               sizes.top + scaled(kToFirstRow + row * kRow, scale_now)));
  }
};

}  // namespace

TEST_CASE("the panels are drawn after every change of scale and theme") {
  ScaledWindow window;
  constexpr Color kLight{0x00, 0x65, 0x9E};
  constexpr Color kDark{0x74, 0xC2, 0xF2};
  constexpr Color kProjector{0x00, 0x56, 0x8A};
  window.expect_panels("light", 1.0, kLight);
  for (std::uint64_t round = 0; round < 3 * effort(); ++round) {
    INFO("round " << round);
    window.press("shift+p");
    window.expect_panels("projector", 1.35, kProjector);
    window.press("shift+p");
    window.expect_panels("light", 1.0, kLight);
    window.press("shift+d");
    window.expect_panels("dark", 1.0, kDark);
    window.press("shift+d");
    window.expect_panels("light", 1.0, kLight);
    window.choose_interface_size(1.0, 5);
    window.expect_panels("twice as large", 2.0, kLight);
    window.choose_interface_size(2.0, 1);
    window.expect_panels("light", 1.0, kLight);
  }
  CHECK(window.program.is_running());
  CHECK(bytes_of(window.folder / "errors").empty());
}
