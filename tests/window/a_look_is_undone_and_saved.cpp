// SPDX-License-Identifier: GPL-3.0-or-later
#include <signal.h>

#include <catch2/catch.hpp>
#include <filesystem>
#include <fstream>

#include "core/io/session.h"
#include "tests/io/temporary_folder.h"
#include "tests/window/window_driver.h"

using namespace mes;
using namespace mes::test;

namespace {

// Without panels, status bar and toolbar, whose buttons for undo change.
constexpr PixelBox kCanvas{80, 40, 980, 760};

struct Window {
  TemporaryFolder folder;
  VirtualScreen screen;
  Child program;

  explicit Window(const std::string& name) {
    std::ofstream(folder / "house.poff") << "POFF 5 0 0\n0 0\n4 0\n4 3\n2 5\n0 3\n";
    start(name);
  }
  void start(const std::string& name) {
    program = Child();
    program = Child({MESECINA_BINARY, (folder / name).string()},
                    {{"DISPLAY", screen.display()},
                     {"WAYLAND_DISPLAY", ""},
                     {"XDG_CONFIG_HOME", (folder / "config").string()},
                     {"XDG_DATA_HOME", (folder / "data").string()},
                     {"LIBGL_ALWAYS_SOFTWARE", "1"},
                     {"ASAN_OPTIONS", "detect_leaks=0"}},
                    folder / "errors");
    REQUIRE(eventually([&] { return title().starts_with(name); }));
    screen.xdotool("mousemove 1200 6");
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
  void press(const std::string& keys) const { screen.xdotool("key " + keys); }
  std::string title() const { return screen.xdotool("search --name Mesecina getwindowname"); }
  bool shows(const Screenshot& look) const {
    return eventually([&] { return screen.shoot().box_of_changes(kCanvas, look).is_empty(); });
  }
  /// The screen when it shows something else and has come to rest.
  Screenshot other_than(const Screenshot& look) const {
    REQUIRE(eventually([&] { return !screen.shoot().box_of_changes(kCanvas, look).is_empty(); }));
    return screen.settled();
  }
  void save_as(const std::string& name) const {
    press("ctrl+shift+s");
    static_cast<void>(screen.settled());
    press("ctrl+a");
    screen.xdotool("type --delay 20 '" + (folder / name).string() + "'");
    static_cast<void>(screen.settled());
    press("Return");
    REQUIRE(eventually([&] { return title().starts_with(name); }));
  }
};

}  // namespace

TEST_CASE("a bundle chosen by a key is undone and redone, and no file of samples asks to be saved for it") {
  const Window window("house.poff");
  const Screenshot first = window.screen.settled();
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
  Window window("house.poff");
  const Screenshot first = window.screen.settled();
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
