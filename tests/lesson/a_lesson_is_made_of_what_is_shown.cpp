// SPDX-License-Identifier: GPL-3.0-or-later
#include <array>
#include <catch2/catch.hpp>
#include <limits>
#include <string>
#include <vector>

#include "app/playing/lesson_editor.h"
#include "app/playing/lesson_presenter.h"
#include "core/base/rng.h"
#include "core/builtins/builtins.h"
#include "tests/model/editing/random_editing.h"
#include "tests/support/builtin_layers.h"

using namespace mes;
using namespace mes::test;

namespace {

struct LessonRoom {
  LayerStack layers{layer_descriptors()};
  ComputationSettings settings{};
  Box2 view{};
  Editor editor{{}, &layers};
  LessonEditor lesson_editor{editor, [this] { return LessonEditor::Look{layers.configuration(), settings, view}; }};
  Session session() const {
    const Timeline& timeline = editor.timeline();
    return {.data = timeline.data(), .entries = timeline.entries(), .lesson = timeline.lesson()};
  }
};

std::vector<bool> visible(const LayerStack& layers) {
  std::vector<bool> out;
  for (LayerIndex i = 0; i < layers.size(); ++i) out.push_back(layers.is_visible(i));
  return out;
}

/// "one, two" of the captions.
std::string captions(const LessonEditor& lesson_editor) {
  std::string out;
  for (const LessonStep& step : lesson_editor.lesson().steps) out += (out.empty() ? "" : " ") + step.caption;
  return out;
}

void mark(LessonEditor& lesson_editor, const std::string& caption) {
  lesson_editor.mark();
  lesson_editor.set_caption(caption);
}

}  // namespace

TEST_CASE("a marked step shows its moment, whatever was done since") {
  struct Moment {
    SampleData data;
    std::vector<bool> layers;
    ComputationSettings settings;
    Box2 view;
  };
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    INFO("seed " << seed);
    LessonRoom room;
    RandomEditing script(seed);
    REQUIRE(room.editor.load(script.data()));
    Rng random(seed);
    std::vector<Moment> moments;
    for (int i = 0; i < 12; ++i) {
      for (std::size_t k = random.below(12); k > 0; --k) script.step(room.editor);
      const auto layer = static_cast<LayerIndex>(random.below(room.layers.size()));
      room.layers.set_visible(layer, !room.layers.is_visible(layer));
      room.settings.precision = random.below(2) == 0 ? Precision::exact : Precision::fast;
      room.view.add(Vec2{random.uniform(), random.uniform()});
      CHECK(room.lesson_editor.can_mark() == !room.editor.in_gesture());
      if (room.editor.in_gesture()) room.editor.end_gesture();
      room.lesson_editor.mark();
      moments.push_back({data_of(room.editor.document()), visible(room.layers), room.settings, room.view});
    }
    for (int k = 0; k < 30; ++k) script.step(room.editor);
    if (room.editor.in_gesture()) room.editor.end_gesture();

    const auto read = read_session(write_session(room.session()), "lesson.json");
    REQUIRE(read);
    LessonWalk walk(builtins(), *read);
    REQUIRE(read->lesson.steps.size() == moments.size());
    for (std::size_t i = 0; i < moments.size(); ++i) {
      INFO("step " << i);
      const auto scene = walk.scene(i);
      REQUIRE(scene);
      CHECK(scene->data.positions == moments[i].data.positions);
      CHECK(scene->data.contours == moments[i].data.contours);
      CHECK(scene->data.balls == moments[i].data.balls);
      CHECK(visible(scene->layers) == moments[i].layers);
      CHECK(scene->settings == moments[i].settings);
      CHECK(scene->view == moments[i].view);
    }
  }
}

