// SPDX-License-Identifier: GPL-3.0-or-later
// The palette by keyboard alone, and a file of keys.
#include <algorithm>
#include <catch2/catch.hpp>
#include <filesystem>
#include <fstream>

#include "tests/window/window_driver.h"

using namespace mes;
using namespace mes::test;

namespace {

struct SearchedWindow : DrivenProgram {
  explicit SearchedWindow(const std::string& keys = {}) {
    folder.write("house.poff", "POFF 5 0 0\n0 0\n4 0\n4 3\n2 5\n0 3\n");
    std::filesystem::create_directories(keys_file().parent_path());
    if (!keys.empty()) std::ofstream(keys_file()) << keys;
    start("house.poff");
  }
  std::filesystem::path keys_file() const { return folder / "config" / "mesecina" / "keys.conf"; }
  /// Opens the palette, types and presses Enter, each when the one before is on screen.
  void find(const std::string& letters) const {
    const Screenshot before = screen.settled();
    press("ctrl+k");
    const Screenshot open = other_than(before);
    screen.xdotool("type --delay 20 '" + letters + "'");
    static_cast<void>(other_than(open));
    press("Return");
    // The dialog dims the canvas down to its lower edge.
    REQUIRE(eventually([&] {
      const Screenshot shot = screen.shoot();
      return shot.is_white(500, 755) || shot.is_white(85, 755);
    }));
  }
};

}  // namespace

TEST_CASE("a bundle and a layer are found by some letters and shown, and Esc leaves everything as it was") {
  const SearchedWindow window;
  const Screenshot first = window.drawn();
  window.press("ctrl+shift+p");
  static_cast<void>(window.other_than(first));
  window.press("Escape");
  CHECK(window.shows(first));
  window.press("2");
  const Screenshot second = window.other_than(first);
  window.press("ctrl+z");
  CHECK(window.shows(first));
  window.find("vor del");
  CHECK(window.shows(second));
  window.press("ctrl+z");
  CHECK(window.shows(first));
  // What is typed at once is not lost, nor is Enter taken for an answer of something else.
  window.screen.xdotool("key ctrl+k v o r space d e l Return");
  CHECK(window.shows(second));
}

TEST_CASE("a layer that is found is shown, found again it is hidden, and each is one step") {
  const SearchedWindow window;
  const Screenshot first = window.drawn();
  window.find("curve normals");
  const Screenshot with_normals = window.other_than(first);
  window.find("curve normals");
  CHECK(window.shows(first));
  window.press("ctrl+z");
  CHECK(window.shows(with_normals));
  window.press("ctrl+z");
  CHECK(window.shows(first));
}

TEST_CASE("a file gives commands other keys, bad lines are named, and the rest of it holds") {
  const SearchedWindow window("bundle-2 = W\nbundle-9 = W W\nno-such = Q\nundo = Ctrl+U\n");
  // Its cross is beside its first line.
  const auto is_warning = [](Color c) { return c.r == 0xFD && c.g == 0xF1 && c.b == 0xE7; };
  REQUIRE(eventually([&] { return !window.screen.shoot().box_of(kCanvas, is_warning).is_empty(); }));
  const PixelBox note = window.screen.settled().box_of(kCanvas, is_warning);
  window.screen.click({note.right - 20, note.top + 17});
  REQUIRE(eventually([&] { return window.screen.shoot().box_of(kCanvas, is_warning).is_empty(); }));
  window.screen.xdotool("mousemove 1200 6");
  const Screenshot first = window.drawn();
  // The key of the table is not that of the bundle any more.
  window.press("2");
  window.press("w");
  const Screenshot second = window.other_than(first);
  window.press("ctrl+u");
  CHECK(window.shows(first));
  window.find("voronoi and delaunay");
  CHECK(window.shows(second));
}

