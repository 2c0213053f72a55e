// SPDX-License-Identifier: GPL-3.0-or-later
// Annotations are edited, undone and put on the timeline like samples, and follow what they are on.
#include <array>
#include <catch2/catch.hpp>
#include <limits>
#include <vector>

#include "core/base/rng.h"
#include "core/document/commands.h"
#include "core/document/timeline/history.h"
#include "core/document/timeline/timeline.h"
#include "core/kernel/circumcircle.h"

using namespace mes;

namespace {

struct NotedDocument {
  Document document;
  History history;
  Timeline timeline;

  void perform(const Expected<DocumentDelta>& delta, const std::string& name = {}) {
    REQUIRE(delta.has_value());
    if (delta->is_empty()) return;
    timeline.note_edit(document, *delta, name, false);
    document.apply(*delta);
    history.record(*delta, name);
  }
  void insert(std::span<const Vec2> positions) { perform(insert_samples(document, positions)); }
  void move(std::uint32_t number, Vec2 to) { perform(move_samples(document, std::array{std::pair{id(number), to}})); }
  void insert_ball(const Disk& disk) { perform(insert_balls(document, std::array{disk})); }
  void change_ball(std::uint32_t number, const Disk& disk) {
    perform(change_balls(document, std::array{std::pair{ball(number), disk}}));
  }
  void remove_ball(std::uint32_t number) { perform(remove_balls(document, std::array{ball(number)})); }
  BallId ball(std::uint32_t number) const { return BallId{document.first_ball_id().value + number}; }
  void remove(std::uint32_t number) { perform(remove_samples(document, std::array{id(number)})); }
  SampleId id(std::uint32_t number) const { return SampleId{document.first_id().value + number}; }
  void undo() {
    if (history.can_undo()) timeline.note(Undone{});
    for (const DocumentDelta& delta : history.undo()) document.apply(delta);
  }
  void redo() {
    if (history.can_redo()) timeline.note(Redone{});
    for (const DocumentDelta& delta : history.redo()) document.apply(delta);
  }
};

Annotation note_on(std::vector<std::uint32_t> samples, Vec2 at = {}) {
  return {
      .kind = AnnotationKind::leader, .text = "here", .anchors = {{at, std::move(samples)}}, .shift = {10.0, -20.0}};
}

std::vector<Vec2> places(const Document& document) {
  std::vector<Vec2> out;
  for (const Annotation& annotation : *document.annotations())
    for (const Anchor& anchor : annotation.anchors) out.push_back(document.place_of(anchor));
  return out;
}

/// A triangle of these, the circle through them, and their first one.
Annotation highlight_on(std::uint32_t a, std::uint32_t b, std::uint32_t c) {
  const auto on = [](std::vector<std::uint32_t> samples) { return Anchor{.at = {}, .samples = std::move(samples)}; };
  return {.kind = AnnotationKind::highlight,
          .anchors = {on({a}), on({b}), on({c}), on({a, b, c}), on({a})},
          .elements = {{.kind = PrimitiveKind::triangle, .role = ProvenanceRole::itself},
                       {.kind = PrimitiveKind::circle, .role = ProvenanceRole::product, .radius = 1.0},
                       {.kind = PrimitiveKind::point, .role = ProvenanceRole::origin}}};
}

/// A segment between the centres of these balls, their crossings, the first circle, a place between the crossings.
Annotation highlight_on_balls(std::uint32_t a, std::uint32_t b, double scale = 1.0) {
  const auto on = [scale](std::vector<std::uint32_t> balls, double along = 0.0) {
    return Anchor{.at = {}, .samples = {}, .balls = std::move(balls), .along = along, .scale = scale};
  };
  return {.kind = AnnotationKind::highlight,
          .anchors = {on({a}), on({b}), on({a, b}), on({b, a}), on({a}), on({a, b, b, a}, 0.25)},
          .elements = {{.kind = PrimitiveKind::segment, .role = ProvenanceRole::itself},
                       {.kind = PrimitiveKind::segment, .role = ProvenanceRole::product},
                       {.kind = PrimitiveKind::circle, .role = ProvenanceRole::origin, .radius = 1.0},
                       {.kind = PrimitiveKind::point, .role = ProvenanceRole::product}}};
}

}  // namespace

