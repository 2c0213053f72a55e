// SPDX-License-Identifier: GPL-3.0-or-later
// A figure is chosen, previewed and written with keys alone.
#include <catch2/catch.hpp>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <numbers>

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

TEST_CASE("centre lines are exported by their name in the palette, with their lengths") {
  DrivenProgram window;
  // A stadium: its centre line is a segment of length 4, from one centre of a half circle to the other.
  std::ofstream file(window.folder / "stadium.poff");
  constexpr int kRound = 40;
  file << "POFF " << 2 * kRound + 80 << " 0 0\n";
  for (int i = 0; i < 40; ++i) file << -2 + 0.1 * i << " -1\n" << 2 - 0.1 * i << " 1\n";
  for (int i = 0; i < kRound; ++i) {
    const double w = std::numbers::pi * (i / double{kRound} - 0.5);
    file << 2 + std::cos(w) << ' ' << std::sin(w) << '\n' << -2 - std::cos(w) << ' ' << -std::sin(w) << '\n';
  }
  file.close();
  window.start("stadium.poff");
  const Screenshot before = window.drawn();
  window.press("ctrl+k");
  static_cast<void>(window.other_than(before));
  window.screen.xdotool("type --delay 20 'export centre'");
  static_cast<void>(window.screen.settled());
  window.press("Return");
  static_cast<void>(window.screen.settled());
  window.press("Return");
  const auto path = window.folder / "stadium-center-lines.geojson";
  REQUIRE(eventually([&] { return std::filesystem::exists(path); }));
  const auto lines = nlohmann::json::parse(bytes_of(path));
  REQUIRE(lines.at("features").size() == 1);
  const auto& properties = lines.at("features").at(0).at("properties");
  CHECK(std::abs(properties.at("length").get<double>() - 4.0) < 0.3);
  CHECK(std::abs(properties.at("width_mean").get<double>() - 2.0) < 0.05);
}
