// SPDX-License-Identifier: GPL-3.0-or-later
// Keys beside lists that are open, while words are typed, during gestures and after them.
#include <catch2/catch.hpp>
#include <string>

#include "core/io/session/session.h"
#include "tests/window/window_driver.h"

using namespace mes;
using namespace mes::test;

namespace {

constexpr PixelBox kStatus{0, 773, 700, 800};

/// A house with some of its samples where they are on the screen.
struct House {
  DrivenProgram window;
  Screenshot drawn{0, 0, {}};

  House() {
    window.folder.write("house.poff", kHouse);
    window.start("house.poff", {{"HOME", window.folder.path().string()}});
    drawn = window.drawn();
  }
  const VirtualScreen& screen() const { return window.screen; }
  Screenshot press(const std::string& keys) const {
    window.press(keys);
    return screen().settled();
  }
  /// The black dots of the samples, by their outermost ones.
  PixelBox samples() const {
    return drawn.box_of(kCanvas, [](Color c) { return c.r < 40 && c.g < 40 && c.b < 40; });
  }
  std::array<int, 2> lower_left() const { return {samples().left + 3, samples().bottom - 4}; }
  std::array<int, 2> lower_right() const { return {samples().right - 4, samples().bottom - 4}; }
  std::string saved_text(const std::string& name) const {
    window.save_as(name);
    return bytes_of(window.folder / name);
  }
};

}  // namespace

TEST_CASE("a key acts while a list is open, which it closes") {
  const House house;
  // The strip at the lower left of the canvas begins with the list of evolutions.
  constexpr std::array<int, 2> kList{120, 746};
  house.press("e");
  const auto open_list = [&] {
    const Screenshot before = house.screen().settled();
    house.screen().click(kList);
    const Screenshot after = house.screen().settled();
    REQUIRE(after.changes(kCanvas, before) > 3000);
    return after;
  };
  // What changes nothing of the document leaves the list open.
  const Screenshot list = open_list();
  CHECK(house.press("F3").changes({60, 40, 970, 700}, list) == 0);
  house.press("Escape");
  open_list();
  house.press("bracketright");
  CHECK(eventually([&] { return house.window.title().starts_with("* house.poff"); }));
  house.press("ctrl+z");
  CHECK(eventually([&] { return house.window.title().starts_with("house.poff"); }));
  open_list();
  house.press("ctrl+n");
  CHECK(eventually([&] { return house.window.title().starts_with("Untitled"); }));
}

TEST_CASE("a key that has nothing to do with words acts while they are typed, and keeps them") {
  const House house;
  house.press("a");
  house.screen().click({150, 120});
  static_cast<void>(house.screen().settled());
  house.screen().xdotool("type --delay 20 'sun v'");
  static_cast<void>(house.screen().settled());
  CHECK(house.saved_text("words.json").find("\"sun v\"") != std::string::npos);
}

TEST_CASE("the key of a tool that is pressed after a measurement was kept chooses the tool") {
  const House house;
  house.press("m");
  house.screen().click(house.lower_left());
  house.screen().click(house.lower_right());
  house.press("k");
  house.press("v");
  // The tool that moves samples is there, and no words are.
  house.screen().drag(house.lower_left(), {house.lower_left()[0] - 40, house.lower_left()[1]}, 4);
  house.screen().xdotool("mouseup 1");
  static_cast<void>(house.screen().settled());
  const auto session = read_session(house.saved_text("kept.json"), "kept.json");
  REQUIRE(session);
  bool is_moved = false;
  bool has_dimension = false;
  for (const TimelineEntry& entry : session->entries) {
    if (const auto* const gesture = std::get_if<GestureBegun>(&entry))
      is_moved = is_moved || gesture->name == "Move sample";
    if (const auto* const edit = std::get_if<TimelineEdit>(&entry); edit != nullptr && edit->annotations)
      for (const Annotation& annotation : *edit->annotations) {
        has_dimension = true;
        CHECK(annotation.text.empty());
      }
  }
  CHECK(is_moved);
  CHECK(has_dimension);
}

TEST_CASE("a key that does nothing during a gesture says so, and the gesture goes on") {
  const House house;
  const auto [x, y] = house.lower_left();
  house.screen().drag({x, y}, {x - 40, y}, 4);
  const Screenshot during = house.screen().settled();
  const Screenshot after = house.press("ctrl+o");
  CHECK(after.changes(kStatus, during) > 100);
  CHECK(after.changes(kCanvas, during) == 0);
  house.screen().xdotool("mouseup 1");
  CHECK(eventually([&] { return house.window.title().starts_with("* house.poff"); }));
}

TEST_CASE("Ctrl+Z after a change of the lesson says what takes it back") {
  const House house;
  house.press("ctrl+z");
  const Screenshot nothing = house.screen().settled();
  house.press("ctrl+k");
  house.screen().xdotool("type --delay 20 mark-step");
  static_cast<void>(house.screen().settled());
  house.press("Return");
  REQUIRE(eventually([&] { return house.window.title().starts_with("* house.poff"); }));
  CHECK(house.press("ctrl+z").changes(kStatus, nothing) > 100);
  CHECK(house.window.title().starts_with("* house.poff"));
}