TEST_CASE("anchors on balls are at centres, crossings, places of equal power, and between crossings") {
  NotedDocument desk;
  for (const Disk& disk : {Disk{{0, 0}, 5}, Disk{{6, 0}, 5}, Disk{{0, 8}, 1}}) desk.insert_ball(disk);
  const auto at = [&](std::vector<std::uint32_t> balls, double along = 0.0, double scale = 1.0) {
    return desk.document.place_of({.at = {77, 77}, .balls = std::move(balls), .along = along, .scale = scale});
  };
  CHECK(at({2}) == Vec2{0, 8});
  CHECK(at({0, 1}) == Vec2{3, 4});
  CHECK(at({1, 0}) == Vec2{3, -4});
  // Equal power to the first two on x = 3; to the first and the third: y = (64 + 25 - 1) / 16.
  CHECK(at({0, 1, 2}) == Vec2{3, 5.5});
  // On the line of the centres, half the distance of the crossings to the left of the way down.
  CHECK(at({0, 1, 1, 0}, 0.5) == Vec2{7, 0});
  CHECK(at({1, 0, 0, 1}, 0.5) == Vec2{-1, 0});
  // Circles that do not cross: where they are of equal power, on the line of the centres.
  CHECK(at({0, 1}, 0.0, 0.5) == Vec2{3, 0});
  CHECK(at({1, 0}, 0.0, 0.5) == Vec2{3, 0});
  CHECK(desk.document.radius_unit({.at = {}, .balls = {1}, .scale = 0.5}) == 2.5);
  CHECK(desk.document.radius_unit({.at = {}, .balls = {0, 1, 1, 0}}) == 4.0);
  CHECK(desk.document.radius_unit({.at = {1, 2}}) == 1.0);
  // Concentric circles have no crossing, three centres in line no place of equal power.
  desk.change_ball(1, {{0, 0}, 3});
  CHECK(at({0, 1}) == Vec2{77, 77});
  CHECK(at({0, 1, 2}) == Vec2{77, 77});
  // Further off and larger by a power of two, all is, to the last bit.
  desk.change_ball(0, {{0.3, 0.7}, 1.1});
  desk.change_ball(1, {{1.2, -0.1}, 0.9});
  const std::array before{at({0, 1}), at({0, 1, 2}), at({0, 1, 1, 2}, 0.3)};
  for (std::uint32_t i = 0; i < 3; ++i) {
    const Disk disk = desk.document.disk(desk.document.ball_slot_of(desk.ball(i)));
    desk.change_ball(i, {1024.0 * disk.center, 1024.0 * disk.radius});
  }
  CHECK(at({0, 1}) == 1024.0 * before[0]);
  CHECK(at({0, 1, 2}) == 1024.0 * before[1]);
  CHECK(at({0, 1, 1, 2}, 0.3) == 1024.0 * before[2]);
}

TEST_CASE("what is highlighted on balls goes with them, and comes back with them; words stay") {
  NotedDocument desk;
  desk.insert(std::array{Vec2{9, 9}});
  for (const Disk& disk : {Disk{{0, 0}, 5}, Disk{{6, 0}, 5}, Disk{{0, 8}, 1}}) desk.insert_ball(disk);
  const Annotation words{.kind = AnnotationKind::leader, .text = "here", .anchors = {{.at = {}, .balls = {1}}}};
  desk.perform(annotate(desk.document, {highlight_on_balls(0, 1), words, highlight_on_balls(2, 2), note_on({0})}));
  const Annotations before = *desk.document.annotations();
  desk.change_ball(1, {{6, 1}, 5});
  CHECK(places(desk.document)[1] == Vec2{6, 1});
  // A sample of the same number is another thing.
  desk.remove_ball(1);
  REQUIRE(desk.document.annotations()->size() == 4);
  const Annotation& left = desk.document.annotations()->front();
  REQUIRE(left.elements.size() == 1);
  CHECK(left.elements[0].kind == PrimitiveKind::circle);
  CHECK(left.anchors == std::vector<Anchor>{{.at = {}, .balls = {0}}});
  CHECK(desk.document.annotations()->at(1).anchors == std::vector<Anchor>{{.at = {6, 1}}});
  CHECK(desk.document.annotations()->at(2) == before[2]);
  CHECK(desk.document.annotations()->at(3) == before[3]);
  desk.remove_ball(0);
  CHECK(desk.document.annotations()->size() == 3);
  desk.undo();
  desk.undo();
  CHECK(*desk.document.annotations() == before);
  desk.redo();
  desk.redo();
  CHECK(desk.document.annotations()->size() == 3);
}

