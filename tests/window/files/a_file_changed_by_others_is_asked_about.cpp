// SPDX-License-Identifier: GPL-3.0-or-later
// Two windows on one session, of which the second is only what it leaves in the file.
#include <catch2/catch.hpp>
#include <filesystem>
#include <fstream>

#include "app/editing/editor.h"
#include "core/io/session/session.h"
#include "tests/io/temporary_folder.h"
#include "tests/window/window_driver.h"

using namespace mes;
using namespace mes::test;
namespace fs = std::filesystem;

namespace {

std::shared_ptr<const SampleData> data() {
  return std::make_shared<const SampleData>(SampleData{{{0, 0}, {4, 0}, {4, 3}, {0, 3}}, {}, {}});
}

/// What another window saves after some edits.
std::string session_with(int edits) {
  Editor editor({});
  REQUIRE(editor.load(*data()));
  for (int i = 0; i < edits; ++i) REQUIRE(editor.insert(std::array{Vec2{1.0 + i, 1}}, "Insert sample"));
  return write_session(
      {.title = "shared.json", .data = editor.timeline().data(), .entries = editor.timeline().entries()});
}

/// A window on the session, moved by one pixel, when another one has saved three edits.
struct Contest {
  TemporaryFolder home;
  VirtualScreen screen;
  fs::path file = home.write("shared.json", session_with(0));
  std::string theirs = session_with(3);
  Child program{{MESECINA_BINARY, file.string()},
                {{"DISPLAY", screen.display()},
                 {"WAYLAND_DISPLAY", ""},
                 {"HOME", home.path().string()},
                 {"XDG_CONFIG_HOME", (home / "config").string()},
                 {"XDG_DATA_HOME", (home / "data").string()},
                 {"LIBGL_ALWAYS_SOFTWARE", "1"},
                 {"ASAN_OPTIONS", "detect_leaks=0"}},
                home / "errors"};

  Contest() {
    REQUIRE(eventually([&] { return title().starts_with("shared.json - Mesecina") && corner().r > 0; }));
    screen.xdotool("mousemove 500 30");
    screen.xdotool("key ctrl+a");
    screen.xdotool("key Right");
    REQUIRE(eventually([&] { return title().starts_with("* shared.json"); }));
    home.write("shared.json", theirs);
  }
  std::string title() const { return screen.title(); }
  Color corner() const { return screen.shoot().at(20, 765); }
  bool has_dialog() const {
    const int light = corner().r;
    return light > 0 && light < 252;
  }
  void ask(const std::string& keys) const {
    screen.xdotool("key " + keys);
    REQUIRE(eventually([&] { return has_dialog(); }));
  }
  /// The buttons of a question lie side by side at its foot.
  void answer(int button) const {
    const PixelBox question =
        screen.settled().box_of({0, 0, 1280, 800}, [](Color c) { return c.r > 230 && c.g > 230 && c.b > 230; });
    screen.click({question.left + 80 + 128 * button, question.bottom - 28});
  }
  std::size_t samples_in_file() const {
    const auto session = read_session(bytes_of(file), "file");
    DocumentReplay replay;
    REQUIRE(session);
    REQUIRE(replay_session(*session, replay, "file"));
    return replay.document().sample_count();
  }
};

constexpr int kSaveAs = 0;
constexpr int kOverwrite = 1;

}  // namespace

TEST_CASE("a session that another window has saved is overwritten only by the answer to a question") {
  Contest contest;
  contest.ask("ctrl+s");
  contest.screen.xdotool("key Escape");
  REQUIRE(eventually([&] { return !contest.has_dialog(); }));
  CHECK(bytes_of(contest.file) == contest.theirs);
  CHECK(contest.title().starts_with("* shared.json"));

  contest.ask("ctrl+s");
  contest.answer(kOverwrite);
  REQUIRE(eventually([&] { return contest.title().starts_with("shared.json"); }));
  CHECK(contest.samples_in_file() == 4);
  REQUIRE(eventually([&] { return !contest.has_dialog(); }));

  // From now on it is the file of this window again.
  contest.screen.settled();
  contest.screen.xdotool("key Right");
  REQUIRE(eventually([&] { return contest.title().starts_with("* shared.json"); }));
  contest.screen.xdotool("key ctrl+s");
  REQUIRE(eventually([&] { return contest.title().starts_with("shared.json"); }));
  CHECK(bytes_of(contest.home / "errors").empty());
}

TEST_CASE("on the way out the work goes into another file, and the shared one stays") {
  Contest contest;
  contest.ask("ctrl+q");
  const auto answer_until_another_dialog = [&](int button) {
    const Screenshot question = contest.screen.settled();
    contest.answer(button);
    REQUIRE(eventually([&] { return contest.screen.settled().differences(question, 30) > 500; }));
  };
  answer_until_another_dialog(0);
  answer_until_another_dialog(kSaveAs);
  contest.screen.type_over((contest.home / "mine.json").string());
  contest.screen.xdotool("keydown Return");
  const bool is_gone = eventually([&] { return !contest.program.is_running(); });
  contest.screen.xdotool("keyup Return");
  REQUIRE(is_gone);
  CHECK(contest.program.wait() == 0);
  CHECK(fs::exists(contest.home / "mine.json"));
  CHECK(bytes_of(contest.file) == contest.theirs);
  CHECK(bytes_of(contest.home / "errors").empty());
}
