// SPDX-License-Identifier: GPL-3.0-or-later
#include <catch2/catch.hpp>
#include <limits>
#include <random>

#include "core/document/commands.h"
#include "core/document/timeline/history.h"

using namespace mes;

namespace {

void do_step(Document& document, History& history, const Expected<DocumentDelta>& delta) {
  REQUIRE(delta.has_value());
  document.apply(*delta);
  history.record(*delta);
}

}  // namespace

TEST_CASE("undo to the start and redo to the end meet every document on the way, samples and balls mixed") {
  std::mt19937 random(7);
  Document document;
  History history;
  std::vector<std::uint64_t> digests{document.digest()};
  std::uniform_real_distribution<double> coordinate(-1, 1);
  const auto position = [&] { return Vec2{coordinate(random), coordinate(random)}; };
  const auto some_disk = [&] { return Disk{position(), random() % 6 == 0 ? 0.0 : std::abs(coordinate(random))}; };
  std::size_t most_balls = 0;
  for (int step = 0; step < 800; ++step) {
    const auto slots = document.slots_in_input_order();
    const auto ball_slots = document.ball_slots_in_input_order();
    const auto pick = [&] { return document.id(slots[random() % slots.size()]); };
    const auto pick_ball = [&] { return document.ball_id(ball_slots[random() % ball_slots.size()]); };
    switch (slots.empty() || ball_slots.empty() ? random() % 2 : random() % 8) {
      case 0: {
        std::vector<Vec2> points(1 + random() % 4);
        for (Vec2& p : points) p = position();
        do_step(document, history, insert_samples(document, points));
        break;
      }
      case 1: {
        std::vector<Disk> disks(1 + random() % 4);
        for (Disk& disk : disks) disk = some_disk();
        do_step(document, history, insert_balls(document, disks));
        break;
      }
      case 2: do_step(document, history, remove_samples(document, std::vector{pick()})); break;
      case 3: do_step(document, history, remove_balls(document, std::vector{pick_ball()})); break;
      case 4:
        do_step(
            document, history,
            change_document(document, {.removed = std::vector{pick()}, .removed_balls = std::vector{pick_ball()}}));
        break;
      case 5:
      case 6: {
        const SampleId id = pick();
        const BallId ball = pick_ball();
        const bool with_sample = random() % 2 == 0;
        history.begin_gesture("drag");
        for (int i = 0; i < 3; ++i) {
          const std::vector<std::pair<BallId, Disk>> changes{{ball, some_disk()}};
          std::vector<std::pair<SampleId, Vec2>> moves{{id, position()}};
          if (!with_sample) moves.clear();
          do_step(document, history, change_document(document, {.moved = moves, .changed_balls = changes}));
        }
        history.end_gesture();
        break;
      }
      default: {
        if (random() % 10 != 0) continue;
        SampleData data;
        data.positions = {{0, 0}, {1, 0}, {0, 1}};
        data.contours = {{true, {0, 1, 2}}};
        if (random() % 2 == 0) data.balls = {{{0, 0}, 1}, {{3, 4}, 0}};
        do_step(document, history, replace_all(document, data));
      }
    }
    most_balls = std::max(most_balls, document.ball_count());
    digests.push_back(document.digest());
  }
  REQUIRE(most_balls > 10);
  REQUIRE(history.step_count() == digests.size() - 1);
  for (std::size_t i = digests.size() - 1; i-- > 0;) {
    for (const auto& delta : history.undo()) document.apply(delta);
    REQUIRE(document.digest() == digests[i]);
  }
  REQUIRE(document.is_empty());
  REQUIRE_FALSE(history.can_undo());
  for (std::size_t i = 1; i < digests.size(); ++i) {
    for (const auto& delta : history.redo()) document.apply(delta);
    REQUIRE(document.digest() == digests[i]);
  }
  REQUIRE_FALSE(history.can_redo());
}

TEST_CASE("a drag of a thousand moves is one step with one delta") {
  Document document;
  History history;
  do_step(document, history, insert_samples(document, std::vector<Vec2>{{1, 2}}));
  const SampleId id = document.id(SampleSlot(0));
  history.begin_gesture("drag");
  for (int i = 0; i < 1000; ++i)
    do_step(document, history, move_samples(document, std::vector<std::pair<SampleId, Vec2>>{{id, {0.5 * i, 3}}}));
  history.end_gesture();
  REQUIRE(history.step_count() == 2);
  const auto deltas = history.undo();
  REQUIRE(deltas.size() == 1);
  REQUIRE(deltas[0].edits.size() == 1);
  document.apply(deltas[0]);
  REQUIRE(document.position(SampleSlot(0)) == Vec2{1, 2});
}