TEST_CASE("anchors that follow balls in a way that makes no sense are refused") {
  NotedDocument desk;
  desk.insert(std::array{Vec2{9, 9}});
  desk.insert_ball({{0, 0}, 5});
  const auto refused = [&](const Anchor& anchor) {
    return !annotate(desk.document, {{.kind = AnnotationKind::leader, .text = "a", .anchors = {anchor}}});
  };
  CHECK_FALSE(refused({.at = {}, .balls = {0}}));
  CHECK_FALSE(refused({.at = {}, .balls = {0, 0, 0, 0}, .along = -1.0, .scale = 2.0}));
  CHECK(refused({.at = {}, .balls = {1}}));
  CHECK(refused({.at = {}, .samples = {0}, .balls = {0}}));
  CHECK(refused({.at = {}, .balls = {0, 0, 0, 0, 0}}));
  CHECK(refused({.at = {}, .balls = {0}, .along = 1.0}));
  CHECK(refused({.at = {}, .samples = {0}, .scale = 2.0}));
  CHECK(refused({.at = {}, .balls = {0}, .scale = 0.0}));
  CHECK(refused({.at = {}, .balls = {0}, .scale = -1.0}));
  CHECK(refused({.at = {}, .balls = {0}, .scale = std::numeric_limits<double>::quiet_NaN()}));
  CHECK(refused({.at = {}, .balls = {0, 0, 0, 0}, .along = std::numeric_limits<double>::infinity()}));
}

TEST_CASE("what is highlighted goes with its samples, and comes back with them") {
  NotedDocument desk;
  desk.insert(std::array{Vec2{0, 0}, Vec2{4, 0}, Vec2{0, 4}, Vec2{5, 5}});
  Annotation fixed = highlight_on(0, 1, 2);
  for (Anchor& anchor : fixed.anchors) anchor = {.at = {1, 2}};
  desk.perform(annotate(desk.document, {highlight_on(0, 1, 2), note_on({1}), highlight_on(1, 2, 3), fixed}));
  const Annotations before = *desk.document.annotations();
  desk.remove(1);
  // Of the first one its own sample is left; the third one began with the sample that is gone.
  REQUIRE(desk.document.annotations()->size() == 3);
  const Annotation& left = desk.document.annotations()->front();
  REQUIRE(left.elements.size() == 1);
  CHECK(left.elements[0] == HighlightedElement{PrimitiveKind::point, ProvenanceRole::origin, 0.0});
  CHECK(left.anchors == std::vector<Anchor>{{.at = {}, .samples = {0}}});
  CHECK(desk.document.annotations()->at(1).kind == AnnotationKind::leader);
  CHECK(desk.document.annotations()->at(2) == fixed);
  const Annotations after = *desk.document.annotations();
  desk.remove(0);
  CHECK(desk.document.annotations()->size() == 2);
  desk.undo();
  CHECK(*desk.document.annotations() == after);
  desk.undo();
  CHECK(*desk.document.annotations() == before);
  desk.redo();
  CHECK(*desk.document.annotations() == after);
}

