// SPDX-License-Identifier: GPL-3.0-or-later
// The page of experiments, with sources that are written meanwhile and a real compiler.
#include <algorithm>
#include <catch2/catch.hpp>
#include <filesystem>
#include <fstream>
#include <string>

#include "tests/window/window_driver.h"

using namespace mes;
using namespace mes::test;

namespace {

namespace fs = std::filesystem;

constexpr const char* kSource = "examples/experiments/gabriel.cpp";
constexpr const char* kDrawing = "if (is_gabriel[edge]) out";

// Of the page below the layers.
constexpr PixelBox kPage{939, 458, 1238, 768};
constexpr std::array<int, 2> kExamples{1038, 441};
constexpr std::array<int, 2> kFirstExample{1062, 457};  // of its popup
constexpr std::array<int, 2> kMessage{1057, 510};
constexpr std::array<int, 2> kRemove{1096, 506};  // of the first experiment, without messages

bool is_warning(Color c) {
  return c.r > 150 && c.r > c.b + 100 && c.r > c.g + 60;
}

/// Samples, the page of experiments, and a source of one's own, which is the only example.
struct ExperimentWindow : DrivenProgram {
  fs::path source;
  std::string text = bytes_of(kSource);

  ExperimentWindow() {
    REQUIRE(text.contains(kDrawing));
    // The assets of the program, and another folder of examples.
    const fs::path assets = folder / "assets";
    fs::create_directories(assets / "examples");
    for (const auto& entry : fs::directory_iterator(fs::absolute("assets")))
      fs::create_symlink(entry.path(), assets / entry.path().filename());
    source = fs::canonical(assets / "examples") / "own.cpp";
    std::ofstream(source) << text;
    const auto editor = folder.write("editor", "#!/bin/sh\necho \"$1\" >'" + edited().string() + "'\n");
    fs::permissions(editor, fs::perms::owner_all);
    folder.write("gear.poff", output_of(std::string(MESECINA_BINARY) + " shape gear --samples 60"));
    start("gear.poff", {{"MESECINA_ASSETS", assets.string()},
                        {"XDG_CACHE_HOME", (folder / "cache").string()},
                        {"VISUAL", editor.string()}});
    static_cast<void>(drawn());
  }
  fs::path edited() const { return folder / "edited"; }
  void open_page() const {
    press("ctrl+k");
    static_cast<void>(screen.settled());
    screen.type_over("experiments");
    static_cast<void>(screen.settled());
    press("Return");
    static_cast<void>(screen.settled());
  }
  Screenshot at_rest() const {
    screen.xdotool("mousemove 1200 6");
    return screen.settled();
  }
  /// The source with other words.
  void write(const std::string& words, const std::string& in_place_of = kDrawing) const {
    std::string changed = text;
    changed.replace(changed.find(in_place_of), in_place_of.size(), words);
    std::ofstream(source) << changed;
  }
  bool has_warning() const { return !screen.shoot().box_of(kPage, is_warning).is_empty(); }
  /// The line in which the source draws.
  std::string line() const {
    return std::to_string(1 + std::ranges::count(text.substr(0, text.find(kDrawing)), '\n'));
  }
  bool is_dimmed() const { return !screen.shoot().is_white(90, 700); }
};

}  // namespace

TEST_CASE("an example is shown, a mistake in it is listed while its picture stays, and it is corrected and removed") {
  const ExperimentWindow window;
  const VirtualScreen& screen = window.screen;
  window.open_page();
  const Screenshot before = window.at_rest();
  screen.click(kExamples);
  static_cast<void>(screen.settled());
  screen.click(kFirstExample);
  screen.xdotool("mousemove 1200 6");
  const Screenshot shown = window.other_than(before);
  CHECK(shown.changes(kCanvas, before) > 300);
  CHECK_FALSE(window.has_warning());

  window.write("if (is_gabriel[edge]) nowhere");
  REQUIRE(eventually([&] { return window.has_warning(); }));
  CHECK(window.at_rest().changes(kCanvas, shown) == 0);
  // The click puts file and line on the clipboard, and the editor opens the file.
  screen.click(kMessage);
  CHECK(eventually([&] { return bytes_of(window.edited()) == window.source.string() + "\n"; }));
  CHECK(eventually([&] { return screen.clipboard() == window.source.string() + ":" + window.line(); }));

  screen.xdotool("mousemove 1200 6");
  window.write("if (!is_gabriel[edge]) out");
  const Screenshot corrected = window.other_than(shown);
  CHECK(corrected.changes(kCanvas, shown) > 300);
  CHECK_FALSE(window.has_warning());

  screen.click(kRemove);
  screen.xdotool("mousemove 1200 6");
  CHECK(window.shows(before));
  // It is not looked at any more.
  window.write("if (is_gabriel[edge]) out");
  CHECK(window.at_rest().changes(kCanvas, before) == 0);
}

TEST_CASE("a source that is dropped on the window is asked about before it runs") {
  const ExperimentWindow window;
  const VirtualScreen& screen = window.screen;
  const Screenshot before = window.at_rest();
  const auto drop = [&] {
    screen.drop(window.source);
    REQUIRE(eventually([&] { return window.is_dimmed(); }));
    static_cast<void>(screen.settled());
  };
  drop();
  window.press("Escape");
  REQUIRE(eventually([&] { return !window.is_dimmed(); }));
  const Screenshot refused = window.at_rest();
  CHECK(refused.differences(before, 0) == 0);
  // Nothing was compiled.
  CHECK_FALSE(fs::exists(window.folder / "cache/mesecina/experiments"));

  drop();
  // "Run it" is at the lower left of the dialog.
  const Screenshot asked = screen.settled();
  const PixelBox dialog = asked.box_of(kCanvas, [](Color c) { return c.r > 245 && c.g > 245 && c.b > 245; });
  screen.click({dialog.left + 70, dialog.bottom - 26});
  REQUIRE(eventually([&] { return !window.is_dimmed(); }));
  screen.xdotool("mousemove 1200 6");
  CHECK(window.other_than(before).changes(kCanvas, before) > 300);
}
