// SPDX-License-Identifier: GPL-3.0-or-later
// A figure is chosen, previewed and written with keys alone.
#include <catch2/catch.hpp>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <numbers>

#include "core/base/geometry/vec2.h"
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

TEST_CASE("arrow keys go through the controls of the dialog, and the space bar presses the marked one") {
  DrivenProgram window;
  window.folder.write("house.poff", kHouse);
  window.start("house.poff");
  Screenshot before = window.drawn();
  // From the formats down to the sizes, and on to the square.
  for (const char* key : {"ctrl+e", "Down", "Right", "Right", "Right", "space"}) {
    window.press(key);
    REQUIRE(eventually([&] { return window.screen.shoot().differences(before, 10) > 20; }));
    before = window.screen.settled();
  }
  window.press("Return");
  static_cast<void>(window.other_than(before));
  static_cast<void>(window.screen.settled());
  window.press("Return");
  REQUIRE(eventually([&] { return bytes_of(window.folder / "house.pdf").starts_with("%PDF-1.5"); }));
  CHECK_THAT(output_of("pdfinfo '" + (window.folder / "house.pdf").string() + "'"),
             Catch::Contains("238.11 x 238.11"));
}

TEST_CASE("the preview shows the page as large as on paper on request") {
  DrivenProgram window;
  window.folder.write("house.poff", kHouse);
  window.start("house.poff");
  static_cast<void>(window.drawn());
  window.press("ctrl+e");
  // The page is white, and what lies around it is not.
  constexpr PixelBox kPreview{545, 140, 1158, 702};  // below the tooltip of the box
  const auto page = [&] {
    return window.screen.shoot().box_of(kPreview, [](Color c) { return c.r == 255 && c.g == 255 && c.b == 255; });
  };
  REQUIRE(eventually([&] { return page().right - page().left > 500; }));
  window.screen.click({553, 106});
  constexpr int kColumn = 317;  // 84 mm at 96 pixels per inch
  CHECK(eventually([&] { return std::abs(page().right - page().left - kColumn) <= 2; }));
  window.screen.click({553, 106});
  CHECK(eventually([&] { return page().right - page().left > 500; }));
}

namespace {

void choose_in_palette(const DrivenProgram& window, const std::string& words) {
  const Screenshot before = window.screen.settled();
  window.press("ctrl+k");
  static_cast<void>(window.other_than(before));
  window.screen.xdotool("type --delay 20 '" + words + "'");
  static_cast<void>(window.screen.settled());
  window.press("Return");
  static_cast<void>(window.screen.settled());
}

/// Exports centre lines under the name that is offered, and reads them.
nlohmann::json exported_center_lines(const DrivenProgram& window, const std::string& name) {
  const auto path = window.folder / (name + "-center-lines.geojson");
  std::filesystem::remove(path);
  choose_in_palette(window, "export centre");
  window.press("Return");
  REQUIRE(eventually([&] { return std::filesystem::exists(path); }));
  static_cast<void>(window.screen.settled());  // a click goes to the canvas once the dialog is gone
  return nlohmann::json::parse(bytes_of(path)).at("features");
}

}  // namespace

TEST_CASE("with two samples selected the centre line between the ends near them is exported") {
  DrivenProgram window;
  // A cross: arms of width 1 to the left and right reach 6 from the middle, those up and down 4.
  std::ofstream file(window.folder / "cross.poff");
  constexpr int kAcross = 20;
  std::vector<Vec2> samples;
  const auto side = [&](Vec2 from, Vec2 to) {
    const int n = static_cast<int>(std::lround(distance(from, to) * kAcross));
    for (int i = 0; i < n; ++i) samples.push_back(from + (static_cast<double>(i) / n) * (to - from));
  };
  const std::vector<Vec2> corners{{6, -0.5}, {6, 0.5},   {0.5, 0.5},   {0.5, 4},   {-0.5, 4}, {-0.5, 0.5},
                                  {-6, 0.5}, {-6, -0.5}, {-0.5, -0.5}, {-0.5, -4}, {0.5, -4}, {0.5, -0.5}};
  for (std::size_t i = 0; i < corners.size(); ++i) side(corners[i], corners[(i + 1) % corners.size()]);
  file << "POFF " << samples.size() << " 0 0\n";
  for (const Vec2 p : samples) file << p.x << ' ' << p.y << '\n';
  file.close();
  window.start("cross.poff");
  // Only samples are black here.
  window.press("1");
  const Screenshot drawn = window.drawn();
  const PixelBox box = drawn.box_of({100, 40, 930, 760}, [](Color c) { return c.r < 60 && c.g < 60 && c.b < 60; });
  const auto [middle_x, middle_y] = box.middle();
  const nlohmann::json whole = exported_center_lines(window, "cross");
  REQUIRE(whole.size() == 1);
  CHECK(whole[0]["properties"]["length"].get<double>() == Approx(11).margin(0.6));

  window.screen.click({middle_x, box.top + 2});
  window.screen.xdotool("keydown shift");
  window.screen.click({box.right - 3, middle_y});
  window.screen.xdotool("keyup shift");
  const nlohmann::json chosen = exported_center_lines(window, "cross");
  REQUIRE(chosen.size() == 1);
  CHECK(chosen[0]["properties"]["length"].get<double>() == Approx(9).margin(0.6));
  const auto& places = chosen[0]["geometry"]["coordinates"];
  CHECK(std::max(places.front()[1].get<double>(), places.back()[1].get<double>()) > 3);
  CHECK(std::max(places.front()[0].get<double>(), places.back()[0].get<double>()) > 5);

  // The same line is drawn, with rings about its ends, and is exported from now on, until the step is undone.
  const auto vermilion = [&] {
    return window.screen.settled().box_of({100, 40, 930, 760},
                                          [](Color c) { return c.r > 190 && c.g > 60 && c.g < 130 && c.b < 60; });
  };
  choose_in_palette(window, "centre line between");
  window.press("Escape");
  window.press("Escape");
  const PixelBox line = vermilion();
  CHECK(line.left > middle_x - 30);
  CHECK(line.right > box.right - 60);
  CHECK(line.top < box.top + 60);
  CHECK(line.bottom < middle_y + 30);
  CHECK(exported_center_lines(window, "cross")[0]["properties"]["length"] == chosen[0]["properties"]["length"]);
  window.press("ctrl+z");
  CHECK(exported_center_lines(window, "cross")[0]["properties"]["length"] == whole[0]["properties"]["length"]);
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
  static_cast<void>(window.drawn());
  const nlohmann::json lines = exported_center_lines(window, "stadium");
  REQUIRE(lines.size() == 1);
  const auto& properties = lines.at(0).at("properties");
  CHECK(std::abs(properties.at("length").get<double>() - 4.0) < 0.3);
  CHECK(std::abs(properties.at("width_mean").get<double>() - 2.0) < 0.05);
}
