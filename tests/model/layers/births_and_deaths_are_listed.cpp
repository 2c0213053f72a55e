// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <map>
#include <numbers>
#include <string>

#include "app/insight/latest_persistence.h"
#include "app/insight/persistence_table.h"
#include "app/layers/words/length_words.h"
#include "core/base/rng.h"
#include "core/builtins/builtins.h"

using namespace mes;

namespace {

PersistenceTable table_of_samples(const SampleData& data) {
  JobControl job;
  auto out = persistence_table_of(builtins(), {data}, job);
  REQUIRE(out.has_value());
  return *std::move(out);
}

SampleData ring(std::size_t count, std::uint64_t seed) {
  Rng rng(seed);
  SampleData out;
  while (out.positions.size() < count) {
    const Vec2 p{2.0 * rng.uniform() - 1.0, 2.0 * rng.uniform() - 1.0};
    if (length(p) >= 0.6 && length(p) <= 1.0) out.positions.push_back(p);
  }
  return out;
}

void wait_for_table(LatestPersistence& latest, std::uint64_t document, const SampleData& data) {
  do latest.follow(document, [&] { return PersistenceInput{data}; });
  while (!latest.is_current());
}

}  // namespace

TEST_CASE("the longest class comes first, and a ring has one long hole in its middle") {
  const PersistenceTable table = table_of_samples(ring(400, 1));
  REQUIRE(table.rows.size() > 400);
  CHECK(std::isinf(table.rows[0].death));
  CHECK_FALSE(table.rows[0].has_edge);
  REQUIRE(table.rows[1].is_hole);
  CHECK(table.rows[1].persistence() > 0.4);
  CHECK(length(table.rows[1].place) < 0.2);
  for (std::size_t i = 1; i < table.rows.size(); ++i) {
    CHECK(table.rows[i].persistence() <= table.rows[i - 1].persistence());
    CHECK(table.rows[i].persistence() > 0.0);
  }
  CHECK(table.joins.size() + 1 + table.closes.size() == table.rows.size());
  CHECK(table.closes.size() == table.fills.size());
  CHECK(std::ranges::is_sorted(table.joins, {}, &GrowthEvent::radius));
  CHECK(table.fills.back().radius == table.rows[1].death);
}

TEST_CASE("the widest gap separates the spacing of samples from the size of what they surround") {
  const auto alive_at = [](const PersistenceTable& table, double radius) {
    const std::uint32_t ranks = table.ranks_within(radius);
    std::pair<int, int> out;
    for (const PersistenceRow& row : table.rows)
      if (row.is_alive(ranks)) ++(row.is_hole ? out.second : out.first);
    return out;
  };
  const auto add_circle = [](SampleData& data, Vec2 center, double radius, int count) {
    for (int i = 0; i < count; ++i) {
      const double angle = 2.0 * std::numbers::pi * i / count;
      data.positions.push_back(center + radius * Vec2{std::cos(angle), std::sin(angle)});
    }
  };
  SampleData circle;
  add_circle(circle, {3.0, 4.0}, 2.0, 80);
  auto gap = widest_gap(table_of_samples(circle));
  REQUIRE(gap);
  const double half_spacing = 2.0 * std::sin(std::numbers::pi / 80);
  CHECK(gap->begin == Approx(half_spacing));
  CHECK(gap->end == Approx(2.0));
  CHECK(gap->middle() == Approx(std::sqrt(2.0 * half_spacing)));
  CHECK(alive_at(table_of_samples(circle), gap->middle()) == std::pair(1, 1));

  // Circles of different sizes all stay, whatever nearly coincides.
  SampleData circles = circle;
  add_circle(circles, {20.0, 4.0}, 4.0, 160);
  for (std::size_t i = 0; i < 210; i += 7) circles.positions.push_back(circles.positions[i] + Vec2{1e-9, 0.0});
  const PersistenceTable table = table_of_samples(circles);
  gap = widest_gap(table);
  REQUIRE(gap);
  CHECK(alive_at(table, gap->middle()) == std::pair(2, 2));

  // Four times as large, four times the radii.
  SampleData scaled = circles;
  for (Vec2& p : scaled.positions) p = 4.0 * p;
  const auto larger = widest_gap(table_of_samples(scaled));
  REQUIRE(larger);
  CHECK(larger->begin == 4.0 * gap->begin);
  CHECK(larger->end == 4.0 * gap->end);

  for (const std::size_t count : {0U, 1U, 2U}) {
    SampleData few;
    few.positions.assign(circle.positions.begin(), circle.positions.begin() + static_cast<std::ptrdiff_t>(count));
    CHECK_FALSE(widest_gap(table_of_samples(few)));
  }
}

