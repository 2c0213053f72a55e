// SPDX-License-Identifier: GPL-3.0-or-later
#include <catch2/catch.hpp>
#include <cmath>

#include "core/base/rng.h"
#include "core/edit/arrangement.h"

using namespace mes;

namespace {

std::vector<Vec2> cloud(std::size_t count) {
  Rng random(7);
  std::vector<Vec2> out;
  for (std::size_t i = 0; i < count; ++i) out.push_back({random.uniform(-5.0, 9.0), random.uniform(2.0, 4.0)});
  return out;
}

}  // namespace

TEST_CASE("quarter turns are exact, and four of them change nothing") {
  const std::vector<Vec2> places{{3, 1}, {4, 1}, {3, 2.5}};
  CHECK(turned(places, {3, 1}, 90) == std::vector<Vec2>{{3, 1}, {3, 2}, {1.5, 1}});
  CHECK(turned(places, {3, 1}, -270) == turned(places, {3, 1}, 90));
  CHECK(turned(places, {3, 1}, 180) == turned(turned(places, {3, 1}, 90), {3, 1}, 90));
  CHECK(turned(places, {3, 1}, 720) == places);
}

TEST_CASE("turns keep distances, and turn by what they say") {
  const std::vector<Vec2> places = cloud(20);
  const Vec2 about{1, -2};
  const std::vector<Vec2> there = turned(places, about, 33);
  for (std::size_t i = 0; i < places.size(); ++i) {
    CHECK(distance(there[i], about) == Approx(distance(places[i], about)));
    const double turn =
        std::atan2(cross(places[i] - about, there[i] - about), dot(places[i] - about, there[i] - about));
    CHECK(turn == Approx(33 * 3.141592653589793 / 180));
  }
}

TEST_CASE("scaling multiplies differences, and mirroring twice changes nothing") {
  const std::vector<Vec2> places{{1, 1}, {2, 3}};
  CHECK(scaled(places, {1, 1}, 4) == std::vector<Vec2>{{1, 1}, {5, 9}});
  CHECK(mirrored(places, {1, 1}, Axis::x) == std::vector<Vec2>{{1, 1}, {0, 3}});
  CHECK(mirrored(places, {1, 1}, Axis::y) == std::vector<Vec2>{{1, 1}, {2, -1}});
  CHECK(mirrored(mirrored(places, {1, 1}, Axis::x), {1, 1}, Axis::x) == places);
}

TEST_CASE("aligned places share the coordinate of their box, and keep the other one") {
  const std::vector<Vec2> places{{1, 5}, {3, 9}, {2, 6}};
  CHECK(aligned(places, Alignment::left) == std::vector<Vec2>{{1, 5}, {1, 9}, {1, 6}});
  CHECK(aligned(places, Alignment::center) == std::vector<Vec2>{{2, 5}, {2, 9}, {2, 6}});
  CHECK(aligned(places, Alignment::right) == std::vector<Vec2>{{3, 5}, {3, 9}, {3, 6}});
  CHECK(aligned(places, Alignment::bottom) == std::vector<Vec2>{{1, 5}, {3, 5}, {2, 5}});
  CHECK(aligned(places, Alignment::middle) == std::vector<Vec2>{{1, 7}, {3, 7}, {2, 7}});
  CHECK(aligned(places, Alignment::top) == std::vector<Vec2>{{1, 9}, {3, 9}, {2, 9}});
  CHECK(aligned({}, Alignment::top).empty());
}

TEST_CASE("distributed places have equal steps in their order, and the outermost stay") {
  const std::vector<Vec2> places{{0, 1}, {10, 2}, {1, 3}, {2, 4}, {9, 5}};
  CHECK(distributed(places, Axis::x) == std::vector<Vec2>{{0, 1}, {10, 2}, {2.5, 3}, {5, 4}, {7.5, 5}});
  const std::vector<Vec2> two{{0, 1}, {10, 2}};
  CHECK(distributed(two, Axis::y) == two);
  const std::vector<Vec2> cloud_there = distributed(cloud(30), Axis::y);
  std::vector<double> heights;
  for (const Vec2 p : cloud_there) heights.push_back(p.y);
  std::ranges::sort(heights);
  for (std::size_t i = 2; i < heights.size(); ++i)
    CHECK(heights[i] - heights[i - 1] == Approx(heights[1] - heights[0]));
}
