// SPDX-License-Identifier: GPL-3.0-or-later
#include <array>
#include <catch2/catch.hpp>
#include <cmath>

#include "app/editing/editor.h"
#include "core/base/rng.h"

using namespace mes;

namespace {

double nearest_distance(const Document& document, Vec2 p) {
  double best = std::numeric_limits<double>::infinity();
  for (const SampleSlot slot : slots_below<SampleSlot>(document.slot_count()))
    if (document.is_alive(slot)) best = std::min(best, distance(document.position(slot), p));
  return best;
}

std::vector<SampleSlot> rows_in(const Document& document, const Box2& box) {
  std::vector<SampleSlot> out;
  for (const SampleSlot slot : slots_below<SampleSlot>(document.slot_count()))
    if (document.is_alive(slot) && box.contains(document.position(slot))) out.push_back(slot);
  return out;
}

void compare(const Editor& editor, Rng& random, double extent) {
  const Document& document = editor.document();
  REQUIRE(editor.index().size() == document.sample_count());
  for (int i = 0; i < 12; ++i) {
    const Vec2 p{random.uniform(-1.5, 1.5) * extent, random.uniform(-1.5, 1.5) * extent};
    const double radius = extent * std::pow(10.0, random.uniform(-6.0, 2.0));
    const double expected = nearest_distance(document, p);
    const SampleSlot found = editor.index().nearest(p, radius);
    if (expected > radius) {
      REQUIRE(found == kNoSlot);
    } else {
      REQUIRE(found != kNoSlot);
      REQUIRE(document.is_alive(found));
      REQUIRE(distance(document.position(found), p) == expected);
    }
    Box2 box;
    box.add(p);
    box.add(p + Vec2{random.uniform(-1.0, 1.0) * radius, random.uniform(-1.0, 1.0) * radius});
    REQUIRE(editor.index().in_box(box) == rows_in(document, box));
  }
}

Vec2 random_point(Rng& random, int kind, double extent) {
  const double t = random.uniform(0.0, 6.28);
  switch (kind) {
    case 0: return {random.uniform(-1.0, 1.0) * extent, random.uniform(-1.0, 1.0) * extent};
    case 1: return {extent * std::cos(t), extent * std::sin(t)};
    case 2:
      return {std::floor(random.uniform(-4.0, 5.0)) * 0.25 * extent,
              std::floor(random.uniform(-4.0, 5.0)) * 0.25 * extent};
    default: return random.below(50) == 0 ? Vec2{1e12 * extent, -1e9 * extent} : Vec2{extent * std::cos(t), 0.0};
  }
}

}  // namespace

TEST_CASE("random edits, undo and redo: every answer is that of a search through all samples") {
  for (const double extent : {1.0, 1e-7, 1e9}) {
    for (int kind = 0; kind < 4; ++kind) {
      CAPTURE(extent, kind);
      Editor editor({});
      Rng random(static_cast<std::uint64_t>(kind) + 100);
      for (int step = 0; step < 150; ++step) {
        const Document& document = editor.document();
        const auto choice = random.below(10);
        const SampleSlot row(document.slot_count() == 0 ? 0 : random.below(document.slot_count()));
        if (choice < 5 || document.sample_count() == 0) {
          std::vector<Vec2> points(random.below(30) + 1);
          for (Vec2& p : points) p = random_point(random, kind, extent);
          REQUIRE(editor.insert(points, "insert"));
        } else if (choice < 7 && document.is_alive(row)) {
          const std::array target{std::pair{document.id(row), random_point(random, kind, extent)}};
          REQUIRE(editor.move(target, "move"));
        } else if (choice < 8) {
          std::vector<SampleId> ids;
          for (const SampleSlot slot : slots_below<SampleSlot>(document.slot_count()))
            if (document.is_alive(slot) && random.below(4) != 0) ids.push_back(document.id(slot));
          REQUIRE(editor.remove(ids, "remove"));
        } else if (choice == 8) {
          editor.undo();
        } else {
          editor.redo();
        }
        compare(editor, random, extent);
      }
    }
  }
}