TEST_CASE("Ctrl held for a lasso takes no key's action away") {
  const House house;
  house.screen().xdotool("mousemove 300 400");
  const Screenshot before = house.screen().settled();
  house.screen().xdotool("keydown ctrl");
  house.screen().drag({150, 200}, {300, 400}, 5);
  const Screenshot lasso = house.screen().settled();
  REQUIRE(lasso.changes(kCanvas, before) > 100);
  house.press("equal");  // Ctrl+=, which zooms the view as = does
  const Screenshot zoomed = house.screen().settled();
  CHECK(zoomed.changes(kCanvas, lasso) > 500);
  house.press("minus");
  CHECK(house.screen().settled().changes(kCanvas, lasso) < 100);
  house.press("Escape");
  house.screen().xdotool("mouseup 1 keyup ctrl");
  CHECK(house.screen().settled().changes(kCanvas, before) < 100);
}

TEST_CASE("a key that would change the document waits for a slider to be let go, and says so") {
  const House house;
  house.press("e");
  // The slider of the strip of evolutions; its beginning is the step 0.
  house.screen().drag({460, 744}, {520, 744}, 5);
  REQUIRE(eventually([&] { return house.window.title().starts_with("* house.poff"); }));
  const Screenshot held = house.screen().settled();
  const Screenshot refused = house.press("ctrl+z");
  CHECK(refused.changes(kStatus, held) > 100);
  CHECK(refused.changes(kCanvas, held) == 0);
  // A question over the window would dim it.
  CHECK(house.press("ctrl+n").is_white(90, 700));
  // Let go, the slider has its last value before the key acts.
  house.screen().xdotool("mouseup 1 key ctrl+z");
  CHECK(eventually([&] { return house.window.title().starts_with("house.poff"); }));
  static_cast<void>(house.screen().settled());
  CHECK(house.window.title().starts_with("house.poff"));
}

TEST_CASE("a key that does nothing says so without panels, until the next one") {
  const House house;
  house.press("Tab");
  const Screenshot bare = house.screen().settled();
  constexpr PixelBox kFoot{300, 740, 980, 795};
  REQUIRE(bare.changes(kStatus, house.drawn) > 100);
  const Screenshot told = house.press("ctrl+z");
  CHECK(told.changes(kFoot, bare) > 500);
  CHECK(house.press("v").changes(kFoot, bare) == 0);
  house.press("ctrl+z");
  house.screen().click({30, 30});
  CHECK(house.screen().settled().changes(kFoot, bare) == 0);
}

TEST_CASE("W held while dragging lets everything else wait") {
  const House house;
  const auto [x, y] = house.lower_left();
  house.screen().xdotool("mousemove " + std::to_string(x) + ' ' + std::to_string(y));
  house.screen().xdotool("keydown w");
  house.screen().drag({x, y}, {x - 60, y + 30}, 6);
  const Screenshot held = house.screen().settled();
  house.screen().xdotool("keyup w");
  const Screenshot released = house.screen().settled();
  CHECK(released.changes(kCanvas, held) > 500);
  house.screen().xdotool("mouseup 1");
  CHECK(house.screen().settled().changes(kCanvas, released) < 500);
}

TEST_CASE("a click on a v-point opens its card, and selects the sample that it lies on") {
  const House house;
  // "Union of balls 3: v-points" shows no samples.
  const Screenshot shown = house.press("8");
  REQUIRE(shown.changes(kCanvas, house.drawn) > 500);
  constexpr PixelBox kCard{60, 30, 460, 190};  // no samples are there
  house.screen().click(house.lower_right());
  REQUIRE(eventually([&] { return house.screen().shoot().changes(kCard, shown) > 2000; }));
  house.press("Delete");
  CHECK(eventually([&] { return house.window.title().starts_with("* house.poff"); }));
}

TEST_CASE("the card of a v-point offers what lies beneath it") {
  const House house;
  const Screenshot shown = house.press("8");
  constexpr PixelBox kCard{60, 30, 460, 190};  // no samples are there
  constexpr PixelBox kName{70, 38, 370, 60};
  house.screen().click(house.lower_right());
  REQUIRE(eventually([&] { return house.screen().shoot().changes(kCard, shown) > 2000; }));
  house.screen().xdotool("mousemove 1200 6");
  const Screenshot card = house.screen().settled();
  // The button is to the right of the one that selects the samples, in the last row.
  house.screen().click({290, 170});
  house.screen().xdotool("mousemove 1200 6");
  CHECK(eventually([&] { return house.screen().shoot().changes(kName, card) > 50; }));
}

