// SPDX-License-Identifier: GPL-3.0-or-later
// A tiling window manager gives a window less room than it asked for, down to a pixel: nothing ends, and with the room
// everything is back.
#include <catch2/catch.hpp>
#include <string>

#include "tests/window/window_driver.h"

using namespace mes;
using namespace mes::test;

TEST_CASE("a window without room for its panels lives, and shows them again when it has it") {
  DrivenProgram window;
  window.folder.write("frame.poff", "POFF 8 0 0\n0 0\n2 0\n4 0\n4 2\n4 4\n2 4\n0 4\n0 2\n");
  window.start("frame.poff");
  const VirtualScreen& screen = window.screen;
  const std::string id = output_of("DISPLAY=" + screen.display() + " xdotool search --name frame.poff");
  const auto resize = [&](const std::string& size) {
    screen.xdotool("windowsize " + id.substr(0, id.find('\n')) + ' ' + size);
    static_cast<void>(screen.settled());
  };
  // Pages with bands, tables and diagrams, the palette, and panes beside the main one.
  for (const char* keys : {"t", "p", "n", "shift+b", "shift+g", "ctrl+k", "F6"}) {
    INFO("after " << keys);
    window.press(keys);
    const Screenshot before = window.drawn();
    for (const char* size : {"1 1", "1 800", "1280 1", "40 700", "1280 40", "300 200"}) {
      INFO("window of " << size << " pixels");
      resize(size);
      REQUIRE(window.program.is_running());
    }
    resize("1280 800");
    REQUIRE(window.program.is_running());
    CHECK(window.nearly_shows(before));
    if (keys == std::string("ctrl+k")) window.press("Escape");
  }
}

TEST_CASE("a narrow window with large letters shows the whole light, without its epsilon") {
  DrivenProgram window;
  window.folder.write("house.poff", kHouse);
  std::filesystem::create_directories(window.folder / "config" / "mesecina");
  window.folder.write("config/mesecina/settings.json",
                      R"({"schema": 1, "interface_scale": 2.0, "window_width": 640, "window_height": 480})");
  window.start("house.poff");
  const auto is_light = [](Color c) { return c.r < 40 && c.g > 130 && c.b < 140; };
  const auto width_of_light = [&] {
    const PixelBox light = window.screen.settled().box_of({0, 425, 640, 480}, is_light);
    return light.right - light.left;
  };
  CHECK(eventually([&] { return width_of_light() >= 11; }));
}
