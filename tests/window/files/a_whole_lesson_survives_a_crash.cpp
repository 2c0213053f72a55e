// SPDX-License-Identifier: GPL-3.0-or-later
// One long use of the window, as in a lesson: open, restack, restyle, keep as a bundle, evolve, record, crash,
// recover.
#include <signal.h>

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <optional>

#include "app/recording/take.h"
#include "core/document/document.h"
#include "core/io/bundle_file.h"
#include "core/io/session/session.h"
#include "tests/io/temporary_folder.h"
#include "tests/window/window_driver.h"

using namespace mes;
using namespace mes::test;
namespace fs = std::filesystem;

namespace {

constexpr int kCircleSamples = 64;
// Colours that nothing else in the window has: rows of the panel are found by their swatches.
constexpr Rgb kAxis{0xC8, 0x00, 0xC8};
constexpr Rgb kCurve{0x00, 0xC8, 0x64};
constexpr Rgb kFromPalette{0xF0, 0xE4, 0x42};  // yellow, on the popup of a style

auto is(Rgb wanted) {
  return [wanted](Color c) {
    return std::abs(c.r - wanted.r) < 3 && std::abs(c.g - wanted.g) < 3 && std::abs(c.b - wanted.b) < 3;
  };
}

Bundle plain_bundle() {
  const auto entry = [](std::string layer, Rgb color, double width) {
    return LayerConfiguration::Entry{std::move(layer), true, {.color = color, .line_width_px = width}};
  };
  return {"Plain", {{entry("curve", kCurve, 5.0), entry("medial-axis", kAxis, 5.0), entry("points", {}, 1.0)}, {}}};
}

std::optional<Session> session_in(const fs::path& file) {
  auto session = read_session(bytes_of(file), file.string());
  if (!session) return std::nullopt;
  return std::move(*session);
}

std::size_t place_of(const LayerConfiguration& layers, const std::string& id) {
  const auto found = std::ranges::find(layers.layers, id, &LayerConfiguration::Entry::layer);
  REQUIRE(found != layers.layers.end());
  return static_cast<std::size_t>(found - layers.layers.begin());
}

Document document_of(const Session& session) {
  DocumentReplay replay;
  REQUIRE(replay_session(session, replay, {}));
  return std::move(replay).take_document();
}

/// The program on a screen with a home of its own, and one bundle in it.
struct LessonHour {
  TemporaryFolder home;
  VirtualScreen screen;
  Child program;

  LessonHour() {
    std::ofstream out(home / "ellipse.poff");
    out << "POFF " << kCircleSamples << " 0 0\n";
    for (int i = 0; i < kCircleSamples; ++i)
      out << 200 * std::cos(2 * 3.14159265 * i / kCircleSamples) << ' '
          << 90 * std::sin(2 * 3.14159265 * i / kCircleSamples) << '\n';
    fs::create_directories(home / "data" / "mesecina");
    const Bundle bundle = plain_bundle();
    std::ofstream(bundles_file()) << write_bundles({&bundle, 1});
  }
  fs::path bundles_file() const { return home / "data" / "mesecina" / "bundles.json"; }
  fs::path operator/(const std::string& name) const { return home / name; }

  void start() {
    program = Child({MESECINA_BINARY},
                    {{"DISPLAY", screen.display()},
                     {"WAYLAND_DISPLAY", ""},
                     {"HOME", home.path().string()},
                     {"XDG_CONFIG_HOME", (home / "config").string()},
                     {"XDG_DATA_HOME", (home / "data").string()},
                     {"LIBGL_ALWAYS_SOFTWARE", "1"},
                     {"ASAN_OPTIONS", "detect_leaks=0"}},
                    home / "errors");
    REQUIRE(eventually([&] { return !title().empty() && corner().r > 0; }));
  }
  std::string title() const { return screen.title(); }
  /// Keys go to the canvas, or to the dialog that is open.
  void press(const std::string& keys) const { screen.xdotool("key " + keys); }
  void type(const std::string& text) const { screen.xdotool("type --delay 30 '" + text + "'"); }
  /// For keys that may be pressed again: the ones after a dialog can come before it is gone.
  void press_until(const std::string& keys, const std::function<bool()>& is_done) const {
    REQUIRE(eventually([&] {
      press(keys);
      screen.settled();
      return is_done();
    }));
  }
  void leave_panels() const { screen.xdotool("mousemove 500 30"); }
  /// Fields of text look once a frame which keys are down, so this one is held until it was seen.
  void enter(const std::function<bool()>& is_done) const {
    screen.xdotool("keydown Return");
    const bool done = eventually(is_done);
    screen.xdotool("keyup Return");
    REQUIRE(done);
  }
  PixelBox panel() const { return {939, 30, 1238, 770}; }
  PixelBox canvas() const { return {70, 30, 930, 720}; }
  PixelBox find(const PixelBox& where, Rgb color) const { return screen.shoot().box_of(where, is(color)); }
  bool shows(Rgb color) const { return !find(canvas(), color).is_empty(); }

