// SPDX-License-Identifier: GPL-3.0-or-later
#include <catch2/catch.hpp>
#include <filesystem>
#include <string>

#include "core/io/session/session.h"
#include "tests/window/window_driver.h"

using namespace mes;
using namespace mes::test;

namespace {

/// A house, of which the second step has another corner, and the third step a taller roof.
std::string house_lesson() {
  Session session;
  session.data =
      std::make_shared<const SampleData>(SampleData{.positions = {{0, 0}, {4, 0}, {4, 3}, {2, 5}, {0, 3}}});
  session.entries = {TimelineEdit{.name = "Insert", .inserted = {{2, -1}}},
                     TimelineEdit{.name = "Move", .moved = {{3, {2, 5.5}}}},
                     TimelineEdit{.name = "Move", .moved = {{3, {2, 6}}}}};
  session.lesson = {.title = "House",
                    .steps = {{.caption = "# A house"},
                              {.caption = "# A sixth corner", .position = 1},
                              {.caption = "# A taller roof", .position = 3}}};
  return write_session(session);
}

struct PresentingWindow : DrivenProgram {
  PresentingWindow() {
    folder.write("house.json", house_lesson());
    start("house.json");
  }
  /// Edits that would be offered after a crash.
  std::size_t unsaved_edits() const {
    std::error_code error;
    std::size_t out = 0;
    for (const auto& entry : std::filesystem::directory_iterator(folder / "data" / "mesecina" / "autosave", error))
      if (const auto journal = read_journal(bytes_of(entry.path()), entry.path().string()))
        out += journal->unsaved_edits;
    return out;
  }
  /// The canvas beside the captions, once the panels are gone and nothing moves. Where lines meet, the one that was
  /// drawn last is on top, and that depends on what was edited before.
  bool shows_beside_caption(const Screenshot& look) const {
    constexpr int kJoints = 60;  // pixels
    return eventually([&] { return screen.settled().changes(kBeside, look) < kJoints; });
  }
  Screenshot other_beside_caption(const Screenshot& look) const {
    Screenshot out = look;
    constexpr int kEnough = 300;  // pixels
    REQUIRE(eventually([&] {
      out = screen.settled();
      return out.changes(kBeside, look) > kEnough;
    }));
    return out;
  }
  static constexpr PixelBox kBeside{400, 30, 1270, 700};
};

}  // namespace

TEST_CASE("a lesson is presented by the Page keys, and gives the document back with what was unsaved in it") {
  PresentingWindow window;
  const Screenshot before = window.drawn();
  window.press("i");
  window.screen.click({600, 420});
  REQUIRE(eventually([&] { return window.title().starts_with("* house.json"); }));
  const Screenshot edited = window.other_than(before);
  REQUIRE(eventually([&] { return window.unsaved_edits() > 0; }));
  const std::size_t unsaved = window.unsaved_edits();

  window.press("shift+F5");
  REQUIRE(eventually([&] { return window.screen.shoot().is_white(1270, 400); }));
  const Screenshot first = window.other_beside_caption(edited);
  window.press("Next");
  const Screenshot second = window.other_beside_caption(first);
  window.press("Next");
  const Screenshot third = window.other_beside_caption(second);
  window.press("Prior");
  CHECK(window.shows_beside_caption(second));
  // In the middle of it a sample is added: going on takes it back.
  window.screen.click({700, 300});
  static_cast<void>(window.other_beside_caption(second));
  window.press("Next");
  CHECK(window.shows_beside_caption(third));
  CHECK(window.unsaved_edits() == unsaved);

  window.press("Escape");
  CHECK(eventually([&] { return window.title().starts_with("* house.json"); }));
  CHECK_FALSE(window.screen.settled().is_white(1270, 700));
  window.press("ctrl+z");
  CHECK(eventually([&] { return window.title().starts_with("house.json"); }));
  CHECK(window.program.is_running());
}

TEST_CASE("a double click on a step presents the lesson from there") {
  PresentingWindow window;
  static_cast<void>(window.drawn());
  window.press("shift+F5");
  REQUIRE(eventually([&] { return window.screen.shoot().is_white(1270, 400); }));
  const Screenshot title = window.screen.settled();
  window.press("Next");
  const Screenshot first = window.other_beside_caption(title);
  window.press("Next");
  const Screenshot second = window.other_beside_caption(first);
  window.press("Escape");
  REQUIRE(eventually([&] { return !window.screen.settled().is_white(1270, 700); }));
  const Screenshot before = window.screen.settled();
  window.screen.click({1258, 436});
  REQUIRE(eventually([&] { return window.screen.settled().changes({960, 300, 1230, 770}, before) > 300; }));
  window.screen.xdotool("mousemove 1000 518 click --repeat 2 --delay 60 1");
  REQUIRE(eventually([&] { return window.screen.shoot().is_white(1270, 400); }));
  CHECK(window.shows_beside_caption(second));
  window.press("Escape");
  CHECK(eventually([&] { return !window.screen.settled().is_white(1270, 700); }));
}

