// SPDX-License-Identifier: GPL-3.0-or-later
#include <array>
#include <catch2/catch.hpp>
#include <vector>

#include "app/editing/editor.h"
#include "core/base/rng.h"
#include "tests/model/editing/random_editing.h"

using namespace mes;
using namespace mes::test;

namespace {

DocumentReplay replayed(const Timeline& timeline, const Document& before = {}) {
  DocumentReplay replay(before);
  REQUIRE(replay.begin(*timeline.data()));
  for (const TimelineEntry& entry : timeline.entries()) REQUIRE(replay.apply(entry));
  return replay;
}

bool same_source(const Document& a, const Document& b) {
  return (a.source() == nullptr) == (b.source() == nullptr) && (!a.source() || *a.source() == *b.source());
}

// Every state that undo and redo can reach, as differences of numbers: ids may begin elsewhere.
std::vector<std::vector<Vec2>> reachable_places(Editor& editor) {
  std::vector<std::vector<Vec2>> out;
  const auto look = [&] {
    auto& state = out.emplace_back();
    for (const SampleSlot slot : editor.document().slots_in_input_order())
      state.push_back(editor.document().position(slot));
    for (const BallSlot slot : editor.document().ball_slots_in_input_order()) {
      const Disk& disk = editor.document().disk(slot);
      state.push_back(disk.center);
      state.push_back({disk.radius, 0});
    }
    if (const auto& source = editor.document().source()) {
      state.push_back({static_cast<double>(source->first), static_cast<double>(source->count)});
      state.push_back(source->curves->curves[0].end());
    }
  };
  look();
  while (editor.can_undo()) {
    editor.undo();
    look();
  }
  while (editor.can_redo()) {
    editor.redo();
    look();
  }
  return out;
}

}  // namespace

TEST_CASE("replaying a timeline gives the document, its rows and its history") {
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    Editor editor({});
    RandomEditing script(seed);
    REQUIRE(editor.load(script.data()));
    for (int i = 0; i < 300; ++i) script.step(editor);
    if (editor.in_gesture()) editor.end_gesture();
    const Timeline& timeline = editor.timeline();

    DocumentReplay replay = replayed(timeline);
    CHECK(replay.document().digest() == editor.document().digest());
    CHECK(same_source(replay.document(), editor.document()));
    CHECK(replay.document().snapshot()->position == editor.document().snapshot()->position);
    CHECK(replay.document().snapshot()->free_slots == editor.document().snapshot()->free_slots);
    CHECK(replay.document().ball_snapshot()->disk == editor.document().ball_snapshot()->disk);

    // Into an editor that has seen other work, whose ids are therefore others.
    Document copy;
    Editor other([&copy](const std::shared_ptr<const DocumentDelta>& delta) { copy.apply(*delta); });
    REQUIRE(other.load({{{1, 2}, {3, 4}}, {}, {{{0, 0}, 1}}}));
    REQUIRE(other.insert(std::array{Vec2{9, 9}}, "insert"));
    other.restore(replayed(timeline, other.document()), timeline.data(), timeline.entries());
    CHECK_FALSE(other.is_modified());
    CHECK(copy.digest() == other.document().digest());
    CHECK(other.index().nearest(Vec2{0.3, 0.4}, 10.0) == editor.index().nearest(Vec2{0.3, 0.4}, 10.0));
    CHECK(other.document().digest() == editor.document().digest());
    CHECK(reachable_places(other) == reachable_places(editor));
    CHECK(copy.digest() == other.document().digest());
    // And once more: what is noted after a restore fits to what was before.
    for (int i = 0; i < 50; ++i) script.step(other);
    if (other.in_gesture()) other.end_gesture();
    const DocumentReplay again = replayed(other.timeline(), other.document());
    CHECK(again.document().snapshot()->position == other.document().snapshot()->position);
  }
}

TEST_CASE("a lesson stays with its timeline, and goes with it") {
  Editor editor([](const std::shared_ptr<const DocumentDelta>&) {});
  REQUIRE(editor.load({{{1, 2}, {3, 4}}, {}, {}}));
  REQUIRE(editor.insert(std::array{Vec2{9, 9}}, "insert"));
  const Lesson lesson{"One", {{.caption = "before", .position = 0}, {.caption = "after", .position = 1}}};
  const Timeline& timeline = editor.timeline();
  editor.restore(replayed(timeline, editor.document()), timeline.data(), timeline.entries(), lesson);
  REQUIRE(editor.insert(std::array{Vec2{8, 8}}, "insert"));
  editor.undo();
  CHECK(editor.timeline().lesson() == lesson);
  REQUIRE(editor.load({{{1, 2}}, {}, {}}));
  CHECK(editor.timeline().lesson() == Lesson{});
}

