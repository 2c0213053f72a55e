// SPDX-License-Identifier: GPL-3.0-or-later
// Steps of several deltas whose order matters: each delta stands on the one before, rows are freed and taken again.
#include <catch2/catch.hpp>

#include "core/base/rng.h"
#include "core/document/commands.h"
#include "core/document/timeline/history.h"

using namespace mes;

namespace {

// What can be seen of a document: what lives in which row, and which rows come next. A free row behind all others is
// as good as none.
struct State {
  std::vector<std::pair<SampleSlot, std::pair<SampleId, Vec2>>> samples;
  std::vector<std::pair<BallSlot, std::pair<BallId, Disk>>> balls;
  std::vector<SampleSlot> next_rows;
  std::vector<BallSlot> next_ball_rows;
  CurveOrder curve;
  friend bool operator==(const State&, const State&) = default;
};

State state_of(const Document& document) {
  State out;
  for (const SampleSlot slot : slots_below<SampleSlot>(document.slot_count()))
    if (document.is_alive(slot)) out.samples.push_back({slot, {document.id(slot), document.position(slot)}});
  for (const BallSlot slot : slots_below<BallSlot>(document.ball_slot_count()))
    if (document.is_ball_alive(slot)) out.balls.push_back({slot, {document.ball_id(slot), document.disk(slot)}});
  for (std::size_t i = 0; i < 50; ++i) {
    out.next_rows.push_back(document.slot_for_new_sample(i));
    out.next_ball_rows.push_back(document.slot_for_new_ball(i));
  }
  out.curve = *document.curve_order();
  return out;
}

// The sum over all samples and balls, computed anew.
std::uint64_t digest_from_scratch(const Document& document) {
  DocumentDelta everything;
  everything.to_revision = 1;
  everything.before = everything.after = document.snapshot();
  everything.balls_before = everything.balls_after = document.ball_snapshot();
  everything.curve_before = everything.curve_after = document.curve_order();
  Document copy;
  copy.apply(everything);
  return copy.digest();
}

struct UndoneDocument {
  Document document;
  History history;

  void perform(const Expected<DocumentDelta>& delta) {
    REQUIRE(delta.has_value());
    document.apply(*delta);
    history.record(*delta);
  }
  void undo() {
    for (const DocumentDelta& delta : history.undo()) document.apply(delta);
  }
  void redo() {
    for (const DocumentDelta& delta : history.redo()) document.apply(delta);
  }
};

void some_edit(UndoneDocument& desk, Rng& random) {
  const auto place = [&] { return Vec2{1.0 * static_cast<double>(random.below(9)), 0.5}; };
  std::vector<SampleId> samples;
  for (const SampleSlot slot : desk.document.slots_in_input_order()) samples.push_back(desk.document.id(slot));
  std::vector<BallId> balls;
  for (const BallSlot slot : desk.document.ball_slots_in_input_order()) balls.push_back(desk.document.ball_id(slot));
  const std::size_t some = samples.empty() ? 0 : random.below(samples.size());
  const std::size_t some_balls = balls.empty() ? 0 : random.below(balls.size());
  switch (random.below(6)) {
    case 0:
    case 1: return desk.perform(insert_samples(desk.document, std::vector{place(), place(), place()}));
    case 2: return desk.perform(insert_balls(desk.document, std::vector{Disk{place(), 1}, Disk{place(), 2}}));
    case 3: return desk.perform(remove_samples(desk.document, std::span(samples).first(some)));
    case 4: return desk.perform(remove_balls(desk.document, std::span(balls).first(some_balls)));
    default:
      if (samples.empty()) return;
      return desk.perform(move_samples(desk.document, std::vector{std::pair{samples[some], place()}}));
  }
}

}  // namespace

TEST_CASE("the deltas of a step, and the edits of a delta, are undone from the last to the first") {
  std::size_t most_deltas = 0;
  for (std::uint64_t seed = 1; seed <= 60; ++seed) {
    Rng random(seed);
    UndoneDocument desk;
    std::vector<State> states{state_of(desk.document)};
    while (states.size() < 12) {
      desk.history.begin_gesture("step");
      for (std::uint64_t n = 1 + random.below(5); n > 0; --n) some_edit(desk, random);
      desk.history.end_gesture();
      if (desk.history.step_count() == states.size()) states.push_back(state_of(desk.document));
    }
    // All the way back and forth, with turns on the way.
    std::size_t at = states.size() - 1;
    for (int move = 0; move < 80; ++move) {
      const bool back = at != 0 && (at + 1 == states.size() || random.below(2) == 0);
      if (back) {
        desk.undo();
        --at;
      } else {
        most_deltas = std::max(most_deltas, desk.history.redo().size());
        // Looking took the step: back to where it was, and then for good.
        static_cast<void>(desk.history.undo());
        desk.redo();
        ++at;
      }
      REQUIRE(state_of(desk.document) == states[at]);
      REQUIRE(desk.document.digest() == digest_from_scratch(desk.document));
    }
  }
  CHECK(most_deltas >= 4);
}

TEST_CASE("several deltas undone as one are undone from the last to the first") {
  UndoneDocument desk;
  desk.perform(insert_samples(desk.document, std::vector<Vec2>{{0, 0}, {1, 0}}));
  const State before = state_of(desk.document);
  desk.history.begin_gesture("step");
  desk.perform(insert_samples(desk.document, std::vector<Vec2>{{2, 0}, {3, 0}, {4, 0}}));
  desk.perform(
      remove_samples(desk.document, std::vector{desk.document.id(SampleSlot(0)), desk.document.id(SampleSlot(3))}));
  desk.perform(insert_samples(desk.document, std::vector<Vec2>{{5, 0}}));
  desk.perform(move_samples(desk.document, std::vector{std::pair{desk.document.id(SampleSlot(1)), Vec2{9, 9}}}));
  desk.history.end_gesture();
  const State after = state_of(desk.document);
  const std::vector<DocumentDelta> back = desk.history.undo();
  REQUIRE(back.size() == 4);
  const DocumentDelta as_one = one_after_the_other(back);
  desk.document.apply(as_one);
  CHECK(state_of(desk.document) == before);
  desk.document.apply(as_one.inverted());
  CHECK(state_of(desk.document) == after);
}
