// SPDX-License-Identifier: GPL-3.0-or-later
#include <signal.h>

#include <algorithm>
#include <catch2/catch.hpp>
#include <filesystem>
#include <fstream>

#include "core/io/session/session.h"
#include "tests/window/window_driver.h"

using namespace mes;
using namespace mes::test;

namespace {

struct StyledWindow : DrivenProgram {
  explicit StyledWindow(const std::string& name) {
    folder.write("house.poff", "POFF 5 0 0\n0 0\n4 0\n4 3\n2 5\n0 3\n");
    start(name);
  }
  /// The journal says that a file holds everything; until then a crash leaves work to recover.
  bool has_journaled_save() const {
    std::error_code error;
    for (const auto& entry : std::filesystem::directory_iterator(folder / "data" / "mesecina" / "autosave", error)) {
      const auto journal = read_journal(bytes_of(entry.path()), entry.path().string());
      if (!journal || journal->unsaved_edits != 0) return false;
    }
    return true;
  }
};

}  // namespace

TEST_CASE("a bundle chosen by a key is undone and redone, and no file of samples asks to be saved for it") {
  const StyledWindow window("house.poff");
  const Screenshot first = window.drawn();
  window.press("2");
  const Screenshot second = window.other_than(first);
  window.press("4");
  const Screenshot third = window.other_than(second);
  window.press("ctrl+z");
  CHECK(window.shows(second));
  window.press("ctrl+z");
  CHECK(window.shows(first));
  window.press("ctrl+shift+z");
  CHECK(window.shows(second));
  CHECK(window.title().starts_with("house.poff"));
  // Two keys at once: the second finds the first one done.
  window.screen.xdotool("key 4 ctrl+z");
  window.press("ctrl+z");
  CHECK(window.shows(first));
}

TEST_CASE("in a session changes of layers are unsaved work, and its file brings their undo back") {
  StyledWindow window("house.poff");
  const Screenshot first = window.drawn();
  window.save_as("house.json");
  window.press("2");
  CHECK(eventually([&] { return window.title().starts_with("* house.json"); }));
  const Screenshot second = window.other_than(first);
  window.press("ctrl+z");
  CHECK(eventually([&] { return window.title().starts_with("house.json"); }));
  window.press("ctrl+shift+z");
  CHECK(eventually([&] { return window.title().starts_with("* house.json"); }));
  window.press("ctrl+s");
  CHECK(eventually([&] { return window.title().starts_with("house.json"); }));
  REQUIRE(eventually([&] { return window.has_journaled_save(); }));

  kill(window.program.pid(), SIGKILL);
  window.program.wait();
  window.start("house.json");
  CHECK(window.shows(second));
  window.press("ctrl+z");
  CHECK(window.shows(first));
}

TEST_CASE("a typed range of a colour map counts when Tab leaves its field") {
  StyledWindow window("house.poff");
  Session session;
  session.data = std::make_shared<const SampleData>(SampleData{{{0, 0}, {4, 0}, {5, 3}, {2, 4}}, {}, {}});
  LayerStyle style;
  style.color_map = "viridis";
  session.layers.layers = {{"interior-voronoi-disks", true, style}};
  window.folder.write("mapped.json", write_session(session));
  window.start("mapped.json");
  // The swatch of the only layer that is shown has the colours of the map, the first of which is a dark purple.
  const auto is_purple = [](Color c) { return c.r > 50 && c.r < 80 && c.g < 30 && c.b > 70 && c.b < 110; };
  constexpr PixelBox kRows{1160, 150, 1230, 390};
  REQUIRE(eventually([&] { return !window.screen.shoot().box_of(kRows, is_purple).is_empty(); }));
  const Screenshot before = window.screen.settled();
  const PixelBox swatch = before.box_of({kRows.left, kRows.top, kRows.right, kRows.top + 60}, is_purple);
  window.screen.click({swatch.left + 4, swatch.middle()[1]});
  REQUIRE(eventually([&] { return window.screen.shoot().differences(before, 30) > 5000; }));
  Screenshot look = window.screen.settled();
  const auto press = [&](const std::string& keys) {
    window.screen.xdotool(keys);
    REQUIRE(eventually([&] { return window.screen.shoot().differences(look, 0) > 0; }));
    look = window.screen.settled();
  };
  // Tab goes to the first field of a popup, and from there to the second.
  press("key Tab");
  press("type --delay 20 0.25");
  press("key Tab");
  press("type --delay 20 2.5");
  press("key Tab");
  press("key Escape");
  press("key Escape");
  window.press("ctrl+s");
  const auto saved = [&] {
    const auto now = read_session(bytes_of(window.folder / "mapped.json"), "mapped.json");
    if (!now) return LayerStyle();
    const auto& layers = now->layers.layers;
    const auto found = std::ranges::find(layers, "interior-voronoi-disks", &LayerConfiguration::Entry::layer);
    return found == layers.end() ? LayerStyle() : found->style;
  };
  CHECK(eventually([&] { return saved().range_locked; }));
  CHECK(saved().range_low == 0.25);
  CHECK(saved().range_high == 2.5);
}