TEST_CASE("a lesson begins with its title, and captions are large and below the drawing") {
  PresentingWindow window;
  static_cast<void>(window.drawn());
  window.press("shift+F5");
  REQUIRE(eventually([&] { return window.screen.shoot().is_white(1270, 400); }));
  const Screenshot title = window.screen.settled();
  const auto is_ink = [](Color c) { return c.r < 90 && c.g < 90 && c.b < 100; };
  const PixelBox words = title.box_of({0, 0, 1280, 450}, is_ink);
  CHECK(words.bottom - words.top > 40);
  CHECK(words.middle()[0] == Approx(640).margin(12));
  window.press("Next");
  const Screenshot first = window.other_beside_caption(title);
  const PixelBox caption = first.box_of({0, 700, 900, 800}, is_ink);
  CHECK(caption.bottom - caption.top > 20);
  CHECK(first.box_of({0, 0, 130, 690}, is_ink).is_empty());
  window.press("Prior");
  CHECK(window.shows_beside_caption(title));
  // Arrow keys do the same while nothing is selected.
  window.press("Right");
  CHECK(window.shows_beside_caption(first));
  window.press("Left");
  CHECK(window.shows_beside_caption(title));
}

TEST_CASE("--present begins with the title of the lesson, and a file without a lesson gets a message") {
  DrivenProgram window;
  window.folder.write("house.json", house_lesson());
  window.folder.write("house.poff", kHouse);
  const auto present = [&](const std::string& name) {
    window.options = {"--present"};
    window.start(name);
  };
  present("house.json");
  const auto is_ink = [](Color c) { return c.r < 90 && c.g < 90 && c.b < 100; };
  REQUIRE(eventually([&] { return window.screen.shoot().is_white(1270, 400); }));
  const PixelBox words = window.screen.settled().box_of({0, 0, 1280, 450}, is_ink);
  CHECK(words.bottom - words.top > 40);
  CHECK(words.middle()[0] == Approx(640).margin(12));
  present("house.poff");
  const Screenshot told = window.drawn();
  window.options = {};
  window.start("house.poff");
  // The message stands at the left of the bar at the bottom.
  CHECK(told.changes({0, 784, 300, 800}, window.drawn()) > 100);
}

TEST_CASE("a lesson is made in the window, is unsaved work, and goes into a session") {
  DrivenProgram window;
  window.folder.write("house.poff", "POFF 5 0 0\n0 0\n4 0\n4 3\n2 5\n0 3\n");
  window.start("house.poff");
  const Screenshot before = window.drawn();
  const auto mark = [&] {
    window.press("ctrl+shift+p");
    static_cast<void>(window.screen.settled());
    window.screen.xdotool("type 'mark a step'");
    static_cast<void>(window.screen.settled());
    window.press("Return");
    static_cast<void>(window.screen.settled());
  };
  mark();
  REQUIRE(eventually([&] { return window.title().starts_with("* house.poff"); }));
  window.press("2");
  const Screenshot other = window.other_than(before);
  window.press("i");
  window.screen.click({600, 420});
  static_cast<void>(window.other_than(other));
  mark();
  window.press("ctrl+z");
  window.press("ctrl+s");
  // The samples are those of the file again; what a file of samples cannot hold asks for a name of its own.
  static_cast<void>(window.screen.settled());
  window.save_as("made.json");
  const auto saved = read_session(bytes_of(window.folder / "made.json"), "made.json");
  REQUIRE(saved);
  REQUIRE(saved->lesson.steps.size() == 2);
  CHECK(saved->lesson.steps[0].layers != saved->lesson.steps[1].layers);
  CHECK(saved->lesson.steps[0].position < saved->lesson.steps[1].position);
  REQUIRE(eventually([&] { return window.title().starts_with("made.json"); }));
}

