// SPDX-License-Identifier: GPL-3.0-or-later
#include <catch2/catch.hpp>
#include <filesystem>
#include <fstream>

#include "core/io/session/session.h"
#include "tests/io/temporary_folder.h"
#include "tests/window/window_driver.h"

using namespace mes;
using namespace mes::test;

namespace {

/// The program with a session whose inner balls are twice as large, and whose number type is exact.
struct ReplacedWindow {
  TemporaryFolder folder;
  VirtualScreen screen;
  Child program;

  ReplacedWindow() {
    Session session;
    session.data =
        std::make_shared<const SampleData>(SampleData{{{0, 0}, {4, 0}, {5, 3}, {2, 4}}, {{true, {0, 1, 2, 3}}}, {}});
    session.settings[Parameter::a_scale] = 2.0;
    session.settings.precision = Precision::exact;
    folder.write("grown.json", write_session(session));
    program = Child({MESECINA_BINARY, (folder / "grown.json").string()},
                    {{"DISPLAY", screen.display()},
                     {"WAYLAND_DISPLAY", ""},
                     {"XDG_CONFIG_HOME", (folder / "config").string()},
                     {"XDG_DATA_HOME", (folder / "data").string()},
                     {"LIBGL_ALWAYS_SOFTWARE", "1"},
                     {"ASAN_OPTIONS", "detect_leaks=0"}},
                    folder / "errors");
    REQUIRE(eventually([&] { return title().starts_with("grown.json"); }));
    screen.xdotool("mousemove 1200 6");
  }
  void press(const std::string& keys) const { screen.xdotool("key " + keys); }
  std::string title() const { return screen.title(); }

  /// What is framed in the accent colour in the status bar.
  PixelBox chip() const {
    const auto is_accent = [](Color c) {
      return std::abs(c.r) < 12 && c.g > 90 && c.g < 115 && c.b > 145 && c.b < 170;
    };
    return screen.shoot().box_of({0, 772, 1280, 800}, is_accent);
  }
  bool has_chip() const { return chip().right - chip().left > 40; }

  Session saved_as(const std::string& name) const {
    press("ctrl+shift+s");
    const auto file = folder / name;
    // The dialog's field holds a name that is replaced.
    static_cast<void>(screen.settled());
    // Fields of text look once a frame which keys are down, so these are held until they were seen.
    screen.xdotool("keydown ctrl keydown a");
    static_cast<void>(screen.settled());
    screen.xdotool("keyup a keyup ctrl");
    screen.xdotool("type --delay 20 '" + file.string() + "'");
    static_cast<void>(screen.settled());
    screen.xdotool("keydown Return");
    const bool is_saved = eventually([&] { return std::filesystem::exists(file); });
    screen.xdotool("keyup Return");
    REQUIRE(is_saved);
    auto session = read_session(bytes_of(file), name);
    REQUIRE(session);
    return *session;
  }
};

}  // namespace

TEST_CASE("a changed parameter has a chip in the status bar, and a click on it gives the default back") {
  const ReplacedWindow window;
  REQUIRE(eventually([&] { return window.has_chip(); }));
  static_cast<void>(window.screen.settled());
  window.screen.click(window.chip().middle());
  CHECK(eventually([&] { return !window.has_chip(); }));
  const Session session = window.saved_as("reset.json");
  CHECK(session.settings[Parameter::a_scale] == 1.0);
  CHECK(session.settings.precision == Precision::exact);
}

TEST_CASE("the scale of balls does not follow into a new document, the number type does") {
  const ReplacedWindow window;
  REQUIRE(eventually([&] { return window.has_chip(); }));
  window.press("ctrl+n");
  CHECK(eventually([&] { return window.title().starts_with("Untitled"); }));
  CHECK(eventually([&] { return !window.has_chip(); }));
  const Session session = window.saved_as("new.json");
  CHECK(session.settings[Parameter::a_scale] == 1.0);
  CHECK(session.settings.precision == Precision::exact);
}
