// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <string_view>
#include <vector>

#include "app/insight/persistence_table.h"
#include "app/playing/step_events.h"
#include "core/builtins/builtins.h"
#include "tests/support/builtin_layers.h"

using namespace mes;

namespace {

PersistenceTable table_of_input(const PersistenceInput& input) {
  JobControl job;
  auto out = persistence_table_of(builtins(), input, job);
  REQUIRE(out.has_value());
  return *std::move(out);
}

StepRange range_of(std::string_view evolution, std::string_view step, double width, double first, std::uint64_t end) {
  StepRange out{{.evolution = find_evolution(evolution)}, first, end};
  out.choice.values.keep(step, width);
  return out;
}

/// A square of side 2, as samples or as balls of radius 0.
const std::vector<Vec2> kSquare{{0, 0}, {2, 0}, {2, 2}, {0, 2}};

SampleData square_of_balls() {
  SampleData out;
  for (const Vec2 p : kSquare) out.balls.push_back({p, 0.0});
  return out;
}

}  // namespace

TEST_CASE(
    "components are joined, holes closed and filled in the step that reaches them, also where it hits them exactly") {
  for (const bool are_balls : {false, true}) {
    CAPTURE(are_balls);
    const PersistenceTable table = table_of_input(are_balls ? PersistenceInput{square_of_balls(), GrowthOf::own}
                                                            : PersistenceInput{{.positions = kSquare}});
    // All sides come at radius 1, the inside at the root of 2.
    const auto growing = step_events_of(range_of("alpha-growing", "alpha-step", 0.25, 0.0, 10), table);
    REQUIRE(growing.size() == 2);
    CHECK(growing[0] == StepEvent{3, 4, 3, 1, 0, false});
    CHECK(growing[1] == StepEvent{5, 6, 0, 0, 1, false});
    CHECK(growing[0].words() == "Step 4: components joined: 3, holes closed: 1");
    // Shrinking, they are there at 1 still.
    const auto shrinking = step_events_of(range_of("alpha-shrinking", "alpha-step", 0.25, 2.0, 10), table);
    REQUIRE(shrinking.size() == 2);
    CHECK(shrinking[0] == StepEvent{2, 3, 0, 0, 1, true});
    CHECK(shrinking[1] == StepEvent{4, 5, 3, 1, 0, true});
    CHECK(shrinking[1].words() == "Step 5: components parted: 3, holes opened: 1");
    // On a slider without room for each step, several are one.
    const auto coarse = step_events_of(range_of("alpha-growing", "alpha-step", 0.001, 0.0, 1000), table);
    REQUIRE(coarse.size() == 1);
    CHECK(coarse[0].before + 4 == coarse[0].k);
    CHECK(coarse[0].words() == "Steps 997 to 1000: components joined: 3, holes closed: 1");
    CHECK(step_events_of(range_of("alpha-growing", "alpha-step", 0.0, 0.0, 100), table).empty());
    CHECK(step_events_of(range_of("alpha-growing", "alpha-step", 0.25, 0.0, 0), table).empty());
    CHECK(step_events_of(range_of("smooth", "alpha-step", 0.25, 0.0, 10), table).empty());
  }
}

TEST_CASE("steps of balls along the axis change what the factors between them do") {
  const std::vector<ScaleEvent> events{{0.7, 0.0, 4, 3, 0, 0},
                                       {1.1, 0.0, 3, 2, 0, 0},
                                       {1.2, 0.0, 2, 1, 0, 2},
                                       {1.25, 0.0, 1, 1, 2, 1},
                                       {2.9, 0.0, 1, 1, 1, 0}};
  const auto growing = step_events_of(range_of("scale-axis-growing", "growing-step", 10.0, 1.0, 12), events);
  REQUIRE(growing.size() == 3);
  CHECK(growing[0] == StepEvent{0, 1, 1, 0, 0, false});
  CHECK(growing[1].words() == "Step 2: components joined: 1, holes closed: 2");
  CHECK(growing[2] == StepEvent{2, 3, 0, 0, 1, false});
  // From 1.3 to 0.867, and to 0.65.
  const auto shrinking = step_events_of(range_of("scale-axis-shrinking", "growing-step", 50.0, 1.3, 12), events);
  REQUIRE(shrinking.size() == 2);
  CHECK(shrinking[0].words() == "Step 1: components parted: 2, holes opened: 2, holes that come back: 1");
  CHECK(shrinking[1].words() == "Step 2: components parted: 1");
  // Steps that would leave the range of the factor do not exist.
  CHECK(step_events_of(range_of("scale-axis-shrinking", "growing-step", 100.0, 0.15, 12), events).empty());
  const auto back = step_events_of(range_of("scale-axis-shrinking", "growing-step", 15.0, 1.3, 12), events);
  REQUIRE(back.size() == 3);
  CHECK(back[0].is_undone);
  CHECK(back[0].words() == "Step 1: components parted: 1, holes opened: 2, holes that come back: 1");
  CHECK(back[1].words() == "Step 2: components parted: 1");
  CHECK(back[2].words() == "Step 6: components parted: 1");
}

TEST_CASE("what is alive at a radius is exact for rounded births of balls") {
  for (const double n : {3.0, 5.0, 7.0, 11.0, 13.0}) {
    SampleData data;
    for (const Vec2 p : {Vec2{0.0, 0.0}, Vec2{2.0 / n, 0.0}}) data.balls.push_back({p, 0.0});
    const PersistenceTable table = table_of_input({data, GrowthOf::own});
    REQUIRE(table.joins.size() == 1);
    // Two balls of radius 0 meet at half their distance, which is a double.
    const double meet = 0.5 * (2.0 / n);
    CHECK(table.joins[0].radius >= meet);
    const auto alive = [&](double radius) {
      return std::ranges::count_if(table.rows, [ranks = table.ranks_within(radius)](const PersistenceRow& row) {
        return row.is_alive(ranks);
      });
    };
    CHECK(alive(meet) == 1);
    CHECK(alive(std::nextafter(meet, 0.0)) == 2);
    CHECK(alive(0.0) == 2);
  }
}