TEST_CASE("the file of keys is written with every command, and never over one that is there") {
  const SearchedWindow window;
  window.find("write or reread the file of keys");
  REQUIRE(eventually([&] { return std::filesystem::exists(window.keys_file()); }));
  CHECK(bytes_of(window.keys_file()).find("#tool-spray = S") != std::string::npos);
  std::ofstream(window.keys_file()) << "# mine\n";
  window.find("reread the file of keys");
  static_cast<void>(window.screen.settled());
  CHECK(bytes_of(window.keys_file()) == "# mine\n");
  // What is in it now holds at once.
  const Screenshot first = window.drawn();
  std::ofstream(window.keys_file()) << "bundle-2 = W\n";
  window.find("reread the file of keys");
  CHECK(window.shows(first));
  window.press("w");
  static_cast<void>(window.other_than(first));
}

TEST_CASE("a presentation hides the panels, steps through bundles, and Esc brings the panels back") {
  const SearchedWindow window;
  const Screenshot first = window.drawn();
  CHECK_FALSE(first.is_white(1270, 700));
  window.press("2");
  const Screenshot second = window.other_than(first);
  window.press("ctrl+z");
  CHECK(window.shows(first));
  window.press("F5");
  CHECK(eventually([&] { return window.screen.shoot().is_white(1270, 400); }));
  window.press("Next");
  window.press("Prior");
  window.press("Next");
  window.press("Escape");
  CHECK(window.shows(second));
}

TEST_CASE("an edit of the demo's drawing interrupts the demo, and the demo goes on without it") {
  SearchedWindow window;
  static_cast<void>(window.drawn());
  const std::string before = window.title();
  window.press("i");
  window.find("demo");
  REQUIRE(eventually([&] { return window.title() != before; }));
  const std::string demo = window.title();
  // A new sample is an edit at any time; the demo begins without samples that could be deleted.
  window.screen.click({500, 200});
  // Modified: the demo waits, with "Go on" and "Start again" in its caption.
  REQUIRE(eventually([&] { return window.title() != demo; }));
  const Screenshot edited = window.screen.settled();
  REQUIRE(window.program.is_running());
  // The second button from the right edge of the caption, beside the cross.
  const auto is_dark = [](Color c) { return std::max({c.r, c.g, c.b}) < 90; };
  const PixelBox words = edited.box_of({85, 720, 965, 755}, is_dark);
  REQUIRE_FALSE(words.is_empty());
  window.press("ctrl+z");
  CHECK(eventually([&] { return window.title() == demo; }));
  CHECK(window.program.is_running());
}

TEST_CASE("the document from before the demo comes back when the demo ends") {
  SearchedWindow window;
  static_cast<void>(window.drawn());
  const std::string before = window.title();
  window.find("demo");
  REQUIRE(eventually([&] { return window.title() != before; }));
  window.press("Escape");
  CHECK(eventually([&] { return window.title() == before; }));
  CHECK(window.program.is_running());
}

TEST_CASE("the number of a parameter that was found is typed at once, and then keys are the window's again") {
  SearchedWindow window;
  static_cast<void>(window.drawn());
  window.find("lambda limit");
  const Screenshot found = window.screen.settled();
  window.screen.xdotool("type --delay 20 '40'");
  window.press("Return");
  // The status bar names the parameter that has another value than its default.
  constexpr PixelBox kChips{300, 775, 620, 798};
  REQUIRE(eventually([&] { return window.screen.settled().changes(kChips, found) > 100; }));
  const Screenshot typed = window.screen.settled();
  constexpr PixelBox kTools{12, 36, 52, 110};
  CHECK(typed.changes(kTools, found) == 0);
  window.press("i");
  CHECK(eventually([&] { return window.screen.settled().changes(kTools, typed) > 100; }));
}

TEST_CASE("a format of geometry is found by its name") {
  const SearchedWindow window;
  static_cast<void>(window.drawn());
  window.press("ctrl+k");
  static_cast<void>(window.screen.settled());
  window.screen.xdotool("type --delay 20 'geometry wkt of areas'");
  static_cast<void>(window.screen.settled());
  window.press("Return");
  static_cast<void>(window.screen.settled());
  // Points are shown too, which have no areas.
  window.screen.type_over((window.folder / "found.wkt").string());
  window.press("Return");
  REQUIRE(eventually([&] { return std::filesystem::exists(window.folder / "found.wkt"); }));
  CHECK(bytes_of(window.folder / "found.wkt").starts_with("POLYGON"));
}