TEST_CASE("highlights that make no sense are refused") {
  NotedDocument desk;
  desk.insert(std::array{Vec2{0, 0}, Vec2{4, 0}, Vec2{0, 4}});
  const auto refused = [&](auto change) {
    Annotation one = highlight_on(0, 1, 2);
    change(one);
    return !annotate(desk.document, {one});
  };
  CHECK_FALSE(refused([](Annotation&) {}));
  CHECK(refused([](Annotation& one) { one.elements.clear(); }));
  CHECK(refused([](Annotation& one) { one.anchors.pop_back(); }));
  CHECK(refused([](Annotation& one) { one.anchors.push_back({}); }));
  CHECK(refused([](Annotation& one) { one.anchors[0].samples = {3}; }));
  CHECK(refused([](Annotation& one) { one.elements[0].radius = 1.0; }));
  CHECK(refused([](Annotation& one) { one.elements[1].radius = 0.0; }));
  CHECK(refused([](Annotation& one) { one.elements[1].radius = -1.0; }));
  CHECK(refused([](Annotation& one) { one.elements[1].radius = std::numeric_limits<double>::quiet_NaN(); }));
  CHECK(refused([](Annotation& one) { one.elements[1].radius = 1e300; }));
  CHECK(refused([](Annotation& one) { one.kind = AnnotationKind::text; }));
  CHECK(refused([](Annotation& one) {
    one.elements.assign(kMostHighlighted + 1, {});
    one.anchors.assign(kMostHighlighted + 1, {});
  }));
  CHECK_FALSE(refused([](Annotation& one) {
    one.elements.assign(kMostHighlighted, {});
    one.anchors.assign(kMostHighlighted, {});
  }));
}

TEST_CASE("an anchor follows its sample, and stays where that was removed") {
  NotedDocument desk;
  desk.insert(std::array{Vec2{0, 0}, Vec2{4, 0}, Vec2{0, 4}});
  desk.perform(annotate(desk.document, {note_on({1}, {4, 0}), note_on({0, 1, 2}, {2, 2}), note_on({}, {7, 8})}));
  CHECK(places(desk.document) == std::vector<Vec2>{{4, 0}, {2, 2}, {7, 8}});
  desk.move(1, {8, 0});
  CHECK(places(desk.document) == std::vector<Vec2>{{8, 0}, circumcircle({0, 0}, {8, 0}, {0, 4}).center, {7, 8}});
  const std::vector<Vec2> before = places(desk.document);
  desk.remove(1);
  CHECK(places(desk.document) == before);
  for (const Annotation& annotation : *desk.document.annotations()) CHECK(annotation.anchors[0].samples.empty());
  desk.undo();
  CHECK(places(desk.document) == before);
  desk.move(1, {6, 0});
  CHECK(places(desk.document)[0] == Vec2{6, 0});
  // Three samples on one line have no circle: the anchor is where it was put.
  desk.move(2, {3, 0});
  CHECK(places(desk.document)[1] == Vec2{2, 2});
}