TEST_CASE("a long drag of samples and balls is one step with one delta") {
  Document document;
  History history;
  do_step(document, history, insert_samples(document, std::vector<Vec2>{{1, 2}}));
  do_step(document, history, insert_balls(document, std::vector<Disk>{{{5, 6}, 7}, {{8, 9}, 0}}));
  history.begin_gesture("drag");
  for (int i = 1; i <= 1000; ++i) {
    const std::vector<std::pair<SampleId, Vec2>> moves{{document.id(SampleSlot(0)), {0.5 * i, 3}}};
    const std::vector<std::pair<BallId, Disk>> changes{{document.ball_id(BallSlot(1)), {{0.25 * i, 1}, 2.0}},
                                                       {document.ball_id(BallSlot(0)), {{5, 6}, 0.125 * i}}};
    do_step(document, history, change_document(document, {.moved = moves, .changed_balls = changes}));
  }
  // Another ball than before begins a delta of its own.
  do_step(document, history,
          change_balls(document, std::vector<std::pair<BallId, Disk>>{{document.ball_id(BallSlot(0)), {{5, 6}, 1}}}));
  history.end_gesture();
  REQUIRE(history.step_count() == 3);
  REQUIRE(document.disk(BallSlot(0)) == Disk{{5, 6}, 1});
  const auto deltas = history.undo();
  REQUIRE(deltas.size() == 2);
  REQUIRE(deltas[1].edits.size() == 1);
  REQUIRE(deltas[1].ball_edits.size() == 2);
  for (const auto& delta : deltas) document.apply(delta);
  REQUIRE(document.position(SampleSlot(0)) == Vec2{1, 2});
  REQUIRE(document.disk(BallSlot(0)) == Disk{{5, 6}, 7});
  REQUIRE(document.disk(BallSlot(1)) == Disk{{8, 9}, 0});
}

TEST_CASE("the digest sees every number of a ball, and which ball has it") {
  const auto digest_of = [](std::vector<Disk> balls) {
    Document document;
    document.apply(replace_all(document, {.balls = std::move(balls)}).value());
    return document.digest();
  };
  const std::vector<Disk> balls{{{1, 2}, 3}, {{4, 5}, 6}};
  const std::uint64_t digest = digest_of(balls);
  CHECK(digest == digest_of(balls));
  CHECK(digest != digest_of({balls[1], balls[0]}));
  CHECK(digest != digest_of({balls[0]}));
  for (const std::size_t ball : {0U, 1U}) {
    auto larger = balls;
    larger[ball].radius += 1;
    CHECK(digest != digest_of(larger));
    for (double Vec2::*const coordinate : {&Vec2::x, &Vec2::y}) {
      auto other = balls;
      other[ball].center.*coordinate += 1;
      CHECK(digest != digest_of(other));
    }
  }
  // A ball of radius zero is no sample.
  Document document;
  document.apply(insert_samples(document, std::vector<Vec2>{{1, 2}}).value());
  CHECK(document.digest() != digest_of({{{1, 2}, 0}}));
}

