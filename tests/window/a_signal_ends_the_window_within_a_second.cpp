// SPDX-License-Identifier: GPL-3.0-or-later
// Whatever its threads are waiting for.
#include <fcntl.h>
#include <sys/stat.h>

#include <catch2/catch.hpp>
#include <chrono>
#include <csignal>
#include <filesystem>
#include <fstream>

#include "app/store/autosave.h"
#include "tests/io/temporary_folder.h"
#include "tests/window/window_driver.h"

using namespace mes;
using namespace mes::test;
namespace fs = std::filesystem;

namespace {

struct SignalledWindow {
  TemporaryFolder home;
  VirtualScreen screen;
  fs::path pipe = home / "pipe.poff";
  Child program;

  SignalledWindow() { REQUIRE(::mkfifo(pipe.c_str(), 0600) == 0); }
  void start(const std::vector<std::string>& files) {
    std::vector<std::string> words{MESECINA_BINARY};
    words.insert(words.end(), files.begin(), files.end());
    program = Child(words,
                    {{"DISPLAY", screen.display()},
                     {"WAYLAND_DISPLAY", ""},
                     {"HOME", home.path().string()},
                     {"XDG_CONFIG_HOME", (home / "config").string()},
                     {"XDG_DATA_HOME", (home / "data").string()},
                     {"LIBGL_ALWAYS_SOFTWARE", "1"},
                     {"MESECINA_PATIENCE", ""},
                     {"ASAN_OPTIONS", "detect_leaks=0"}},
                    home / "errors");
    REQUIRE(eventually([&] { return !title().empty() && corner().r > 0; }));
  }
  std::string title() const { return screen.title(); }
  Color corner() const { return screen.shoot().at(20, 765); }
  fs::path journals() const { return home / "data" / "mesecina" / "autosave"; }
  bool has_journaled_edit() const {
    std::error_code error;
    for (const auto& entry : fs::directory_iterator(journals(), error))
      if (bytes_of(entry.path()).find("\"edit\"") != std::string::npos) return true;
    return false;
  }
  bool has_dialog() const {
    const int light = corner().r;
    return light > 0 && light < 252;
  }
};

}  // namespace

TEST_CASE("a window that waits for a pipe to be written to ends with a signal, and by its own key") {
  SignalledWindow window;
  window.start({window.pipe.string()});
  kill(window.program.pid(), SIGTERM);
  CHECK(window.program.wait() == 128 + SIGTERM);
  window.start({window.pipe.string()});
  window.screen.xdotool("key ctrl+q");
  REQUIRE(eventually([&] { return !window.program.is_running(); }));
  CHECK(window.program.wait() == 0);
  CHECK(bytes_of(window.home / "errors").empty());
}

TEST_CASE("a window that waits for a pipe to be read from ends with a signal, and its work is offered later") {
  SignalledWindow window;
  std::ofstream(window.home / "a.poff") << "POFF 4 0 0\n0 0\n4 0\n4 3\n0 3\n";
  window.start({(window.home / "a.poff").string()});
  REQUIRE(eventually([&] { return window.title().starts_with("a.poff - Mesecina"); }));
  window.screen.xdotool("mousemove 500 30");
  window.screen.xdotool("key ctrl+a");
  window.screen.xdotool("key Right");
  REQUIRE(eventually([&] { return window.title().starts_with("* a.poff") && window.has_journaled_edit(); }));
  window.screen.xdotool("key ctrl+shift+s");
  REQUIRE(eventually([&] { return window.has_dialog(); }));
  window.screen.settled();
  window.screen.xdotool("key ctrl+a");
  window.screen.xdotool("type --delay 30 '" + window.pipe.string() + "'");
  window.screen.xdotool("keydown Return");
  const Screenshot before = window.screen.settled();
  window.screen.xdotool("keyup Return");
  // "Replace it", at the foot of the dialog.
  const PixelBox dialog =
      before.box_of({0, 0, 1280, 800}, [](Color c) { return c.r > 230 && c.g > 230 && c.b > 230; });
  window.screen.click({dialog.left + 50, dialog.bottom - 28});
  REQUIRE(eventually([&] { return !window.has_dialog(); }));
  kill(window.program.pid(), SIGTERM);
  CHECK(window.program.wait() == 128 + SIGTERM);
  const FoundWork found = find_left_work(window.journals());
  REQUIRE(found.works.size() == 1);
  CHECK(found.works[0].edits() == 1);
  CHECK(bytes_of(window.home / "errors").empty());
}