  /// Of the canvas; black before the window shows anything.
  Color corner() const { return screen.shoot().at(20, 765); }
  /// A dialog darkens everything beside it.
  bool has_dialog() const {
    const int light = corner().r;
    return light > 0 && light < 252;
  }
  void enter_file(const std::string& keys, const fs::path& file) const {
    press(keys);
    REQUIRE(eventually([&] { return has_dialog(); }));
    screen.settled();
    type(file.string());
    enter([&] { return !has_dialog(); });
    screen.settled();
  }
  Session save_as_session(const std::string& name) const {
    enter_file("ctrl+shift+s", home / name);
    REQUIRE(eventually([&] { return fs::exists(home / name); }));
    const auto out = session_in(home / name);
    REQUIRE(out);
    return *out;
  }

  std::vector<FrameInfo> frames() const {
    std::error_code error;
    for (const auto& entry : fs::directory_iterator(home / "mesecina", error))
      if (const auto read = read_take(entry.path())) return read->frames;
    return {};
  }
  bool is_recording() const { return fs::exists(home / "mesecina"); }
  bool is_take_complete() const {
    std::error_code error;
    for (const auto& entry : fs::directory_iterator(home / "mesecina", error))
      if (const auto read = read_take(entry.path())) return read->complete;
    return false;
  }
  std::optional<Journaled> journal() const {
    std::error_code error;
    for (const auto& entry : fs::directory_iterator(home / "data" / "mesecina" / "autosave", error))
      if (auto read = read_journal(bytes_of(entry.path()), {})) return std::move(*read);
    return std::nullopt;
  }
};

}  // namespace