TEST_CASE("an empty document and a nonsense question have no answer") {
  Editor editor({});
  CHECK(editor.index().nearest({0, 0}, 1e300) == kNoSlot);
  CHECK(editor.index().in_box({{-1, -1}, {1, 1}}).empty());
  REQUIRE(editor.insert(std::array{Vec2{1, 1}}, "insert"));
  CHECK(editor.index().nearest({std::nan(""), 0}, 1e300) == kNoSlot);
  CHECK(editor.index().nearest({0, 0}, -1.0) == kNoSlot);
  CHECK(editor.index().nearest({1, 1}, 0.0) == SampleSlot(0));
  CHECK(editor.index().in_box(Box2{}).empty());
}

TEST_CASE("the centres of balls are found as samples are, whatever becomes of their radii") {
  Editor editor({});
  Rng random(7);
  const Document& document = editor.document();
  const auto rows = [&] { return slots_below<BallSlot>(document.ball_slot_count()); };
  for (int step = 0; step < 200; ++step) {
    const auto choice = random.below(10);
    if (choice < 4 || document.ball_count() == 0) {
      std::vector<Disk> balls(random.below(20) + 1);
      for (Disk& ball : balls)
        ball = {random_point(random, static_cast<int>(random.below(3)), 1.0), random.uniform()};
      REQUIRE(editor.insert_balls(balls, "insert"));
    } else if (choice < 7) {
      const BallSlot row(random.below(document.ball_slot_count()));
      if (!document.is_ball_alive(row)) continue;
      const Vec2 place = random.below(2) == 0 ? document.disk(row).center : random_point(random, 2, 1.0);
      const std::array target{std::pair{document.ball_id(row), Disk{place, random.uniform()}}};
      REQUIRE(editor.move({}, target, "change"));
    } else if (choice == 7) {
      std::vector<BallId> ids;
      for (const BallSlot row : rows())
        if (document.is_ball_alive(row) && random.below(4) != 0) ids.push_back(document.ball_id(row));
      REQUIRE(editor.remove({}, ids, "remove"));
    } else if (choice == 8) {
      editor.undo();
    } else {
      editor.redo();
    }
    REQUIRE(editor.centers().size() == document.ball_count());
    for (int i = 0; i < 8; ++i) {
      // Places of the lattice as well, where many centres are.
      const Vec2 p = random_point(random, i % 2 == 0 ? 0 : 2, 1.0);
      const double radius = std::pow(10.0, random.uniform(-4.0, 1.0));
      BallSlot expected;
      for (const BallSlot row : rows())
        if (document.is_ball_alive(row) && distance(document.disk(row).center, p) <= radius &&
            (expected == kNoSlot ||
             distance(document.disk(row).center, p) <= distance(document.disk(expected).center, p)))
          expected = row;
      REQUIRE(editor.centers().nearest(p, radius) == expected);
    }
  }
}

