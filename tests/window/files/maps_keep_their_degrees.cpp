// SPDX-License-Identifier: GPL-3.0-or-later
// Longitude and latitude of a map that is open are projected or kept, by an action of the palette.
#include <sys/stat.h>

#include <algorithm>
#include <catch2/catch.hpp>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include "core/base/geometry/box2.h"
#include "core/io/format.h"
#include "core/io/session/session.h"
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

/// All corners, among the samples between them, and none beyond.
bool holds(const std::vector<Vec2>& positions, const std::vector<Vec2>& corners) {
  Box2 box;
  for (const Vec2 p : positions) box.add(p);
  Box2 wanted;
  for (const Vec2 p : corners) wanted.add(p);
  return box == wanted &&
         std::ranges::all_of(corners, [&](Vec2 p) { return std::ranges::find(positions, p) != positions.end(); });
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
  CHECK(holds(positions_in(window.folder / "kept.poff"), degrees));
  // Now it is a file of its own, and stays as it is.
  const Screenshot saved = window.drawn();
  run_action(window, saved, "keep-degrees");
  static_cast<void>(window.drawn());
  CHECK(window.title().starts_with("kept.poff"));
}

TEST_CASE("the coordinate system of a file that names none is chosen, and a wrong name is asked again") {
  DrivenProgram window;
  // 800 m by 200 m in UTM zone 32.
  window.folder.write("strip.wkt",
                      "POLYGON ((500000 5540000, 500800 5540000, 500800 5540200, 500000 5540200, 500000 5540000))");
  window.start("strip.wkt");
  const Screenshot plain = window.drawn();
  const auto ask = [&] {
    run_action(window, window.screen.settled(), "map-system");
    return window.screen.settled();
  };
  const Screenshot empty = ask();
  CHECK(empty.differences(plain, 30) > 5000);
  window.screen.xdotool("type --delay 20 EPSG:99999999");
  window.press("Return");
  const Screenshot refused = window.screen.settled();
  CHECK(refused.differences(plain, 30) > 5000);
  CHECK(refused.differences(empty, 30) > 500);
  window.screen.type_over("EPSG:25832");
  window.press("Return");
  REQUIRE(eventually([&] { return window.shows(plain); }));
  window.save_as("placed.json");
  const auto placed = read_session(bytes_of(window.folder / "placed.json"), "placed.json");
  REQUIRE(placed);
  REQUIRE(placed->data->map);
  CHECK(placed->data->map->system == "EPSG:25832");
}

TEST_CASE("a map that was opened with a file of balls is read again with it") {
  DrivenProgram window;
  window.folder.write("map.geojson",
                      R"({"type": "Polygon", "coordinates": [[[10, 59], [12, 59], [12, 61], [10, 61]]]})");
  const std::filesystem::path balls = window.folder.write("balls.wpoff", "WPOFF 1 0 0\n11 60 0.5\n");
  window.program = Child({MESECINA_BINARY, (window.folder / "map.geojson").string(), balls.string()},
                         {{"DISPLAY", window.screen.display()},
                          {"WAYLAND_DISPLAY", ""},
                          {"DBUS_SESSION_BUS_ADDRESS", "unix:path=/nonexistent"},
                          {"XDG_CONFIG_HOME", (window.folder / "config").string()},
                          {"XDG_DATA_HOME", (window.folder / "data").string()},
                          {"LIBGL_ALWAYS_SOFTWARE", "1"},
                          {"MESECINA_SHOWS_REST", "1"},
                          {"ASAN_OPTIONS", "detect_leaks=0"}},
                         window.folder / "errors");
  REQUIRE(eventually([&] { return window.title().starts_with("map.geojson"); }));
  const Screenshot projected = window.drawn();
  run_action(window, projected, "keep-degrees");
  CHECK(eventually([&] { return window.screen.settled().changes(kCanvas, projected) > 1000; }));
  window.save_as("kept.poff");
  CHECK(holds(positions_in(window.folder / "kept.poff"), std::vector<Vec2>{{10, 59}, {12, 59}, {12, 61}, {10, 61}}));
}

TEST_CASE("what is being read when degrees are to be kept is read, and the map that is there then keeps them") {
  for (const bool is_cancelled : {false, true}) {
    DrivenProgram window;
    window.folder.write("map.geojson",
                        R"({"type": "Polygon", "coordinates": [[[10, 59], [12, 59], [12, 61], [10, 61]]]})");
    window.start("map.geojson");
    // Reading of a pipe waits for what is written to it.
    const std::filesystem::path pipe = window.folder / "other.geojson";
    REQUIRE(::mkfifo(pipe.c_str(), 0600) == 0);
    const Screenshot before = window.drawn();
    window.press("ctrl+o");
    REQUIRE(eventually([&] { return window.screen.shoot().differences(before, 30) > 500; }));
    static_cast<void>(window.screen.settled());
    window.screen.type_over(pipe.string());
    window.press("Return");
    // The bar of reading moves, so the window does not come to rest.
    REQUIRE(eventually([&] { return window.screen.shoot().changes(kCanvas, before) == 0; }));
    window.press("ctrl+shift+p");
    REQUIRE(eventually([&] { return window.screen.shoot().changes(kCanvas, before) > 1000; }));
    window.screen.xdotool("type --delay 50 keep-degrees");
    window.press("Return");
    REQUIRE(eventually([&] { return window.screen.shoot().changes(kCanvas, before) == 0; }));
    std::vector<Vec2> expected{{10, 59}, {12, 59}, {12, 61}, {10, 61}};
    if (is_cancelled) {
      window.press("Escape");
      CHECK(eventually([&] { return window.screen.settled().changes(kCanvas, before) > 1000; }));
      CHECK(window.title().starts_with("map.geojson"));
    } else {
      // What is read again then is a file of that name.
      const std::string other = R"({"type": "Polygon", "coordinates": [[[10, 49], [12, 49], [12, 51]]]})";
      std::ofstream out(pipe);
      std::filesystem::remove(pipe);
      window.folder.write("other.geojson", other);
      out << other;
      out.close();
      expected = {{10, 49}, {12, 49}, {12, 51}};
      REQUIRE(eventually([&] { return window.title().starts_with("other.geojson"); }));
      static_cast<void>(window.drawn());
    }
    window.save_as("kept.poff");
    CHECK(holds(positions_in(window.folder / "kept.poff"), expected));
  }
}