TEST_CASE("undo, redo and the timeline bring annotations back, whatever happened to samples") {
  const int seed = GENERATE(range(1, 9));
  Rng rng(static_cast<std::uint64_t>(seed));
  NotedDocument desk;
  std::vector<Annotations> states{*desk.document.annotations()};
  std::vector<std::vector<Vec2>> place_states{places(desk.document)};
  const auto any = [&](std::size_t count) { return static_cast<std::uint32_t>(rng.below(count)); };
  const auto any_place = [&] { return Vec2{rng.uniform(-1.0, 1.0), rng.uniform(-1.0, 1.0)}; };
  desk.insert(std::array{Vec2{0, 0}, Vec2{4, 0}, Vec2{0, 4}, Vec2{1, 1}});
  desk.insert_ball({{0.5, 0.25}, 1.0});
  for (int twice = 0; twice < 2; ++twice) {
    states.push_back(*desk.document.annotations());
    place_states.push_back(places(desk.document));
  }
  for (int step = 0; step < 100; ++step) {
    const std::size_t before = desk.history.step_count();
    const std::uint32_t numbers = desk.document.next_id().value - desk.document.first_id().value;
    const std::uint32_t number = any(numbers);
    const bool is_alive = desk.document.slot_of(desk.id(number)) != kNoSlot;
    Annotations now = *desk.document.annotations();
    const std::uint32_t balls = desk.document.next_ball_id().value - desk.document.first_ball_id().value;
    const std::uint32_t ball = any(balls);
    const bool is_ball_alive = desk.document.ball_slot_of(desk.ball(ball)) != kNoSlot;
    switch (any(10)) {
      case 6: desk.insert_ball({any_place(), rng.uniform(0.5, 1.5)}); break;
      case 7:
        if (is_ball_alive) desk.change_ball(ball, {any_place(), rng.uniform(0.5, 1.5)});
        break;
      case 8:
        if (is_ball_alive) desk.remove_ball(ball);
        break;
      case 9:
        now.push_back(highlight_on_balls(ball, any(balls), rng.uniform(0.5, 1.5)));
        desk.perform(annotate(desk.document, now));
        break;
      case 0: desk.insert(std::array{any_place()}); break;
      case 1:
        if (is_alive) desk.move(number, any_place());
        break;
      case 2:
        if (is_alive) desk.remove(number);
        break;
      case 3:
        now.push_back(any(2) == 0 ? note_on({number}, any_place())
                                  : note_on({any(numbers), any(numbers), any(numbers)}, any_place()));
        desk.perform(annotate(desk.document, now));
        break;
      case 4:
        now.push_back(highlight_on(number, any(numbers), any(numbers)));
        desk.perform(annotate(desk.document, now));
        break;
      default:
        if (now.empty()) break;
        if (any(3) == 0)
          now.erase(now.begin());
        else
          now.back().shift = 10.0 * any_place();
        desk.perform(annotate(desk.document, now));
    }
    if (desk.history.step_count() == before) continue;
    states.push_back(*desk.document.annotations());
    place_states.push_back(places(desk.document));
  }
  REQUIRE(states.size() == desk.history.step_count() + 1);
  for (std::size_t i = states.size() - 1; i-- > 0;) {
    desk.undo();
    REQUIRE(*desk.document.annotations() == states[i]);
    REQUIRE(places(desk.document) == place_states[i]);
  }
  for (std::size_t i = 1; i < states.size(); ++i) {
    desk.redo();
    REQUIRE(*desk.document.annotations() == states[i]);
    REQUIRE(places(desk.document) == place_states[i]);
  }
  DocumentReplay replay;
  REQUIRE(replay.begin(*desk.timeline.data()));
  for (const TimelineEntry& entry : desk.timeline.entries()) REQUIRE(replay.apply(entry));
  CHECK(*replay.document().annotations() == states.back());
  CHECK(places(replay.document()) == place_states.back());

  // The data alone hold them too, with samples numbered anew.
  const SampleData data = data_of(desk.document);
  Document fresh;
  const auto all = replace_all(fresh, data);
  REQUIRE(all.has_value());
  fresh.apply(*all);
  CHECK(places(fresh) == place_states.back());
  CHECK(data_of(fresh).annotations == data.annotations);
}

TEST_CASE("an annotation being dragged is one step") {
  NotedDocument desk;
  desk.perform(annotate(desk.document, {note_on({}, {1, 1})}), "Annotate");
  desk.history.begin_gesture("Move annotation");
  for (int i = 1; i <= 20; ++i) {
    Annotations now = *desk.document.annotations();
    now[0].anchors[0].at = {static_cast<double>(i), 0.0};
    const auto delta = annotate(desk.document, now);
    REQUIRE(delta.has_value());
    desk.document.apply(*delta);
    desk.history.record(*delta);
  }
  desk.history.end_gesture();
  CHECK(desk.history.step_count() == 2);
  CHECK(desk.history.deltas_of_undo().size() == 1);
  for (const DocumentDelta& delta : desk.history.undo()) desk.document.apply(delta);
  CHECK(places(desk.document) == std::vector<Vec2>{{1, 1}});
  for (const DocumentDelta& delta : desk.history.redo()) desk.document.apply(delta);
  CHECK(places(desk.document) == std::vector<Vec2>{{20, 0}});
  // One more is another step, and so is what has another name.
  Annotations more = *desk.document.annotations();
  more.push_back(note_on({}, {2, 2}));
  const auto added = annotate(desk.document, more);
  REQUIRE(added.has_value());
  desk.document.apply(*added);
  CHECK_FALSE(desk.history.extend(*added, "Move annotation"));
  desk.history.record(*added, "Annotate");
  more.back().text = "there";
  const auto reworded = annotate(desk.document, more);
  REQUIRE(reworded.has_value());
  desk.document.apply(*reworded);
  CHECK_FALSE(desk.history.extend(*reworded, "Move annotation"));
  CHECK(desk.history.extend(*reworded, "Annotate"));
}

