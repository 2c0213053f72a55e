// SPDX-License-Identifier: GPL-3.0-or-later
// History and timeline seen from outside of an editor: what is forgotten, what is put together, what is kept apart.
#include <array>
#include <catch2/catch.hpp>

#include "core/document/commands.h"
#include "core/document/timeline/history.h"
#include "core/document/timeline/timeline.h"

using namespace mes;

namespace {

struct RecordedDocument {
  Document document;
  History history;

  void perform(const Expected<DocumentDelta>& delta, const std::string& name = {}) {
    REQUIRE(delta.has_value());
    document.apply(*delta);
    history.record(*delta, name);
  }
  void insert(Vec2 p) { perform(insert_samples(document, std::array{p})); }
  DocumentDelta moved(SampleSlot slot, Vec2 to) const {
    return move_samples(document, std::array{std::pair{document.id(slot), to}}).value();
  }
  bool extend(const DocumentDelta& delta, const std::string& name) {
    document.apply(delta);
    return history.extend(delta, name);
  }
  void undo() {
    for (const DocumentDelta& delta : history.undo()) document.apply(delta);
  }
  void redo() {
    for (const DocumentDelta& delta : history.redo()) document.apply(delta);
  }
};

LayersChanged shown(const std::string& layer, bool visible) {
  return {{{layer, visible, {}}}, {}, {}};
}
History::Layers step_of(const std::string& layer, bool visible) {
  return {shown(layer, visible), shown(layer, !visible)};
}

}  // namespace

TEST_CASE("what was undone is gone after another edit, and after a gesture") {
  RecordedDocument desk;
  desk.insert({0, 0});
  desk.undo();
  desk.insert({1, 1});
  CHECK(desk.history.step_count() == 1);
  CHECK_FALSE(desk.history.can_redo());
  desk.undo();
  desk.history.begin_gesture("Draw");
  desk.insert({2, 2});
  desk.history.end_gesture();
  CHECK(desk.history.step_count() == 1);
  CHECK_FALSE(desk.history.can_redo());
  desk.undo();
  CHECK(desk.document.is_empty());
  // A gesture that only changed layers is a step as well.
  desk.history.begin_gesture("Look");
  REQUIRE(desk.history.join_layers(step_of("curve", true)));
  desk.history.end_gesture();
  CHECK(desk.history.step_count() == 1);
  CHECK_FALSE(desk.history.can_redo());
  CHECK(desk.history.undo_name() == "Look");
}

TEST_CASE("a revision is given to one state only") {
  RecordedDocument desk;
  desk.insert({0, 0});
  const std::uint64_t undone = desk.document.revision();
  desk.undo();
  CHECK(desk.document.revision() < undone);
  desk.insert({1, 1});
  CHECK(desk.document.revision() > undone);
}

TEST_CASE("a step is extended by a motion of the same things under the same name, while it is the newest") {
  RecordedDocument desk;
  desk.insert({0, 0});
  desk.insert({5, 5});
  desk.perform(desk.moved(SampleSlot(0), {1, 0}), "Nudge");
  CHECK(desk.extend(desk.moved(SampleSlot(0), {2, 0}), "Nudge"));
  const DocumentDelta onwards = desk.moved(SampleSlot(0), {3, 0});
  CHECK_FALSE(desk.history.extend(onwards, "Move"));
  CHECK_FALSE(desk.history.extend(desk.moved(SampleSlot(1), {6, 5}), "Nudge"));
  desk.undo();
  CHECK(desk.document.position(SampleSlot(0)) == Vec2{0, 0});
  // It starts where the document is, but the step it would extend is undone.
  CHECK_FALSE(desk.history.extend(desk.moved(SampleSlot(0), {4, 0}), "Nudge"));
  desk.redo();
  CHECK(desk.document.position(SampleSlot(0)) == Vec2{2, 0});
}