TEST_CASE("commands of balls refuse what cannot be and change nothing") {
  Document document;
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const double inf = std::numeric_limits<double>::infinity();
  const auto says = [](const Expected<DocumentDelta>& delta) { return delta ? "" : delta.error().text; };
  for (const Disk& bad : {Disk{{nan, 0}, 1}, Disk{{0, inf}, 1}, Disk{{0, 0}, nan}, Disk{{0, 0}, inf}})
    CHECK_THAT(says(insert_balls(document, std::vector{Disk{}, bad})), Catch::Contains("not a finite number"));
  CHECK_THAT(says(insert_balls(document, std::vector{Disk{{0, 0}, -1e-300}})), Catch::Contains("radius is negative"));
  CHECK_THAT(says(replace_all(document, {.balls = {{{0, 0}, -1}}})), Catch::Contains("radius is negative"));
  REQUIRE(document.is_empty());

  document.apply(insert_balls(document, std::vector{Disk{{-0.0, 1}, -0.0}, Disk{{1, 1}, 2}}).value());
  REQUIRE(document.ball_count() == 2);
  CHECK_FALSE(std::signbit(document.disk(BallSlot(0)).center.x));
  CHECK_FALSE(std::signbit(document.disk(BallSlot(0)).radius));
  const BallId id = document.ball_id(BallSlot(0));
  CHECK_THAT(says(remove_balls(document, std::vector{BallId{99}})), Catch::Contains("ball 99 does not exist"));
  CHECK_THAT(says(remove_balls(document, std::vector{id, id})), Catch::Contains("named twice"));
  using Target = std::pair<BallId, Disk>;
  CHECK_THAT(says(change_balls(document, std::vector<Target>{{BallId{7}, {}}})), Catch::Contains("does not exist"));
  CHECK_THAT(says(change_balls(document, std::vector<Target>{{id, {}}, {id, {}}})), Catch::Contains("named twice"));
  CHECK_THAT(says(change_balls(document, std::vector<Target>{{id, {{0, 0}, -2}}})), Catch::Contains("negative"));
  CHECK_THAT(says(change_balls(document, std::vector<Target>{{id, {{0, inf}, 2}}})), Catch::Contains("finite"));
  CHECK(document.disk(BallSlot(0)) == Disk{{0, 1}, 0});
  CHECK(change_balls(document, std::vector<Target>{{id, {{0, 1}, 0}}}).value().is_empty());
}

TEST_CASE("the box of a document holds its disks, and stays finite") {
  Document document;
  document.apply(insert_balls(document, std::vector{Disk{{1, 2}, 3}, Disk{{0, 0}, 1}}).value());
  CHECK(document.bounding_box() == Box2{{-2, -1}, {4, 5}});
  document.apply(replace_all(document, {.balls = {{{0x1p499, 0}, 0x1.8p499}}}).value());
  CHECK(document.bounding_box() == Box2{{-0x1p498, -0x1.8p499}, {0x1.4p500, 0x1.8p499}});
}

TEST_CASE("commands refuse what cannot be and change nothing") {
  Document document;
  const double nan = std::numeric_limits<double>::quiet_NaN();
  REQUIRE_FALSE(insert_samples(document, std::vector<Vec2>{{0, nan}}).has_value());
  document.apply(*insert_samples(document, std::vector<Vec2>{{-0.0, 1}}));
  REQUIRE_FALSE(std::signbit(document.position(SampleSlot(0)).x));
  const SampleId id = document.id(SampleSlot(0));
  REQUIRE_FALSE(remove_samples(document, std::vector{SampleId{99}}).has_value());
  REQUIRE_FALSE(remove_samples(document, std::vector{id, id}).has_value());
  const double inf = std::numeric_limits<double>::infinity();
  REQUIRE_FALSE(move_samples(document, std::vector<std::pair<SampleId, Vec2>>{{id, {inf, 0}}}).has_value());
  REQUIRE_FALSE(replace_all(document, {{{0, 0}}, {{true, {1}}}}).has_value());
  REQUIRE(document.sample_count() == 1);
}

TEST_CASE("ids are never given twice, even when rows are used again") {
  Document document;
  document.apply(*insert_samples(document, std::vector<Vec2>{{0, 0}, {1, 0}}));
  const SampleId first = document.id(SampleSlot(0));
  document.apply(*remove_samples(document, std::vector{first}));
  document.apply(*insert_samples(document, std::vector<Vec2>{{2, 0}}));
  REQUIRE(document.slot_count() == 2);
  REQUIRE(document.id(SampleSlot(0)) != first);
  REQUIRE(document.slot_of(first) == kNoSlot);

  document.apply(*insert_balls(document, std::vector{Disk{}, Disk{{1, 1}, 1}}));
  const BallId ball = document.ball_id(BallSlot(0));
  document.apply(*remove_balls(document, std::vector{ball}));
  document.apply(*insert_balls(document, std::vector{Disk{{2, 2}, 2}}));
  REQUIRE(document.ball_slot_count() == 2);
  REQUIRE(document.ball_id(BallSlot(0)) != ball);
  REQUIRE(document.ball_slot_of(ball) == kNoSlot);
}
