// SPDX-License-Identifier: GPL-3.0-or-later
#include <signal.h>

#include <catch2/catch.hpp>
#include <cmath>
#include <filesystem>
#include <fstream>

#include "app/recording/take.h"
#include "core/io/format.h"
#include "core/io/session/session.h"
#include "tests/io/temporary_folder.h"
#include "tests/window/window_driver.h"

using namespace mes;
using namespace mes::test;
namespace fs = std::filesystem;

namespace {

/// The program with a circle of samples, panels hidden, recording.
struct Studio {
  TemporaryFolder folder;
  VirtualScreen screen;
  Child program;

  explicit Studio(int samples = 60) {
    const fs::path file = folder / "circle.poff";
    std::ofstream out(file);
    out << "POFF " << samples << " 0 0\n";
    for (int i = 0; i < samples; ++i)
      out << 100 * std::cos(2 * 3.14159265 * i / samples) << ' ' << 100 * std::sin(2 * 3.14159265 * i / samples)
          << '\n';
    out.close();
    program = Child({MESECINA_BINARY, file.string()},
                    {{"DISPLAY", screen.display()},
                     {"WAYLAND_DISPLAY", ""},
                     {"HOME", folder.path().string()},
                     {"XDG_CONFIG_HOME", (folder / "config").string()},
                     {"XDG_DATA_HOME", (folder / "data").string()},
                     {"LIBGL_ALWAYS_SOFTWARE", "1"},
                     {"ASAN_OPTIONS", "detect_leaks=0"}},
                    folder / "errors");
    REQUIRE(eventually([&] { return screen.title().starts_with("circle.poff"); }));
    screen.xdotool("mousemove 640 400");
    press("Tab");
    press("f");
    REQUIRE(eventually([&] { return screen.shoot().is_dark(1000, 400) && screen.shoot().is_white(3, 3); }));
    static_cast<void>(screen.settled());  // the notice about the hidden panels has faded
    press("F4");
    REQUIRE(eventually([&] { return !take().empty(); }));
  }
  void press(const std::string& keys) const { screen.xdotool("key " + keys); }
  fs::path take() const {
    std::error_code error;
    for (const auto& entry : fs::directory_iterator(folder / "mesecina", error))
      if (entry.is_directory()) return entry.path();
    return {};
  }
  std::size_t frames() const {
    const auto read = read_take(take());
    return read ? read->frames.size() : 0;
  }
  bool is_complete() const {
    const auto read = read_take(take());
    return read && read->complete;
  }
  bool all_are_whole() const {
    for (std::size_t i = 1; i <= frames(); ++i)
      if (read_picture(take() / frame_name(i)).width() != 1280) return false;
    return true;
  }
  bool has_banner() const {
    const auto is_banner = [](Color c) {
      return std::abs(c.r - 0xFD) < 4 && std::abs(c.g - 0xF1) < 4 && std::abs(c.b - 0xE7) < 4;
    };
    return screen.shoot().count(is_banner) > 3000;
  }
};

}  // namespace

TEST_CASE("there are as many frames as changes, each complete") {
  Studio studio(300);
  const VirtualScreen& screen = studio.screen;
  constexpr int kMoves = 12;
  studio.press("s");
  screen.drag({300, 100}, {300, 700}, kMoves);
  screen.xdotool("mouseup 1");
  studio.press("ctrl+z");
  studio.press("ctrl+shift+z");
  studio.press("i");
  screen.xdotool("mousemove 200 200 click 1");
  constexpr std::size_t kChanges = 1 + kMoves + 2 + 1;
  REQUIRE(eventually([&] { return studio.frames() >= kChanges; }));
  screen.xdotool("mousemove 3 3");
  const Screenshot shown = screen.shoot();
  studio.press("F4");
  REQUIRE(eventually([&] { return studio.is_complete(); }));
  const auto read = read_take(studio.take());
  REQUIRE(read);
  REQUIRE(read->frames.size() == kChanges);
  CHECK(read->frames[0].what == "Spray");
  CHECK(read->frames[1 + kMoves].what == "Undo");
  CHECK(read->frames[1 + kMoves + 1].what == "Redo");
  // The manifest is the session that made them: what was done is in it.
  const auto source = read_sample_file(studio.take() / kManifestName);
  REQUIRE(source);
  CHECK(source->is_carried);
  REQUIRE(source->session);
  CHECK(source->data.positions.size() > 300);
  std::size_t undone = 0;
  for (std::size_t i = 0; i < source->session->entries.size(); ++i)
    undone += std::holds_alternative<Undone>(source->session->entries[i]) ? 1U : 0U;
  CHECK(undone == 1);
  // The state after redoing is the one before undoing, and so is its picture.
  CHECK(read->frames[kMoves].document == read->frames[kMoves + 2].document);
  const auto frame = [&](std::size_t number) { return read_picture(studio.take() / frame_name(number)); };
  CHECK(frame(kMoves + 1).differences(frame(kMoves + 3), 2) == 0);
  CHECK(frame(kMoves + 1).differences(frame(kMoves + 2), 30) > 0);
  CHECK(frame(kChanges).differences(shown, 60) < 40);
  for (std::size_t i = 1; i <= kMoves; ++i) CHECK(frame(i).differences(frame(i + 1), 30) > 0);
}

