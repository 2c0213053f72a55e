// SPDX-License-Identifier: GPL-3.0-or-later
// A figure is chosen, previewed and written with keys alone.
#include <catch2/catch.hpp>
#include <filesystem>
#include <fstream>

#include "tests/window/window_driver.h"

using namespace mes;
using namespace mes::test;

TEST_CASE("a figure is exported beside its document, and Esc leaves without one") {
  DrivenProgram window;
  const TemporaryFolder& folder = window.folder;
  const VirtualScreen& screen = window.screen;
  std::ofstream(folder / "house.poff") << "POFF 5 0 0\n0 0\n4 0\n4 3\n2 5\n0 3\n";
  window.start("house.poff");
  const Screenshot before = window.drawn();
  // What lies behind a dialog is dimmed.
  const auto is_dimmed = [&] { return !screen.shoot().is_white(90, 700); };
  REQUIRE(before.is_white(90, 700));

  window.press("ctrl+e");
  REQUIRE(eventually(is_dimmed));
  window.press("Escape");
  REQUIRE(eventually([&] { return !is_dimmed(); }));
  CHECK_FALSE(std::filesystem::exists(folder / "house.pdf"));

  window.press("ctrl+e");
  REQUIRE(eventually(is_dimmed));
  // The page of the preview is white, and what lies around it is not.
  REQUIRE(eventually([&] {
    const Screenshot shot = screen.shoot();
    return shot.is_white(575, 190) && !shot.is_white(552, 190);
  }));
  static_cast<void>(screen.settled());
  window.press("Return");
  static_cast<void>(screen.settled());
  window.press("Return");
  CHECK(eventually([&] { return bytes_of(folder / "house.pdf").starts_with("%PDF-1.5"); }));
  CHECK(eventually([&] { return !is_dimmed(); }));
  CHECK(output_of("pdfinfo '" + (folder / "house.pdf").string() + "'").find("Page size:") != std::string::npos);
}
