// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <catch2/catch.hpp>
#include <cstdint>
#include <vector>

#include "app/playing/lesson_presenter.h"
#include "core/base/rng.h"
#include "core/builtins/builtins.h"
#include "tests/model/editing/random_editing.h"
#include "tests/support/builtin_layers.h"

using namespace mes;
using namespace mes::test;

namespace {

/// What a window has of a lesson.
struct PresentingRoom {
  Document seen;                    // as the engine would know it
  std::uint64_t last_revision = 0;  // that it was given
  LayerStack layers{layer_descriptors()};
  ComputationSettings settings{};
  Box2 view{};
  Editor editor{[this](const std::shared_ptr<const DocumentDelta>& delta) {
                  seen.apply(*delta);
                  last_revision = std::max(last_revision, delta->to_revision);
                },
                &layers};
  LessonPresenter presenter{{builtins(), editor, layers, [this] { return settings; },
                             [this](const ComputationSettings& wanted) { settings = wanted; },
                             [this](const Box2& box) { view = box; }}};
};

/// Samples, balls, curve order and annotations, whatever their ids.
void check_same(const SampleData& a, const SampleData& b) {
  CHECK(a.positions == b.positions);
  CHECK(a.contours == b.contours);
  CHECK(a.balls == b.balls);
  CHECK(a.annotations == b.annotations);
}

void play_to_the_end(LessonPresenter& presenter) {
  for (double now = 0.0; presenter.is_playing(); now += 1.0) REQUIRE(presenter.advance(now, true));
}

std::shared_ptr<Session> random_lesson(std::uint64_t seed, std::size_t edits) {
  Editor editor({});
  RandomEditing script(seed);
  REQUIRE(editor.load(script.data()));
  for (std::size_t i = 0; i < edits; ++i) {
    script.step(editor);
    if (i % 16 == 0) editor.note(SettingsChanged{.settings = {.precision = Precision::exact}});
  }
  if (editor.in_gesture()) editor.end_gesture();
  auto session = std::make_shared<Session>();
  session->title = "Random";
  session->data = editor.timeline().data();
  session->entries = editor.timeline().entries();
  Rng random(seed);
  for (int i = 0; i < 8; ++i)
    session->lesson.steps.push_back(
        {.caption = std::to_string(i), .position = random.below(session->entries.size() + 1)});
  session->lesson.steps.front().position = 0;
  session->lesson.steps[5].layers = {{{"points", true, {}}, {"curve", true, {}}}, {}};
  return session;
}

Session tidy_lesson() {
  Session session;
  session.title = "Three steps";
  session.data = std::make_shared<const SampleData>(SampleData{.positions = {{0, 0}, {1, 0}, {0, 1}}});
  session.entries = {TimelineEdit{.name = "Insert", .inserted = {{2, 2}}},
                     TimelineEdit{.name = "Insert", .inserted = {{3, 3}}},
                     TimelineEdit{.name = "Move", .moved = {{0, {0.5, 0.5}}}}};
  session.lesson.steps = {{.caption = "one"}, {.caption = "two", .position = 2}, {.caption = "three", .position = 3}};
  return session;
}

}  // namespace

TEST_CASE("a lesson shows each of its steps, and gives back what was there") {
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    INFO("seed " << seed);
    const auto session = random_lesson(seed, 120);
    LessonWalk walk(builtins(), *session);
    PresentingRoom room;
    RandomEditing script(seed + 100);
    REQUIRE(room.editor.load(script.data()));
    for (int i = 0; i < 40; ++i) script.step(room.editor);
    if (room.editor.in_gesture()) room.editor.end_gesture();
    room.layers.set_visible(find_layer("delaunay"), true);
    room.editor.note_layers();
    const SampleData before = data_of(room.editor.document());
    const LayerConfiguration layers = room.layers.configuration();
    const std::uint64_t revision = room.editor.document().revision();
    const TimelineLog entries = room.editor.timeline().entries();
    const bool was_modified = room.editor.is_modified();

    Rng random(seed);
    REQUIRE(room.presenter.start(session, 0));
    for (int i = 0; i < 40; ++i) {
      room.presenter.set_plays_edits(random.below(2) == 0);
      const std::size_t step =
          random.below(3) == 0 ? random.below(8) : std::min<std::size_t>(room.presenter.step() + 1, 7);
      REQUIRE(room.presenter.go_to(step));
      if (random.below(4) == 0 && room.presenter.is_playing()) {
        static_cast<void>(room.presenter.advance(i, true));
        script.step(room.editor);
        continue;
      }
      play_to_the_end(room.presenter);
      const auto scene = walk.scene(step);
      REQUIRE(scene);
      INFO("move " << i << " to step " << step);
      check_same(data_of(room.editor.document()), scene->data);
      CHECK(room.seen.digest() == room.editor.document().digest());
      CHECK(room.layers.configuration() == scene->layers.configuration());
      CHECK(room.settings == scene->settings);
      CHECK_FALSE(room.presenter.is_edited());
      CHECK_FALSE(room.editor.in_gesture());
      // What is kept in a picture of the moment is the moment.
      DocumentReplay replay;
      REQUIRE(replay.begin(*room.editor.timeline().data()));
      for (const TimelineEntry& entry : room.editor.timeline().entries()) REQUIRE(replay.apply(entry));
      replay.finish();
      check_same(data_of(replay.document()), scene->data);
      for (std::size_t k = random.below(5); k > 0; --k) script.step(room.editor);
    }
    room.presenter.end();

    CHECK_FALSE(room.presenter.is_running());
    check_same(data_of(room.editor.document()), before);
    CHECK(room.editor.document().revision() == revision);
    CHECK(room.seen.digest() == room.editor.document().digest());
    CHECK(room.layers.configuration() == layers);
    CHECK(room.editor.timeline().entries() == entries);
    CHECK(room.editor.is_modified() == was_modified);
    // What was put aside can be worked on, and no revision means two states.
    CHECK(room.editor.document().next_revision() > room.last_revision);
    for (int i = 0; i < 40; ++i) script.step(room.editor);
    if (room.editor.in_gesture()) room.editor.end_gesture();
    CHECK(room.seen.digest() == room.editor.document().digest());
    while (room.editor.can_undo()) room.editor.undo();
    CHECK(room.seen.digest() == room.editor.document().digest());
  }
}