TEST_CASE("dragging one of many annotations does not fill the timeline") {
  for (const std::size_t count : {3U, 200U}) {
    NotedDocument desk;
    desk.perform(annotate(desk.document, Annotations(count, note_on({}, {1, 1}))), "Annotate");
    desk.timeline.note_gesture_begun("Move annotation");
    for (int i = 1; i <= 50; ++i) {
      Annotations now = *desk.document.annotations();
      now[0].anchors[0].at = {static_cast<double>(i), 0.0};
      desk.perform(annotate(desk.document, now));
    }
    desk.timeline.note_gesture_ended();
    // The step before, the beginning of the gesture, its moves, its end.
    CHECK(desk.timeline.entries().size() == (count == 3 ? 53 : 4));
    DocumentReplay replay;
    REQUIRE(replay.begin(*desk.timeline.data()));
    for (const TimelineEntry& entry : desk.timeline.entries()) REQUIRE(replay.apply(entry));
    CHECK(*replay.document().annotations() == *desk.document.annotations());
    CHECK(replay.history().step_count() == 2);
  }
}

TEST_CASE("dragging the words of a large highlight does not fill the timeline") {
  for (const std::size_t count : {3U, 2000U}) {
    NotedDocument desk;
    Annotation large{.kind = AnnotationKind::highlight};
    large.elements.assign(count, {PrimitiveKind::point, ProvenanceRole::origin});
    large.anchors.assign(count, {.at = {1, 1}});
    desk.perform(annotate(desk.document, {large}), "Annotate");
    desk.timeline.note_gesture_begun("Move annotation");
    for (int i = 1; i <= 50; ++i) {
      large.shift.x = i;
      desk.perform(annotate(desk.document, {large}));
    }
    desk.timeline.note_gesture_ended();
    CHECK(desk.timeline.entries().size() == (count == 3 ? 53 : 4));
    DocumentReplay replay;
    REQUIRE(replay.begin(*desk.timeline.data()));
    for (const TimelineEntry& entry : desk.timeline.entries()) REQUIRE(replay.apply(entry));
    CHECK(*replay.document().annotations() == *desk.document.annotations());
    CHECK(replay.history().step_count() == 2);
  }
}

TEST_CASE("what no document can hold is refused") {
  NotedDocument desk;
  desk.insert(std::array{Vec2{0, 0}, Vec2{4, 0}});
  const Annotation good = note_on({1}, {4, 0});
  const auto refused = [&](const Annotation& annotation) {
    const auto delta = annotate(desk.document, {good, annotation});
    return !delta.has_value() && !delta.error().text.empty();
  };
  CHECK_FALSE(refused(good));
  const auto with = [&](auto change) {
    Annotation out = good;
    change(out);
    return out;
  };
  CHECK(refused(with([](Annotation& a) { a.kind = AnnotationKind::arrow; })));
  CHECK(refused(with([](Annotation& a) { a.anchors.clear(); })));
  CHECK(refused(with([](Annotation& a) { a.anchors[0].samples = {2}; })));
  CHECK(refused(with([](Annotation& a) { a.anchors[0].samples = {0, 1}; })));
  CHECK(refused(with([](Annotation& a) { a.anchors[0].samples = {0, 1, 0, 1}; })));
  CHECK(refused(with([](Annotation& a) { a.anchors[0].at.x = std::numeric_limits<double>::quiet_NaN(); })));
  CHECK(refused(with([](Annotation& a) { a.anchors[0].at.y = 1e300; })));
  CHECK(refused(with([](Annotation& a) { a.letters = 0.0; })));
  CHECK(refused(with([](Annotation& a) { a.shift.x = std::numeric_limits<double>::infinity(); })));
  CHECK(refused(with([](Annotation& a) { a.text.assign(kMostAnnotationBytes + 1, 'x'); })));
  CHECK_FALSE(annotate(desk.document, Annotations(kMostAnnotations + 1, good)).has_value());
  SampleData data;
  data.annotations = {note_on({0})};
  CHECK_FALSE(replace_all(desk.document, data).has_value());
  data.positions = {{1, 1}};
  CHECK(replace_all(desk.document, data).has_value());
  // An edit of a file that names what never was.
  CHECK_FALSE(delta_of(desk.document, {.annotations = Annotations{note_on({7})}}).has_value());
  CHECK(delta_of(desk.document, {.inserted = {{9, 9}}, .annotations = Annotations{note_on({2})}}).has_value());
}
