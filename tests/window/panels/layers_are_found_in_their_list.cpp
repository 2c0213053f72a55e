// SPDX-License-Identifier: GPL-3.0-or-later
// Favourites of the list of layers, and rows that the palette shows.
#include <array>
#include <catch2/catch.hpp>
#include <cstdlib>
#include <filesystem>
#include <string>

#include "tests/window/window_driver.h"

using namespace mes;
using namespace mes::test;

namespace {

constexpr PixelBox kList{942, 120, 1218, 394};
constexpr PixelBox kBeginnings{942, 120, 1020, 394};  // of rows; left of swatches and of the chosen family

struct ListedWindow : DrivenProgram {
  explicit ListedWindow(const std::string& settings) {
    folder.write("house.poff", kHouse);
    std::filesystem::create_directories(folder / "config" / "mesecina");
    folder.write("config/mesecina/settings.json", settings);
    start("house.poff");
  }
  std::string settings() const { return bytes_of(folder / "config" / "mesecina" / "settings.json"); }
  Screenshot at_rest() const {
    screen.xdotool("mousemove 1200 6");
    return screen.settled();
  }
  void quit() {
    press("ctrl+q");
    REQUIRE(eventually([&] { return !program.is_running(); }));
  }
};

// The colour behind the row that was found: that of the theme over the panel.
bool is_marked(Color c) {
  return std::abs(c.r - 0xD6) <= 1 && std::abs(c.g - 0xE4) <= 1 && std::abs(c.b - 0xED) <= 1;
}

}  // namespace

TEST_CASE("a starred layer stands first, also in the next window, and a second click takes the star away") {
  // Nothing is unfolded but the subject, so that its first row is below three headings.
  ListedWindow window(R"({"schema": 1, "unfolded_layers": ["Favourites", "Delaunay & Voronoi"]})");
  const Screenshot before = window.drawn();
  // The first row is Delaunay; its star is left of its swatch.
  constexpr std::array<int, 2> kStar{1171, 190};
  window.screen.click(kStar);
  const Screenshot starred = window.at_rest();
  CHECK(starred.changes(kList, before) > 200);
  CHECK(starred.changes(kCanvas, before) == 0);
  window.quit();
  CHECK(window.settings().find("\"favorite_layers\": [\n    \"delaunay\"\n  ]") != std::string::npos);
  window.start("house.poff");
  CHECK(window.drawn().changes(kList, starred) == 0);
  // Now it is the first row of the favourites.
  window.screen.click({kStar[0], 164});
  CHECK(window.at_rest().changes(kList, before) == 0);
}

TEST_CASE("a layer that the palette finds is shown in the list, in its unfolded subject") {
  ListedWindow window(R"({"schema": 1})");
  const Screenshot before = window.drawn();
  REQUIRE(before.box_of(kBeginnings, is_marked).is_empty());
  window.screen.xdotool("key ctrl+k");
  static_cast<void>(window.screen.settled());
  window.screen.type_over("anti crust edges");
  static_cast<void>(window.screen.settled());
  window.press("Return");
  const Screenshot found = window.at_rest();
  const PixelBox row = found.box_of(kBeginnings, is_marked);
  REQUIRE_FALSE(row.is_empty());
  CHECK(row.right - row.left > 60);
  CHECK(row.bottom - row.top < 40);
  // A click on the list ends the mark.
  window.screen.click({row.left + 100, row.middle()[1]});
  CHECK(window.at_rest().box_of(kBeginnings, is_marked).is_empty());
  window.quit();
  CHECK(window.settings().find("\"Poles & power crust\"") != std::string::npos);
}

TEST_CASE("words for colours open the list of layers at the row of a shown layer") {
  for (const char* words : {"colour blind", "color blind", "colorblind"}) {
    INFO(words);
    ListedWindow window(R"({"schema": 1, "panels": ["statistics"], "pinned_panel": ""})");
    static_cast<void>(window.drawn());
    window.screen.xdotool("key ctrl+k");
    static_cast<void>(window.screen.settled());
    window.screen.type_over(words);
    static_cast<void>(window.screen.settled());
    window.press("Return");
    constexpr PixelBox kRows{942, 120, 1020, 700};
    const PixelBox row = window.at_rest().box_of(kRows, is_marked);
    REQUIRE_FALSE(row.is_empty());
    CHECK(row.bottom - row.top < 40);
    window.quit();
    CHECK(window.settings().find("\"layers\"") != std::string::npos);
  }
}