TEST_CASE("saving ends a lesson first, and saves the document") {
  const PresentingWindow window;
  const Screenshot before = window.drawn();
  window.press("i");
  window.screen.click({600, 420});
  REQUIRE(eventually([&] { return window.title().starts_with("* house.json"); }));
  static_cast<void>(window.other_than(before));
  window.press("shift+F5");
  REQUIRE(eventually([&] { return window.screen.shoot().is_white(1270, 400); }));
  static_cast<void>(window.screen.settled());
  window.press("Next");  // from the title to the first step
  static_cast<void>(window.screen.settled());
  window.screen.click({700, 300});
  REQUIRE(eventually([&] { return window.title().starts_with("* house.json"); }));
  window.press("ctrl+s");
  REQUIRE(eventually([&] { return window.title().starts_with("house.json"); }));
  const auto saved = read_session(bytes_of(window.folder / "house.json"), "house.json");
  REQUIRE(saved);
  CHECK(saved->lesson.steps.size() == 3);
  DocumentReplay replay;
  REQUIRE(replay_session(*saved, replay, "house.json"));
  // Five, the sixth of the lesson, and the one that was inserted before it was presented.
  CHECK(replay.document().sample_count() == 7);
}

TEST_CASE("what the steps of a lesson bring is not told of as something that was added") {
  PresentingWindow window;
  static_cast<void>(window.drawn());
  // "Union of balls 3: v-points" shows no samples.
  window.press("8");
  constexpr PixelBox kNote{100, 30, 960, 75};
  const Screenshot before = window.screen.settled();
  window.press("shift+F5");
  REQUIRE(eventually([&] { return window.screen.shoot().is_white(1270, 400); }));
  static_cast<void>(window.screen.settled());
  window.press("Escape");
  REQUIRE(eventually([&] { return !window.screen.shoot().is_white(1270, 400); }));
  CHECK(window.screen.settled().changes(kNote, before) < 100);
}

TEST_CASE("Esc ends the writing of a caption, and what was written stays") {
  const PresentingWindow window;
  const Screenshot before = window.drawn();
  window.press("ctrl+k");
  static_cast<void>(window.screen.settled());
  window.screen.xdotool("type --delay 20 'steps of the lesson'");
  static_cast<void>(window.screen.settled());
  window.press("Return");
  constexpr PixelBox kLowerPanel{940, 400, 1237, 770};
  REQUIRE(eventually([&] { return window.screen.settled().changes(kLowerPanel, before) > 1'000; }));
  constexpr std::array<int, 2> kFirstStep{1090, 501};
  constexpr std::array<int, 2> kCaption{1087, 690};
  const auto write = [&](const std::string& words) {
    window.screen.click(kCaption);
    static_cast<void>(window.screen.settled());
    window.press("ctrl+End");
    window.screen.xdotool("type --delay 20 '" + words + "'");
    static_cast<void>(window.screen.settled());
    window.press("Escape");
    static_cast<void>(window.screen.settled());
  };
  window.screen.click(kFirstStep);
  static_cast<void>(window.screen.settled());
  write(" with a roof");
  write(" and a door");
  window.save_as("kept.json");
  REQUIRE(eventually([&] { return std::filesystem::exists(window.folder / "kept.json"); }));
  CHECK_THAT(bytes_of(window.folder / "kept.json"), Catch::Contains("# A house with a roof and a door"));
}

TEST_CASE("a lesson is exported from the window, and Esc in its dialog leaves without a file") {
  const PresentingWindow window;
  const Screenshot before = window.drawn();
  const auto ask = [&] {
    window.press("ctrl+k");
    static_cast<void>(window.screen.settled());
    window.screen.xdotool("type --delay 20 'export the lesson'");
    static_cast<void>(window.screen.settled());
    window.press("Return");
    return window.screen.settled();
  };
  CHECK(ask().differences(before, 30) > 500);
  window.press("Escape");
  CHECK(window.shows(before));
  static_cast<void>(ask());
  window.screen.type_over((window.folder / "house.html").string());
  window.press("Return");
  REQUIRE(eventually([&] { return std::filesystem::exists(window.folder / "house.html"); }));
  const std::string page = bytes_of(window.folder / "house.html");
  CHECK(page.starts_with("<!DOCTYPE html>"));
  CHECK(page.find("A taller roof") != std::string::npos);
  CHECK_FALSE(std::filesystem::exists(window.folder / "house.pdf"));
  // The name is kept, whatever its ending.
  static_cast<void>(ask());
  window.screen.type_over((window.folder / "house.2.txt").string());
  window.press("Return");
  REQUIRE(eventually([&] { return std::filesystem::exists(window.folder / "house.2.txt.pdf"); }));
  CHECK(bytes_of(window.folder / "house.2.txt.pdf").starts_with("%PDF"));
  CHECK_FALSE(std::filesystem::exists(window.folder / "house.2.txt"));
}