TEST_CASE("samples that were edited in a lesson are given back, or kept") {
  PresentingRoom room;
  REQUIRE(room.editor.load({.positions = {{7, 7}}}));
  REQUIRE(room.presenter.start(std::make_shared<const Session>(tidy_lesson()), 0));
  room.presenter.set_plays_edits(false);
  const auto count = [&] { return room.editor.document().sample_count(); };
  const auto insert = [&] { REQUIRE(room.editor.insert(std::vector<Vec2>{{9, 9}}, "Insert")); };
  CHECK(count() == 3);
  insert();
  CHECK(room.presenter.is_edited());
  REQUIRE(room.presenter.go_on());
  CHECK(count() == 5);
  CHECK_FALSE(room.presenter.is_edited());

  insert();
  room.presenter.set_keeps_edits(true);
  REQUIRE(room.presenter.go_on());
  CHECK(room.presenter.caption() == "three");
  CHECK(count() == 6);
  CHECK(room.presenter.is_edited());
  REQUIRE(room.presenter.go_back());
  CHECK(count() == 6);
  REQUIRE(room.presenter.restore());
  CHECK(count() == 5);
  CHECK_FALSE(room.presenter.is_edited());
  room.presenter.end();
  CHECK(count() == 1);
  CHECK_FALSE(room.editor.can_undo());
}

TEST_CASE("the edits between two steps are played, one at a time, each with a picture") {
  PresentingRoom room;
  REQUIRE(room.presenter.start(std::make_shared<const Session>(tidy_lesson()), 0));
  REQUIRE(room.presenter.go_on());
  CHECK(room.presenter.caption() == "two");
  REQUIRE(room.presenter.is_playing());
  CHECK(room.editor.document().sample_count() == 3);
  CHECK_FALSE(room.presenter.advance(1.0, false));
  CHECK(room.presenter.advance(1.0, true));
  CHECK(room.editor.document().sample_count() == 4);
  CHECK_FALSE(room.presenter.advance(1.0, true));
  REQUIRE(room.presenter.next_due(1.0));
  CHECK(room.presenter.advance(1.0 + *room.presenter.next_due(1.0), true));
  CHECK(room.editor.document().sample_count() == 5);
  CHECK_FALSE(room.presenter.is_playing());
  CHECK_FALSE(room.presenter.next_due(2.0));

  // Going on while they are played leads to their end.
  REQUIRE(room.presenter.go_back());
  REQUIRE(room.presenter.go_on());
  REQUIRE(room.presenter.is_playing());
  REQUIRE(room.presenter.go_on());
  CHECK(room.presenter.step() == 1);
  CHECK(room.editor.document().sample_count() == 5);
}

TEST_CASE("a lesson that makes no sense is not begun") {
  PresentingRoom room;
  REQUIRE(room.editor.load({.positions = {{7, 7}}}));
  Session session = tidy_lesson();
  session.lesson.steps.clear();
  CHECK_FALSE(room.presenter.start(std::make_shared<const Session>(session), 0));
  session = tidy_lesson();
  session.entries.push_back(TimelineEdit{.removed = {42}});
  session.lesson.steps.push_back({.position = session.entries.size()});
  REQUIRE(room.presenter.start(std::make_shared<const Session>(session), 0));
  CHECK_FALSE(room.presenter.go_to(3));
  CHECK(room.presenter.step() == 0);
  CHECK(room.editor.document().sample_count() == 3);
  CHECK_FALSE(room.presenter.start(std::make_shared<const Session>(session), 3));
  CHECK_FALSE(room.presenter.is_running());
  CHECK(room.editor.document().sample_count() == 1);
  CHECK(room.editor.document().position(SampleSlot(0)) == Vec2{7, 7});
}