TEST_CASE("steps are put in order, written and removed, and each change is taken back") {
  LessonRoom room;
  REQUIRE(room.editor.load({.positions = {{0, 0}}}));
  LessonEditor& lesson_editor = room.lesson_editor;
  CHECK_FALSE(lesson_editor.chosen());
  CHECK_FALSE(lesson_editor.can_take_back());
  mark(lesson_editor, "one");
  mark(lesson_editor, "two");
  mark(lesson_editor, "three");
  CHECK(captions(lesson_editor) == "one two three");
  CHECK(room.editor.is_modified());
  lesson_editor.choose(0);
  mark(lesson_editor, "new");
  CHECK(captions(lesson_editor) == "one new two three");
  CHECK(lesson_editor.chosen() == 1U);
  CHECK(lesson_editor.can_move(2));
  CHECK_FALSE(lesson_editor.can_move(3));
  CHECK_FALSE(lesson_editor.can_move(-2));
  lesson_editor.move(2);
  CHECK(captions(lesson_editor) == "one two three new");
  lesson_editor.move(-3);
  CHECK(captions(lesson_editor) == "new one two three");
  CHECK(lesson_editor.chosen() == 0U);
  lesson_editor.remove();
  CHECK(captions(lesson_editor) == "one two three");
  lesson_editor.take_back();
  CHECK(captions(lesson_editor) == "new one two three");
  lesson_editor.set_seconds(7.5);
  CHECK(lesson_editor.lesson().steps.front().seconds == 7.5);
  lesson_editor.set_seconds(1e9);
  CHECK(lesson_editor.lesson().steps.front().seconds == kLongestLessonStep);
  lesson_editor.set_seconds(std::numeric_limits<double>::quiet_NaN());
  CHECK(lesson_editor.lesson().steps.front().seconds == kLongestLessonStep);

  REQUIRE(room.editor.insert(std::array{Vec2{1, 1}}, "Insert"));
  lesson_editor.mark_again();
  CHECK(lesson_editor.lesson().steps.front().caption == "new");
  CHECK(lesson_editor.lesson().steps.front().seconds == kLongestLessonStep);
  CHECK(lesson_editor.lesson().steps.front().position > lesson_editor.lesson().steps[1].position);
  while (lesson_editor.can_take_back()) lesson_editor.take_back();
  CHECK(captions(lesson_editor).empty());
  CHECK_FALSE(lesson_editor.chosen());
}

TEST_CASE("a lesson is unsaved until it is saved, and another document has another lesson") {
  LessonRoom room;
  REQUIRE(room.editor.load({.positions = {{0, 0}}}));
  CHECK_FALSE(room.editor.is_modified());
  mark(room.lesson_editor, "one");
  CHECK(room.editor.is_modified());
  room.editor.mark_saved();
  CHECK(room.editor.is_modified());
  room.editor.mark_lesson_saved(room.editor.timeline().lesson_revision());
  CHECK_FALSE(room.editor.is_modified());
  room.lesson_editor.set_caption("other");
  CHECK(room.editor.is_modified());
  // A change that changes nothing is none.
  room.editor.mark_lesson_saved(room.editor.timeline().lesson_revision());
  room.lesson_editor.set_caption("other");
  CHECK_FALSE(room.editor.is_modified());
  REQUIRE(room.editor.load({.positions = {{0, 0}}}));
  CHECK_FALSE(room.lesson_editor.chosen());
  CHECK_FALSE(room.lesson_editor.can_take_back());
  CHECK(room.lesson_editor.lesson().steps.empty());
}

TEST_CASE("a caption enters the lesson while it is typed, and is taken back as one change") {
  LessonRoom room;
  REQUIRE(room.editor.load({.positions = {{0, 0}}}));
  room.lesson_editor.mark();
  room.lesson_editor.set_caption("Before");
  const auto type = [&](const std::string& text) {
    for (std::size_t i = 1; i <= text.size(); ++i) {
      room.lesson_editor.type_caption(text.substr(0, i));
      REQUIRE(room.lesson_editor.lesson().steps[0].caption == text.substr(0, i));
    }
    room.lesson_editor.end_typing();
  };
  type("The crust");
  type("A crust");
  room.lesson_editor.type_title("T");
  room.lesson_editor.type_title("");
  room.lesson_editor.end_typing();
  room.lesson_editor.take_back();
  CHECK(room.lesson_editor.lesson().steps[0].caption == "The crust");
  room.lesson_editor.take_back();
  CHECK(room.lesson_editor.lesson().steps[0].caption == "Before");
}

TEST_CASE("lessons keep the bounds that their readers have") {
  LessonRoom room;
  REQUIRE(room.editor.load({.positions = {{0, 0}}}));
  for (std::size_t i = 0; i < kMostLessonSteps; ++i) {
    REQUIRE(room.lesson_editor.can_mark());
    room.lesson_editor.mark();
  }
  CHECK_FALSE(room.lesson_editor.can_mark());
  std::string letters;
  while (letters.size() < kLongestLessonCaption + 10) letters += "\xc3\xa9";
  room.lesson_editor.set_caption("x" + letters);
  room.lesson_editor.type_title("x" + letters);
  // No letter is cut: one byte less than the most.
  CHECK(room.lesson_editor.lesson().steps.back().caption.size() == kLongestLessonCaption - 1);
  CHECK(room.lesson_editor.lesson().title.size() == kLongestLessonTitle - 1);
  CHECK(read_session(write_session(room.session()), "lesson.json"));
}