TEST_CASE("ten thousand actions of any kind are undone and redone to the same document") {
  Editor editor({});
  RandomEditing script(99);
  REQUIRE(editor.load(script.data()));
  const std::uint64_t start = editor.document().digest();
  for (int i = 0; i < 10'000; ++i) script.step(editor);
  if (editor.in_gesture()) editor.end_gesture();
  while (editor.can_redo()) editor.redo();
  const std::uint64_t end = editor.document().digest();
  CHECK(end != start);
  std::vector<std::uint64_t> states{end};
  while (editor.can_undo()) {
    editor.undo();
    states.push_back(editor.document().digest());
  }
  CHECK(states.size() > 1000);
  CHECK(editor.document().digest() == start);
  for (std::size_t i = states.size() - 1; i > 0; --i) {
    editor.redo();
    REQUIRE(editor.document().digest() == states[i - 1]);
  }
  CHECK_FALSE(editor.can_redo());
  CHECK(replayed(editor.timeline()).document().digest() == end);
}

TEST_CASE("a gesture that did nothing, or was taken back, leaves the timeline able to replay") {
  Editor editor({});
  REQUIRE(editor.load({{{0, 0}, {1, 0}}, {}}));
  editor.begin_gesture("Nothing");
  CHECK(editor.timeline().settled() == 0);
  editor.end_gesture();
  CHECK(editor.timeline().entries().empty());
  editor.begin_gesture("Drag");
  REQUIRE(editor.move(std::array{std::pair{editor.document().id(SampleSlot(0)), Vec2{5, 5}}}, "Drag"));
  editor.cancel_gesture();
  CHECK(replayed(editor.timeline()).document().position(SampleSlot(0)) == Vec2{0, 0});
  CHECK(replayed(editor.timeline()).history().position() == 0);
}

TEST_CASE("a gesture that did nothing and is cancelled takes nothing back") {
  Editor editor({});
  REQUIRE(editor.load({{{0, 0}}, {}}));
  REQUIRE(editor.insert(std::array{Vec2{1, 1}}, "Insert"));
  editor.begin_gesture("Drag");
  editor.cancel_gesture();
  CHECK(editor.document().sample_count() == 2);
  CHECK(editor.undo_name() == "Insert");
}

TEST_CASE("dragging very many samples does not put each move of the pointer on record") {
  Editor editor({});
  SampleData data;
  for (int i = 0; i < 5000; ++i) data.positions.push_back({i * 1.0, 0.5 * i});
  REQUIRE(editor.load(data));
  editor.selection().select_all(editor.document());
  editor.begin_gesture("Drag");
  for (int i = 0; i < 10; ++i) REQUIRE(editor.nudge_selection({1, 0}));
  editor.end_gesture();
  CHECK(editor.timeline().entries().size() == 3);
  CHECK(replayed(editor.timeline()).document().position(SampleSlot(7)) == editor.document().position(SampleSlot(7)));
}

TEST_CASE("entries that make no sense are refused and change nothing") {
  const SampleData data{{{0, 0}, {1, 0}}, {}, {{{0, 0}, 1}}};
  DocumentReplay replay;
  REQUIRE(replay.begin(data));
  const std::uint64_t digest = replay.document().digest();
  CHECK_FALSE(replay.apply(Undone{}));
  CHECK_FALSE(replay.apply(Redone{}));
  CHECK_FALSE(replay.apply(GestureEnded{}));
  CHECK_FALSE(replay.apply(TimelineEdit{.removed = {2}}));
  CHECK_FALSE(replay.apply(TimelineEdit{.removed = {0xffffffffU}}));
  CHECK_FALSE(replay.apply(TimelineEdit{.removed = {0}, .moved = {{1, {1, 1}}}}));
  CHECK_FALSE(replay.apply(TimelineEdit{.moved = {{0, {1, 1}}, {0, {2, 2}}}}));
  CHECK_FALSE(replay.apply(TimelineEdit{.changed_balls = {{0, {{0, 0}, -1}}}}));
  CHECK_FALSE(replay.apply(TimelineEdit{.inserted = {{1, 1}}, .curve = {{{true, {0, 1, 3}}}}}));
  CHECK(replay.document().digest() == digest);
  REQUIRE(replay.apply(GestureBegun{"A"}));
  CHECK_FALSE(replay.apply(GestureBegun{"B"}));
  CHECK_FALSE(replay.apply(Undone{}));
  REQUIRE(replay.apply(TimelineEdit{.moved = {{1, {4, 4}}}, .inserted = {{1, 1}}, .curve = {{{true, {0, 1, 2}}}}}));
  replay.finish();
  CHECK(replay.history().position() == 1);
  CHECK(replay.document().curve_order()->contours.size() == 1);
}

TEST_CASE("the difference of two configurations leads from one to the other") {
  LayerStyle bold;
  bold.line_width_px = 9;
  const LayerConfiguration a{{{"x", true, {}}, {"y", false, {}}, {"z", true, {}}}, {}};
  const LayerConfiguration b{{{"z", true, {}}, {"x", true, bold}, {"w", true, {}}}, {"p.png", {1, 1}, 2}};
  for (const auto& [from, to] : {std::pair{a, b}, std::pair{b, a}, std::pair{a, a}}) {
    LayerConfiguration moving = from;
    apply(difference(from, to), moving);
    CHECK(moving == to);
  }
  CHECK(difference(a, a).is_empty());
  LayerConfiguration c = a;
  c.layers[1].visible = true;
  CHECK(difference(a, c).changed.size() == 1);
  CHECK(difference(a, c).order.empty());
}
