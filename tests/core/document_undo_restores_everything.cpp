// SPDX-License-Identifier: GPL-3.0-or-later
#include <catch2/catch.hpp>
#include <limits>
#include <random>

#include "core/document/commands.h"
#include "core/document/history.h"

using namespace mes;

namespace {

void do_step(Document& document, History& history, const Expected<DocumentDelta>& delta) {
  REQUIRE(delta.has_value());
  document.apply(*delta);
  history.record(*delta);
}

}  // namespace

TEST_CASE("undo to the start and redo to the end meet every document on the way") {
  std::mt19937 random(7);
  Document document;
  History history;
  std::vector<std::uint64_t> digests{document.digest()};
  std::uniform_real_distribution<double> coordinate(-1, 1);
  for (int step = 0; step < 400; ++step) {
    const auto slots = document.slots_in_input_order();
    const auto pick = [&] { return document.id(slots[random() % slots.size()]); };
    switch (slots.empty() ? 0 : random() % 5) {
      case 0:
      case 1: {
        std::vector<Vec2> points(1 + random() % 4);
        for (Vec2& p : points) p = {coordinate(random), coordinate(random)};
        do_step(document, history, insert_samples(document, points));
        break;
      }
      case 2: do_step(document, history, remove_samples(document, std::vector{pick()})); break;
      case 3: {
        const SampleId id = pick();
        history.begin_gesture("drag");
        for (int i = 0; i < 3; ++i) {
          const std::vector<std::pair<SampleId, Vec2>> move{{id, {coordinate(random), coordinate(random)}}};
          do_step(document, history, move_samples(document, move));
        }
        history.end_gesture();
        break;
      }
      default: {
        if (random() % 10 != 0) continue;
        SampleData data;
        data.positions = {{0, 0}, {1, 0}, {0, 1}};
        data.contours = {{true, {0, 1, 2}}};
        do_step(document, history, replace_all(document, data));
      }
    }
    digests.push_back(document.digest());
  }
  REQUIRE(history.step_count() == digests.size() - 1);
  for (std::size_t i = digests.size() - 1; i-- > 0;) {
    for (const auto& delta : history.undo()) document.apply(delta);
    REQUIRE(document.digest() == digests[i]);
  }
  REQUIRE(document.sample_count() == 0);
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
  const SampleId id = document.id(0);
  history.begin_gesture("drag");
  for (int i = 0; i < 1000; ++i)
    do_step(document, history, move_samples(document, std::vector<std::pair<SampleId, Vec2>>{{id, {0.5 * i, 3}}}));
  history.end_gesture();
  REQUIRE(history.step_count() == 2);
  const auto deltas = history.undo();
  REQUIRE(deltas.size() == 1);
  REQUIRE(deltas[0].edits.size() == 1);
  document.apply(deltas[0]);
  REQUIRE(document.position(0) == Vec2{1, 2});
}

TEST_CASE("commands refuse what cannot be and change nothing") {
  Document document;
  const double nan = std::numeric_limits<double>::quiet_NaN();
  REQUIRE_FALSE(insert_samples(document, std::vector<Vec2>{{0, nan}}).has_value());
  document.apply(*insert_samples(document, std::vector<Vec2>{{-0.0, 1}}));
  REQUIRE_FALSE(std::signbit(document.position(0).x));
  const SampleId id = document.id(0);
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
  const SampleId first = document.id(0);
  document.apply(*remove_samples(document, std::vector{first}));
  document.apply(*insert_samples(document, std::vector<Vec2>{{2, 0}}));
  REQUIRE(document.slot_count() == 2);
  REQUIRE(document.id(0) != first);
  REQUIRE(document.slot_of(first) == kNoSlot);
}
