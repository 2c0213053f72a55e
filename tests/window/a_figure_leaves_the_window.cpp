// SPDX-License-Identifier: GPL-3.0-or-later
// A figure is chosen, previewed and written with keys alone.
#include <catch2/catch.hpp>
#include <filesystem>
#include <fstream>

#include "tests/io/temporary_folder.h"
#include "tests/window/window_driver.h"

using namespace mes;
using namespace mes::test;

TEST_CASE("a figure is exported beside its document, and Esc leaves without one") {
  const TemporaryFolder folder;
  const VirtualScreen screen;
  std::ofstream(folder / "house.poff") << "POFF 5 0 0\n0 0\n4 0\n4 3\n2 5\n0 3\n";
  const Child program({MESECINA_BINARY, (folder / "house.poff").string()},
                      {{"DISPLAY", screen.display()},
                       {"WAYLAND_DISPLAY", ""},
                       {"XDG_CONFIG_HOME", (folder / "config").string()},
                       {"XDG_DATA_HOME", (folder / "data").string()},
                       {"LIBGL_ALWAYS_SOFTWARE", "1"},
                       {"ASAN_OPTIONS", "detect_leaks=0"}},
                      folder / "errors");
  const auto press = [&](const std::string& key) { screen.xdotool("key " + key); };
  REQUIRE(
      eventually([&] { return screen.xdotool("search --name Mesecina getwindowname").starts_with("house.poff"); }));
  screen.xdotool("mousemove 1200 6");
  const Screenshot before = screen.settled();
  // What lies behind a dialog is dimmed.
  const auto is_dimmed = [&] { return !screen.shoot().is_white(90, 700); };
  REQUIRE(before.is_white(90, 700));

  press("ctrl+e");
  REQUIRE(eventually(is_dimmed));
  press("Escape");
  REQUIRE(eventually([&] { return !is_dimmed(); }));
  CHECK_FALSE(std::filesystem::exists(folder / "house.pdf"));

  press("ctrl+e");
  REQUIRE(eventually(is_dimmed));
  // The page of the preview is white, and what lies around it is not.
  REQUIRE(eventually([&] {
    const Screenshot shot = screen.shoot();
    return shot.is_white(575, 190) && !shot.is_white(552, 190);
  }));
  static_cast<void>(screen.settled());
  press("Return");
  static_cast<void>(screen.settled());
  press("Return");
  CHECK(eventually([&] { return bytes_of(folder / "house.pdf").starts_with("%PDF-1.5"); }));
  CHECK(eventually([&] { return !is_dimmed(); }));
  CHECK(output_of("pdfinfo '" + (folder / "house.pdf").string() + "'").find("Page size:") != std::string::npos);
}