TEST_CASE("moves with a change of the curve between them stay apart, and the curve comes back") {
  RecordedDocument desk;
  desk.perform(insert_samples(desk.document, std::array{Vec2{0, 0}, Vec2{1, 0}, Vec2{0, 1}}));
  desk.history.begin_gesture("Arrange");
  desk.perform(desk.moved(SampleSlot(0), {0.5, 0}));
  const std::array<Vec2, 3> places{Vec2{0.25, 0}, Vec2{1, 0}, Vec2{0, 1}};
  const std::array<SampleData::Contour, 1> loop{SampleData::Contour{true, {0, 1, 2}}};
  desk.perform(arrange_samples(desk.document, places, loop));
  desk.perform(desk.moved(SampleSlot(0), {0.125, 0}));
  desk.history.end_gesture();
  CHECK(desk.document.curve_order()->contours.size() == 1);
  desk.undo();
  CHECK(desk.document.curve_order()->contours.empty());
  CHECK(desk.document.position(SampleSlot(0)) == Vec2{0, 0});
  desk.redo();
  CHECK(desk.document.curve_order()->contours.size() == 1);
  CHECK(desk.document.position(SampleSlot(0)) == Vec2{0.125, 0});
}

TEST_CASE("layers that were changed twice in a step come back in reverse, and redo goes forward") {
  RecordedDocument desk;
  desk.insert({0, 0});
  REQUIRE(desk.history.join_layers({shown("curve", true), shown("curve", false)}));
  LayersChanged bold = shown("curve", true);
  bold.changed.front().style.line_width_px = 9.0;
  REQUIRE(desk.history.join_layers({bold, shown("curve", true)}));
  LayerConfiguration layers{{bold.changed.front()}, {}};
  apply(*desk.history.layers_of_undo(), layers);
  CHECK_FALSE(layers.layers.front().visible);
  desk.undo();
  apply(*desk.history.layers_of_redo(), layers);
  CHECK(layers.layers.front() == bold.changed.front());
}

TEST_CASE("after a change of layers, edits that were undone are redone without their own") {
  RecordedDocument desk;
  desk.insert({0, 0});
  REQUIRE(desk.history.join_layers(step_of("curve", true)));
  desk.history.record_layers(step_of("voronoi", true), "Show voronoi");
  desk.undo();
  desk.undo();
  CHECK(desk.history.layers_of_redo() != nullptr);
  desk.history.record_layers(step_of("delaunay", true), "Show delaunay");
  CHECK(desk.history.step_count() == 2);
  CHECK(desk.history.redoes_edit());
  CHECK(desk.history.layers_of_redo() == nullptr);
}

TEST_CASE("a number limits others only while it is in the document") {
  Document document;
  const std::array large{Vec2{0x1p499, 0}};
  const std::array small{Vec2{0x1p380, 0}};
  document.apply(insert_samples(document, std::array{Vec2{0x1p499, 0}, Vec2{0x1p450, 0}}).value());
  REQUIRE_FALSE(insert_samples(document, small).has_value());
  document.apply(move_samples(document, std::array{std::pair{document.id(SampleSlot(0)), Vec2{0x1p440, 0}}}).value());
  CHECK(insert_samples(document, small).has_value());
  document.apply(insert_samples(document, large).value());
  REQUIRE_FALSE(insert_samples(document, small).has_value());
  document.apply(remove_samples(document, std::array{document.id(SampleSlot(2))}).value());
  CHECK(insert_samples(document, small).has_value());
}

TEST_CASE("the digest of a document does not depend on what was open before") {
  const SampleData data{{{1, 2}, {3, 4}}, {}, {{{5, 6}, 7}}};
  Document fresh;
  fresh.apply(replace_all(fresh, data).value());
  Document later;
  later.apply(replace_all(later, {{{9, 9}, {8, 8}, {7, 7}}, {}, {{{0, 0}, 1}, {{1, 1}, 1}}}).value());
  later.apply(replace_all(later, data).value());
  REQUIRE(later.id(SampleSlot(0)) != fresh.id(SampleSlot(0)));
  CHECK(later.digest() == fresh.digest());
}