TEST_CASE("samples that no layer shows are told of, and a button shows them") {
  const House house;
  const Screenshot axis = house.press("8");
  constexpr PixelBox kNote{100, 30, 960, 75};
  house.press("i");
  house.screen().click({500, 400});
  house.screen().xdotool("mousemove 1200 6");
  const Screenshot told = house.screen().settled();
  REQUIRE(told.changes(kNote, axis) > 1000);
  house.press("ctrl+z");
  CHECK(eventually([&] { return house.screen().shoot().changes(kNote, axis) == 0; }));
  house.press("ctrl+shift+z");
  REQUIRE(eventually([&] { return house.screen().shoot().changes(kNote, axis) > 1000; }));
  house.screen().click({628, 55});
  house.screen().xdotool("mousemove 1200 6");
  CHECK(eventually([&] { return house.screen().shoot().is_dark(500, 400); }));
  CHECK(eventually([&] { return house.screen().shoot().changes(kNote, told) > 1000; }));
}

TEST_CASE("balls and annotations that are hidden are told of, and buttons show them") {
  const House house;
  house.press("b");
  house.screen().drag({200, 200}, {240, 200}, 3);
  house.screen().xdotool("mouseup 1");
  static_cast<void>(house.screen().settled());
  // "Crust" shows no balls.
  const Screenshot crust = house.press("3");
  constexpr PixelBox kNote{100, 30, 960, 75};
  house.screen().drag({200, 500}, {240, 500}, 3);
  house.screen().xdotool("mouseup 1 mousemove 1200 6");
  CHECK(eventually([&] { return house.screen().settled().changes(kNote, crust) > 1000; }));
  house.press("ctrl+z");
  CHECK(eventually([&] { return house.screen().shoot().changes(kNote, crust) < 100; }));
  // The palette hides annotations, and the tool shows them as long as it is there.
  house.press("ctrl+k");
  house.screen().xdotool("type --delay 20 toggle-annotations");
  static_cast<void>(house.screen().settled());
  house.press("Return");
  house.press("a");
  house.screen().click({150, 120});
  static_cast<void>(house.screen().settled());
  house.screen().xdotool("type --delay 20 sun");
  house.press("Escape");
  house.screen().xdotool("mousemove 1200 6");
  const Screenshot written = house.screen().settled();
  CHECK(written.changes(kNote, crust) < 100);
  const Screenshot hidden = house.press("v");
  REQUIRE(hidden.changes(kNote, crust) > 1000);
  house.screen().click({660, 55});
  house.screen().xdotool("mousemove 1200 6");
  const Screenshot shown = house.screen().settled();
  CHECK(shown.changes(kNote, crust) < 100);
  constexpr PixelBox kWords{135, 100, 200, 140};
  CHECK(shown.changes(kWords, hidden) > 20);
}

TEST_CASE("menus are opened and gone through by keys alone") {
  const House house;
  house.screen().xdotool("mousemove 500 700");
  const Screenshot before = house.screen().settled();
  const Screenshot file = house.press("F10");
  CHECK(file.changes({0, 24, 130, 300}, before) > 3000);
  const Screenshot edit = house.press("Right");
  CHECK(edit.changes({130, 24, 400, 300}, file) > 1000);  // the menu is further to the right
  CHECK(house.press("Left").changes({0, 24, 420, 600}, file) < 300);
  house.press("Right");
  house.press("Down");  // marks Paste: there is nothing to undo and nothing selected
  house.press("Down");
  const Screenshot selected = house.press("Return");
  CHECK(selected.changes(house.samples(), before) > 100);
  // Esc closes a menu and leaves the selection; then keys are for the drawing again.
  house.press("F10");
  CHECK(house.press("Escape").changes(kCanvas, selected) == 0);
  house.press("Left");
  CHECK(eventually([&] { return house.window.title().starts_with("* house.poff"); }));
}

TEST_CASE("Delete in a list that was clicked deletes no samples") {
  const House house;
  house.screen().xdotool("mousemove 500 700");
  house.press("ctrl+a");
  house.screen().click({1010, 219});  // a row of the layers
  const Screenshot before = house.screen().settled();
  const Screenshot refused = house.press("Delete");
  CHECK(refused.changes(kStatus, before) > 100);
  CHECK(refused.changes(kCanvas, before) == 0);
  CHECK(house.window.title().starts_with("house.poff"));
  house.screen().xdotool("mousemove 500 700");
  static_cast<void>(house.screen().settled());
  house.press("Delete");
  CHECK(eventually([&] { return house.window.title().starts_with("* house.poff"); }));
}

TEST_CASE("arrow keys do not move samples while the pointer is on a panel that was clicked") {
  const House house;
  house.screen().xdotool("mousemove 500 700");
  house.press("ctrl+a");
  house.screen().click({1010, 219});  // a row of the layers
  const Screenshot before = house.screen().settled();
  const Screenshot refused = house.press("Left");
  CHECK(refused.changes(kStatus, before) > 100);
  CHECK(refused.changes(kCanvas, before) == 0);
  CHECK(house.window.title().starts_with("house.poff"));
  house.screen().xdotool("mousemove 500 700");
  static_cast<void>(house.screen().settled());
  house.press("Left");
  CHECK(eventually([&] { return house.window.title().starts_with("* house.poff"); }));
}