TEST_CASE("open, restack, restyle, bundle, evolve, record, crash and recover") {
  LessonHour lesson;
  const VirtualScreen& screen = lesson.screen;
  lesson.start();
  lesson.leave_panels();
  lesson.enter_file("ctrl+o", lesson / "ellipse.poff");
  INFO("errors: " << bytes_of(lesson / "errors"));
  REQUIRE(eventually([&] { return lesson.title().starts_with("ellipse.poff - Mesecina"); }));
  lesson.press_until("1", [&] { return lesson.shows(kAxis) && lesson.shows(kCurve); });

  // The row of the axis is dragged below that of the curve, by the names, left of the swatches.
  // Rows of the section "Shown"; the groups below it have the same rows again.
  const auto row = [&](Rgb color) { return lesson.find({1000, 30, 1238, 270}, color); };
  REQUIRE(eventually([&] { return !row(kAxis).is_empty() && !row(kCurve).is_empty(); }));
  REQUIRE(row(kAxis).bottom < row(kCurve).top + 8);
  const int names = row(kAxis).left - 120;
  const std::array<int, 2> target{names, row(kCurve).middle()[1] + 6};
  const Screenshot before_drag = screen.settled();
  screen.drag({names, row(kAxis).middle()[1]}, target, 8);
  // The line that says where the row would go.
  REQUIRE(eventually([&] { return screen.settled().differences(before_drag, 30) > 200; }));
  screen.xdotool("mouseup 1");
  REQUIRE(eventually([&] { return row(kAxis).top > row(kCurve).top; }));

  // Its colour, from the palette behind its swatch.
  const Screenshot without_popup = screen.settled();
  const PixelBox window{0, 0, 1280, 800};
  screen.click(row(kAxis).middle());
  PixelBox yellow;
  REQUIRE(eventually([&] {
    const Screenshot shot = screen.settled();
    yellow = shot.box_of(shot.box_of_changes(window, without_popup), is(kFromPalette));
    return yellow.right - yellow.left > 10 && yellow.bottom - yellow.top > 10;
  }));
  screen.click(yellow.middle());
  REQUIRE(eventually([&] { return lesson.shows(kFromPalette) && !lesson.shows(kAxis); }));
  screen.click({700, 12});  // closes the popup
  lesson.leave_panels();

  // Kept as a bundle; the digits go to and fro.
  const Screenshot before_name = screen.settled();
  lesson.press("ctrl+b");
  REQUIRE(eventually([&] { return screen.shoot().differences(before_name, 10) > 5000; }));
  screen.settled();
  lesson.type("Mine");
  lesson.enter([&] {
    const auto kept = read_bundle_file(lesson.bundles_file(), {});
    return kept && kept->bundles.size() == 2 && kept->bundles[1].name == "Mine";
  });
  lesson.press_until("1", [&] { return lesson.shows(kAxis) && !lesson.shows(kFromPalette); });
  lesson.press_until("2", [&] { return lesson.shows(kFromPalette) && !lesson.shows(kAxis); });

  // An evolution, recorded: two steps by the key, then played and stopped. Buttons of the strip lie side by side.
  const PixelBox below{60, 600, 930, 768};
  const Screenshot without_strip = screen.settled();
  lesson.press("e");
  PixelBox strip;
  REQUIRE(eventually([&] {
    strip = screen.settled().box_of_changes(below, without_strip);
    return strip.right - strip.left > 400;
  }));
  const auto button = [&](int number) {
    return std::array<int, 2>{strip.left + 248 + 23 * number, strip.middle()[1]};
  };
  constexpr int kStop = 3;
  constexpr int kPlay = 4;
  lesson.press("F4");
  REQUIRE(eventually([&] { return lesson.is_recording(); }));
  for (const std::size_t step : {1U, 2U}) {
    lesson.press("bracketright");
    REQUIRE(eventually([&] { return lesson.frames().size() == step; }));
  }
  screen.click(button(kPlay));
  REQUIRE(eventually([&] { return lesson.frames().size() >= 8; }));
  screen.click(button(kStop));
  lesson.leave_panels();
  lesson.press("F4");
  REQUIRE(eventually([&] { return lesson.is_take_complete(); }));
  const std::vector<FrameInfo> frames = lesson.frames();
  const auto name_of = [](std::size_t steps) {
    return "Smooth, " + std::to_string(steps) + (steps == 1 ? " step" : " steps");
  };
  for (std::size_t i = 0; i < frames.size(); ++i) CHECK(frames[i].what == name_of(i + 1));

  const Session before = lesson.save_as_session("before.json");
  REQUIRE(std::holds_alternative<TimelineEdit>(before.entries.back()));
  CHECK(std::get<TimelineEdit>(before.entries.back()).name == name_of(frames.size()));
  CHECK(place_of(before.layers, "medial-axis") + 1 == place_of(before.layers, "curve"));
  CHECK(before.layers.layers[place_of(before.layers, "medial-axis")].style.color == kFromPalette);
  CHECK(document_of(before).digest() == frames.back().document);

  // One more sample, which no file holds when the program is shot.
  lesson.press("i");
  screen.click({850, 80});
  REQUIRE(eventually([&] { return lesson.title().starts_with("* before.json"); }));
  REQUIRE(eventually([&] {
    const auto journal = lesson.journal();
    return journal && journal->unsaved_edits == 1;
  }));
  kill(lesson.program.pid(), SIGKILL);
  REQUIRE(lesson.program.wait() == 128 + SIGKILL);
  CHECK(bytes_of(lesson / "errors").empty());
  const Session left = lesson.journal()->session;

  lesson.start();
  REQUIRE(eventually([&] { return lesson.has_dialog(); }));
  const PixelBox question =
      screen.settled().box_of(window, [](Color c) { return c.r > 230 && c.g > 230 && c.b > 230; });
  screen.click({question.left + 80, question.bottom - 28});  // its first button
  REQUIRE(eventually([&] { return lesson.title().starts_with("* ") && lesson.shows(kFromPalette); }));
  CHECK_FALSE(lesson.shows(kAxis));
  const Session after = lesson.save_as_session("after.json");
  // The view is fitted to what it showed, and that is noted.
  REQUIRE(left.entries.size() > before.entries.size());
  CHECK(std::equal(before.entries.begin(), before.entries.end(), left.entries.begin()));
  REQUIRE(after.entries.size() >= left.entries.size());
  CHECK(std::equal(left.entries.begin(), left.entries.end(), after.entries.begin()));
  for (std::size_t i = left.entries.size(); i < after.entries.size(); ++i)
    CHECK(std::holds_alternative<ViewChanged>(after.entries[i]));
  CHECK(document_of(after).sample_count() == kCircleSamples + 1);
  CHECK(after.layers == before.layers);
  CHECK(after.settings == before.settings);
  CHECK(after.view.center().x == Approx(before.view.center().x).margin(1e-6));
  CHECK(after.view.center().y == Approx(before.view.center().y).margin(1e-6));

  // And what is brought back can be taken back.
  lesson.press("ctrl+z");
  REQUIRE(eventually([&] { return lesson.title().starts_with("* after.json"); }));
  lesson.press("ctrl+s");
  REQUIRE(eventually([&] { return lesson.title().starts_with("after.json"); }));
  const auto undone = session_in(lesson / "after.json");
  REQUIRE(undone);
  CHECK(document_of(*undone).digest() == document_of(before).digest());
  lesson.press("ctrl+q");
  REQUIRE(eventually([&] { return !lesson.program.is_running(); }));
  CHECK(lesson.program.wait() == 0);
  CHECK(bytes_of(lesson / "errors").empty());
}