namespace {

// More things than leave each move of the pointer on record.
constexpr std::size_t kMany = 5000;

struct NotedDesk {
  Document document;
  Timeline timeline;

  explicit NotedDesk(const SampleData& data) {
    document.apply(replace_all(document, data).value());
    timeline.restart(std::make_shared<const SampleData>(data));
  }
  void change(const DocumentChange& change) {
    const DocumentDelta delta = change_document(document, change).value();
    document.apply(delta);
    timeline.note_edit(document, delta, {}, false);
  }
  std::vector<std::pair<SampleId, Vec2>> all_moved(double x) const {
    std::vector<std::pair<SampleId, Vec2>> out;
    for (const SampleSlot slot : document.slots_in_input_order())
      out.emplace_back(document.id(slot), document.position(slot) + Vec2{x, 0});
    return out;
  }
  DocumentReplay replayed() const {
    DocumentReplay replay;
    REQUIRE(replay.begin(*timeline.data()));
    for (const TimelineEntry& entry : timeline.entries()) REQUIRE(replay.apply(entry));
    return replay;
  }
};

SampleData many_samples() {
  SampleData out;
  for (std::size_t i = 0; i < kMany; ++i) out.positions.push_back({static_cast<double>(i), 1.0});
  out.balls = {{{0, 0}, 1}, {{5, 5}, 1}};
  return out;
}

}  // namespace

TEST_CASE("in a large drag, moves of the same samples and balls are one entry, moves of others are not") {
  NotedDesk desk(many_samples());
  const auto ball = [&](BallSlot slot, double radius) {
    return std::vector{std::pair{desk.document.ball_id(slot), Disk{{1, 1}, radius}}};
  };
  desk.timeline.note_gesture_begun("Drag");
  desk.change({.moved = desk.all_moved(1.0), .changed_balls = ball(BallSlot(0), 2.0)});
  desk.change({.moved = desk.all_moved(1.0), .changed_balls = ball(BallSlot(0), 3.0)});
  CHECK(desk.timeline.entries().size() == 2);
  desk.change({.moved = desk.all_moved(1.0), .changed_balls = ball(BallSlot(1), 4.0)});
  CHECK(desk.timeline.entries().size() == 3);
  desk.timeline.note_gesture_ended();
  CHECK(desk.replayed().document().digest() == desk.document.digest());
}

TEST_CASE("each evolution has its own share of the timeline") {
  NotedDesk desk(many_samples());
  const std::size_t some = kMany / 2;  // few enough for every state to stay on record
  const auto go = [&](double x, bool replaces) {
    auto places = desk.all_moved(x);
    places.resize(some);
    const DocumentDelta delta = move_samples(desk.document, places).value();
    desk.document.apply(delta);
    desk.timeline.note_evolved(desk.document, delta, "Evolve", replaces, true);
    return desk.timeline.entries().size();
  };
  // Until the share is used up, each state is an entry; from then on the last one stands for those that follow.
  std::size_t entries = 0;
  bool is_full = false;
  for (int step = 0; step < 1000 && !is_full; ++step) {
    const std::size_t now = go(1.0, step > 0);
    is_full = now == entries;
    entries = now;
  }
  REQUIRE(is_full);
  REQUIRE(entries > 100);
  CHECK(go(1.0, false) == entries + 1);
  CHECK(go(1.0, true) == entries + 2);
  CHECK(go(1.0, true) == entries + 3);
}

TEST_CASE("the curve of an edit may name the samples that the edit inserts, and no others") {
  DocumentReplay replay;
  REQUIRE(replay.begin({{{0, 0}, {1, 0}}, {}, {}}));
  CHECK_FALSE(replay.apply(TimelineEdit{.inserted = {{0, 1}}, .curve = {{{true, {0, 1, 3}}}}}));
  REQUIRE(replay.apply(TimelineEdit{.inserted = {{0, 1}}, .curve = {{{true, {0, 1, 2}}}}}));
  CHECK(replay.document().curve_order()->contours.front().samples.back() == replay.document().id(SampleSlot(2)));
}