TEST_CASE("a legend lies where it was dragged, however fast the hand was") {
  StyledWindow window("house.poff");
  Session session;
  session.data = std::make_shared<const SampleData>(SampleData{{{0, 0}, {4, 0}, {5, 3}, {2, 4}}, {}, {}});
  LayerStyle style;
  style.color_map = "viridis";
  session.layers.layers = {{"medial-axis", true, style}};
  window.folder.write("mapped.json", write_session(session));
  window.start("mapped.json");
  // The first colours of the map are nowhere but in the legend.
  const auto is_purple = [](Color c) { return c.r > 60 && c.r < 80 && c.g < 30 && c.b > 70 && c.b < 115; };
  constexpr PixelBox kBelow{560, 500, 930, 768};
  REQUIRE(eventually([&] { return !window.screen.shoot().box_of(kBelow, is_purple).is_empty(); }));
  const PixelBox before = window.drawn().box_of(kBelow, is_purple);
  window.screen.drag({before.left + 2, before.top + 2}, {before.left - 248, before.top - 198}, 1);
  const auto has_moved = [&] {
    const PixelBox now = window.screen.shoot().box_of(
        {before.left - 250, before.top - 200, before.right - 250 + 1, before.bottom - 200 + 1}, is_purple);
    return now.left == before.left - 250 && now.top == before.top - 200;
  };
  CHECK(eventually(has_moved));
  window.screen.xdotool("mouseup 1");
  static_cast<void>(window.screen.settled());
  CHECK(eventually(has_moved));
}

TEST_CASE(
    "a scale bar is dragged, given back by Escape, undo or a double click, and stands there in the next window") {
  DrivenProgram window;
  // No corner of the view has a sample.
  window.folder.write("diamond.poff", "POFF 4 0 0\n0 -1\n1 0\n0 1\n-1 0\n");
  const auto settings = [&] { return bytes_of(window.folder / "config" / "mesecina" / "settings.json"); };
  std::filesystem::create_directories(window.folder / "config" / "mesecina");
  window.folder.write("config/mesecina/settings.json", R"({"schema": 1, "show_scale_bar": true})");
  window.start("diamond.poff");
  // Below the samples nothing but the line of the bar is so dark.
  constexpr PixelBox kLow{80, 740, 240, 764};
  const auto is_ink = [](Color c) { return c.r < 60 && c.g < 60 && c.b < 70; };
  REQUIRE(eventually([&] { return !window.screen.shoot().box_of(kLow, is_ink).is_empty(); }));
  const Screenshot own = window.drawn();
  const PixelBox bar = own.box_of(kLow, is_ink);
  const std::array<int, 2> from{bar.middle()[0], bar.bottom - 6};
  const std::array<int, 2> to{from[0] + 60, from[1] - 90};
  const auto is_at = [&](const Screenshot& shot, int right, int down) {
    const PixelBox there{bar.left + right, bar.top + down, bar.right + right, bar.bottom + down};
    const PixelBox now = shot.box_of(there, is_ink);
    return now.left == there.left && now.right == there.right && now.bottom == there.bottom;
  };
  const auto drag = [&] {
    window.screen.drag(from, to, 1);
    return eventually([&] { return is_at(window.screen.shoot(), 60, -90); });
  };
  // A button that goes up and down again between two frames was never up. The tool under the pointer stands out once
  // nothing is held any more.
  const auto release = [&] {
    constexpr PixelBox kTool{12, 75, 52, 108};
    window.screen.xdotool("mouseup 1");
    window.screen.xdotool("mousemove 32 90");
    REQUIRE(eventually([&] { return !window.screen.shoot().box_of_changes(kTool, own).is_empty(); }));
    window.screen.xdotool("mousemove 1200 6");
    REQUIRE(eventually([&] { return window.screen.shoot().box_of_changes(kTool, own).is_empty(); }));
  };
  for (const char* key : {"Escape", "ctrl+z"}) {
    INFO(key);
    REQUIRE(drag());
    window.press(key);
    CHECK(eventually([&] { return is_at(window.screen.shoot(), 0, 0); }));
    release();
    CHECK(window.shows(own));
  }
  REQUIRE(drag());
  release();
  CHECK(is_at(window.screen.settled(), 60, -90));
  // Near the edges it takes the usual margin, which is that of its own place.
  window.screen.drag(to, {from[0] + 5, from[1] - 4}, 1);
  CHECK(eventually([&] { return is_at(window.screen.shoot(), 0, 0); }));
  release();
  REQUIRE(drag());
  release();
  const Screenshot moved = window.screen.settled();
  CHECK(is_at(moved, 60, -90));
  // The next window has it there.
  window.press("ctrl+q");
  REQUIRE(eventually([&] { return !window.program.is_running(); }));
  CHECK(settings().find("\"scale_bar_at\": \"bottom-left:") != std::string::npos);
  window.start("diamond.poff");
  CHECK(eventually([&] { return is_at(window.screen.shoot(), 60, -90); }));
  // Clicking it does nothing; a second click at once gives it back.
  window.screen.click(to);
  CHECK(is_at(window.screen.settled(), 60, -90));
  // Two clicks between two frames are one.
  CHECK(eventually([&] {
    if (is_at(window.screen.settled(), 0, 0)) return true;
    window.screen.xdotool("click --repeat 2 --delay 60 1");
    return is_at(window.screen.settled(), 0, 0);
  }));
}