TEST_CASE("the outline of a hole is closed, holds its edge and goes around its centre") {
  const PersistenceTable table = table_of_samples(ring(400, 2));
  std::size_t seen = 0;
  for (const PersistenceRow& row : table.rows) {
    const auto outline = outline_of(table, row);
    if (!row.is_hole) {
      CHECK(outline.empty());
      continue;
    }
    ++seen;
    REQUIRE(outline.size() >= 3);
    std::map<std::pair<double, double>, int> balance;
    double turn = 0.0;
    bool holds_edge = false;
    for (const auto& [a, b] : outline) {
      ++balance[{a.x, a.y}];
      --balance[{b.x, b.y}];
      const Vec2 u = a - row.place;
      const Vec2 v = b - row.place;
      turn += std::atan2(cross(u, v), dot(u, v));
      // Every edge is there when the hole is closed.
      CHECK(0.5 * distance(a, b) <= row.birth * (1.0 + 1e-9));
      holds_edge = holds_edge || (a == row.edge[0] && b == row.edge[1]) || (a == row.edge[1] && b == row.edge[0]);
    }
    for (const auto& [place, sum] : balance) CHECK(sum == 0);
    CHECK(turn == Approx(2.0 * std::numbers::pi));
    CHECK(holds_edge);
  }
  CHECK(seen > 10);
}

TEST_CASE("a class is found by its places") {
  const PersistenceTable table = table_of_samples({.positions = {{0, 0}, {4, 0}, {4, 4}, {0, 4.5}}});
  const auto hole = std::ranges::find(table.rows, true, &PersistenceRow::is_hole);
  REQUIRE(hole != table.rows.end());
  const auto number = static_cast<std::size_t>(hole - table.rows.begin());
  CHECK(row_near(table, hole->place, 0.1) == number);
  CHECK(row_near(table, 0.5 * (hole->edge[0] + hole->edge[1]), 0.1) == number);
  const auto at_sample = row_near(table, {4.0, 4.05}, 0.1);
  REQUIRE(at_sample.has_value());
  CHECK_FALSE(row_near(table, {100.0, 100.0}, 0.1).has_value());
  CHECK_FALSE(row_near(table_of_samples({}), {0.0, 0.0}, 1.0).has_value());
}

TEST_CASE("few samples have few classes, and words and CSV say which") {
  CHECK(table_of_samples({}).rows.empty());
  CHECK(persistence_as_csv(table_of_samples({})).value() ==
        "dimension,birth,death,persistence,x,y,edge_x1,edge_y1,edge_x2,edge_y2\n");
  const PersistenceTable one = table_of_samples({.positions = {{1, 2}, {1, 2}}});
  REQUIRE(one.rows.size() == 1);
  CHECK(in_words(one.rows[0], std::nullopt) == "component, born at 0, stays");
  const PersistenceTable right = table_of_samples({.positions = {{0, 0}, {3, 0}, {0, 4}}});
  // The hypotenuse comes with the triangle, so no hole lives.
  CHECK(persistence_as_csv(right).value() ==
        "dimension,birth,death,persistence,x,y,edge_x1,edge_y1,edge_x2,edge_y2\n"
        "0,0,,,0,0,,,,\n"
        "0,0,2,2,0,4,0,0,0,4\n"
        "0,0,1.5,1.5,3,0,0,0,3,0\n");
  CHECK(in_words(right.rows[1], std::nullopt) == "component, born at 0, joined at 2, persistence 2");
}

TEST_CASE("a class stays chosen while it is there, and nothing is chosen by an outdated table") {
  LatestPersistence latest(builtins(), [] {});
  SampleData data = ring(200, 3);
  CHECK_FALSE(latest.pick({0.0, 0.0}, 1.0));
  wait_for_table(latest, 1, data);
  latest.choose(1);
  const PersistenceRow chosen = latest.table()->rows[1];
  data.positions.push_back({5.0, 5.0});
  latest.follow(2, [&] { return PersistenceInput{data}; });
  CHECK_FALSE(latest.is_current());
  CHECK_FALSE(latest.pick({0.0, 0.0}, 1.0));
  wait_for_table(latest, 2, data);
  REQUIRE(latest.chosen().has_value());
  CHECK(latest.table()->rows[*latest.chosen()].place == chosen.place);
  CHECK(latest.pick({50.0, 50.0}, 0.1));
  CHECK_FALSE(latest.chosen().has_value());
}

TEST_CASE("lengths have the unit of the map in words, and none without a map") {
  PersistenceRow row;
  row.is_hole = true;
  row.birth = 1.5;
  row.death = 4.0;
  CHECK(in_words(row, std::nullopt) == "hole, born at 1.5, filled at 4, persistence 2.5");
  CHECK(with_unit("radius", std::nullopt) == "radius");
  const MapPlane map;
  const std::string unit(map.plane_unit());
  REQUIRE_FALSE(unit.empty());
  CHECK(in_words(row, map) == "hole, born at 1.5 " + unit + ", filled at 4 " + unit + ", persistence 2.5 " + unit);
  CHECK(with_unit("radius", map) == "radius (" + unit + ")");
}