TEST_CASE("a document made aside is taken over as it is, without a copy, and what was here is in it") {
  Rng random(77);
  const auto places = [&](std::size_t count) {
    std::vector<Vec2> out(count);
    for (Vec2& p : out) p = {random.uniform(-1.0, 1.0), random.uniform(-1.0, 1.0)};
    return out;
  };
  std::vector<std::shared_ptr<const DocumentDelta>> told;
  Editor editor([&](std::shared_ptr<const DocumentDelta> delta) { told.push_back(std::move(delta)); });
  REQUIRE(editor.load({.positions = places(300), .balls = {{{0, 0}, 1}}}));
  REQUIRE(editor.insert(places(5), "more"));
  const Document start = editor.document().successor();
  const auto data = std::make_shared<const SampleData>(SampleData{.positions = places(5000)});
  DocumentReplay replay(start);
  REQUIRE(replay.begin(*data));
  PreparedDocument next(std::move(replay), data);
  REQUIRE(editor.fits(start));
  const Vec2* const made = &next.document().positions()[SampleSlot{0}];
  const Vec2* const before = &editor.document().positions()[SampleSlot{0}];
  const std::uint64_t revision = editor.document().revision();
  editor.load(next);
  CHECK(&editor.document().positions()[SampleSlot{0}] == made);
  CHECK(&next.document().positions()[SampleSlot{0}] == before);
  CHECK(editor.timeline().data() == data);
  CHECK(editor.document().revision() > revision);
  CHECK_FALSE(editor.can_undo());
  CHECK(editor.document().ball_count() == 0);
  CHECK(editor.centers().size() == 0);
  REQUIRE(told.back()->replaces_all());
  CHECK(told.back()->from_revision == revision);
  CHECK(told.back()->to_revision == editor.document().revision());
  compare(editor, random, 1.0);
  REQUIRE(editor.insert(places(5000), "as many again"));
  compare(editor, random, 1.0);
  editor.undo();
  compare(editor, random, 1.0);
  CHECK_FALSE(editor.fits(start));
}

TEST_CASE("a document is taken over as long as the numbers left before it last") {
  const std::shared_ptr<const SampleData> data =
      std::make_shared<const SampleData>(SampleData{.positions = {{1, 2}, {3, 4}}, .balls = {{{0, 0}, 1}}});
  const auto insert = [](Editor& editor, std::size_t count) {
    REQUIRE(editor.insert(std::vector<Vec2>(count, {5, 6}), "more"));
  };
  Editor editor({});
  REQUIRE(editor.load(*data));
  const Document start = successor_of(editor.document(), {.revisions = 3, .ids = 10});
  for (const std::size_t count : {4U, 5U, 1U}) {
    insert(editor, count);
    CHECK(editor.fits(start));
  }
  DocumentReplay replay(start);
  REQUIRE(replay.begin(*data));
  PreparedDocument next(std::move(replay), data);
  const SampleId last{editor.document().next_id().value - 1};
  editor.load(next);
  CHECK(editor.document().sample_count() == 2);
  CHECK(editor.document().id(SampleSlot{0}) > last);

  const Document few_revisions = successor_of(editor.document(), {.revisions = 1, .ids = 10});
  const Document few_samples = successor_of(editor.document(), {.revisions = 10, .ids = 1});
  const Document many = successor_of(editor.document(), {.revisions = 10, .ids = 10});
  insert(editor, 1);
  CHECK(editor.fits(few_revisions));
  CHECK(editor.fits(few_samples));
  insert(editor, 1);
  CHECK_FALSE(editor.fits(few_revisions));
  CHECK_FALSE(editor.fits(few_samples));
  CHECK(editor.fits(many));
  REQUIRE(editor.insert_balls(std::vector<Disk>(11, Disk{{1, 1}, 1}), "balls"));
  CHECK_FALSE(editor.fits(many));
}

TEST_CASE("making a document aside can be stopped at each look, and says how far it is without going back") {
  SampleData data;
  for (int i = 0; i < 40'000; ++i) {
    data.positions.push_back({std::cos(0.001 * i), std::sin(0.001 * i)});
    data.balls.push_back({data.positions.back(), 0.5});
  }
  const auto shared = std::make_shared<const SampleData>(std::move(data));
  int stopped = 0;
  double before = 0.0;
  for (std::int64_t look = 1;; ++look) {
    DocumentReplay replay;
    REQUIRE(replay.begin(*shared));
    JobControl job;
    job.stop_at_look(look);
    try {
      const PreparedDocument made(std::move(replay), shared, {}, {}, &job);
      CHECK(made.document().sample_count() == 40'000);
      break;
    } catch (const Cancelled&) {
      ++stopped;
    }
    CHECK(job.progress() >= before);
    before = job.progress();
  }
  CHECK(before > 0.5);
  CHECK(stopped >= 6);
}
