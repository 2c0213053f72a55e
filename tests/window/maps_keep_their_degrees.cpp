// SPDX-License-Identifier: GPL-3.0-or-later
// Longitude and latitude of a map that is open are projected or kept, by an action of the palette.
#include <catch2/catch.hpp>

#include "core/io/format.h"
#include "tests/window/window_driver.h"

using namespace mes;
using namespace mes::test;

namespace {

void run_action(const DrivenProgram& window, const Screenshot& before, const std::string& action) {
  const VirtualScreen& screen = window.screen;
  window.press("ctrl+shift+p");
  REQUIRE(eventually([&] { return screen.shoot().differences(before, 0) > 1000; }));
  static_cast<void>(screen.settled());
  screen.xdotool("type --delay 20 " + action);
  static_cast<void>(screen.settled());
  window.press("Return");
}

std::vector<Vec2> positions_in(const std::filesystem::path& file) {
  const auto read = read_sample_file(file);
  REQUIRE(read.has_value());
  return read->data.positions;
}

}  // namespace

TEST_CASE("a map that is open is read again when its degrees are to be kept") {
  DrivenProgram window;
  // Half as wide as high, once it is projected.
  window.folder.write("map.geojson",
                      R"({"type": "Polygon", "coordinates": [[[10, 59], [12, 59], [12, 61], [10, 61]]]})");
  const std::vector<Vec2> degrees{{10, 59}, {12, 59}, {12, 61}, {10, 61}};
  window.start("map.geojson");
  const Screenshot projected = window.drawn();
  run_action(window, projected, "keep-degrees");
  REQUIRE(eventually([&] { return window.screen.settled().changes(kCanvas, projected) > 1000; }));
  const Screenshot kept = window.drawn();
  CHECK(window.title().starts_with("map.geojson"));
  run_action(window, kept, "keep-degrees");
  CHECK(eventually([&] { return window.screen.settled().changes(kCanvas, kept) > 1000; }));
  run_action(window, window.drawn(), "keep-degrees");
  CHECK(window.nearly_shows(kept));
  window.save_as("kept.poff");
  CHECK(positions_in(window.folder / "kept.poff") == degrees);
  // Now it is a file of its own, and stays as it is.
  const Screenshot saved = window.drawn();
  run_action(window, saved, "keep-degrees");
  static_cast<void>(window.drawn());
  CHECK(window.title().starts_with("kept.poff"));
}