TEST_CASE("the key ends the recording right after a gesture, with all its frames, and during one") {
  Studio studio;
  const VirtualScreen& screen = studio.screen;
  constexpr std::size_t kMoves = 8;
  studio.press("s");
  screen.drag({300, 100}, {300, 700}, kMoves);
  screen.xdotool("mouseup 1 key F4");
  REQUIRE(eventually([&] { return studio.is_complete(); }));
  CHECK(studio.frames() == 1 + kMoves);
  CHECK(studio.all_are_whole());
  const fs::path first = studio.take();

  // Another one begins in the middle of a gesture, and ends there.
  screen.drag({400, 100}, {400, 400}, 4);
  studio.press("F4");
  fs::path second;
  REQUIRE(eventually([&] {
    for (const auto& entry : fs::directory_iterator(studio.folder / "mesecina"))
      if (entry.is_directory() && entry.path() != first) second = entry.path();
    return !second.empty();
  }));
  for (int y = 450; y <= 600; y += 50) screen.xdotool("mousemove 400 " + std::to_string(y));
  studio.press("F4");
  REQUIRE(eventually([&] {
    const auto read = read_take(second);
    return read && read->complete;
  }));
  CHECK(read_take(second)->frames.size() == 4);
  screen.xdotool("mouseup 1");
  // Its session has the gesture, as far as it went.
  const auto source = read_sample_file(second / kManifestName);
  REQUIRE(source);
  REQUIRE(source->session);
}

TEST_CASE("the key ends and begins a recording while Ctrl is held for a lasso") {
  Studio studio;
  const VirtualScreen& screen = studio.screen;
  const fs::path first = studio.take();
  studio.press("i");
  screen.xdotool("mousemove 200 200 click 1");
  REQUIRE(eventually([&] { return studio.frames() == 1; }));
  studio.press("v");
  screen.xdotool("keydown ctrl");
  screen.drag({300, 100}, {400, 300}, 4);
  studio.press("F4");
  CHECK(eventually([&] {
    const auto read = read_take(first);
    return read && read->complete;
  }));
  studio.press("F4");
  CHECK(eventually([&] {
    for (const auto& entry : fs::directory_iterator(studio.folder / "mesecina"))
      if (entry.is_directory() && entry.path() != first) return true;
    return false;
  }));
  screen.xdotool("mouseup 1 keyup ctrl");
}

TEST_CASE("the key that is pressed twice ends the recording at once") {
  Studio studio(300);
  const VirtualScreen& screen = studio.screen;
  const fs::path take = studio.take();
  studio.press("s");
  screen.drag({300, 100}, {300, 700}, 40);
  screen.xdotool("mouseup 1 key F4 key F4");
  REQUIRE(eventually([&] {
    const auto read = read_take(take);
    return read && read->complete;
  }));
  CHECK(read_take(take)->frames.size() <= 41);
}

TEST_CASE("a view is a frame where it comes to rest, and a snapshot is a picture of its own") {
  Studio studio;
  const VirtualScreen& screen = studio.screen;
  screen.xdotool("mousemove 640 400 mousedown 2");
  for (int i = 1; i <= 5; ++i) screen.xdotool("mousemove " + std::to_string(640 + 20 * i) + " 400");
  screen.xdotool("mouseup 2");
  REQUIRE(eventually([&] { return studio.frames() == 1; }));
  studio.press("F3");
  fs::path snapshot;
  REQUIRE(eventually([&] {
    for (const auto& entry : fs::directory_iterator(studio.folder / "mesecina"))
      if (entry.path().extension() == ".png" && entry.file_size() != 0) snapshot = entry.path();
    return !snapshot.empty();
  }));
  CHECK(read_picture(snapshot).differences(read_picture(studio.take() / frame_name(1)), 0) == 0);
  studio.press("ctrl+q");
  REQUIRE(eventually([&] { return !studio.program.is_running(); }));
  CHECK(studio.is_complete());
  CHECK(studio.frames() == 1);
}

TEST_CASE("a signal ends the take in order, and a kill leaves whole frames") {
  for (const int how : {SIGTERM, SIGKILL}) {
    Studio studio;
    studio.press("s");
    studio.screen.drag({100, 100}, {1200, 700}, 12);
    REQUIRE(eventually([&] { return studio.frames() >= 4; }));
    kill(studio.program.pid(), how);
    CHECK(studio.program.wait() == 128 + how);
    CHECK(studio.is_complete() == (how == SIGTERM));
    CHECK(studio.frames() >= 4);
    CHECK(studio.all_are_whole());
  }
}

TEST_CASE("a folder that goes away ends the recording with a message, and the window goes on") {
  Studio studio;
  studio.press("i");
  studio.screen.xdotool("mousemove 200 200 click 1");
  REQUIRE(eventually([&] { return studio.frames() == 1; }));
  fs::rename(studio.take(), studio.folder / "elsewhere");
  studio.screen.xdotool("mousemove 250 200 click 1");
  CHECK(eventually([&] { return studio.has_banner(); }));
  CHECK(studio.program.is_running());
  CHECK(read_take(studio.folder / "elsewhere")->frames.size() == 1);
  CHECK(read_picture(studio.folder / "elsewhere" / frame_name(1)).width() == 1280);
}
