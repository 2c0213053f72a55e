// SPDX-License-Identifier: GPL-3.0-or-later
// What is on one line or one circle is so in rational numbers, and near to where it was.
#include <CGAL/Exact_rational.h>

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>

#include "core/base/rng.h"
#include "core/edit/degenerate_places.h"

using namespace mes;

namespace {

using Rational = CGAL::Exact_rational;

struct Exact {
  Rational x, y;
  explicit Exact(Vec2 p) : x(p.x), y(p.y) {}
};

bool are_collinear(const std::vector<Vec2>& places) {
  const Exact a(places[0]);
  const Exact b(places[1]);
  return std::ranges::all_of(places, [&](Vec2 place) {
    const Exact c(place);
    return (b.x - a.x) * (c.y - a.y) == (b.y - a.y) * (c.x - a.x);
  });
}

/// All have the same distance from the circumcentre of the first three.
bool are_cocircular(const std::vector<Vec2>& places) {
  const Exact a(places[0]);
  const Exact b(places[1]);
  const Exact c(places[2]);
  const Rational bx = b.x - a.x;
  const Rational by = b.y - a.y;
  const Rational cx = c.x - a.x;
  const Rational cy = c.y - a.y;
  const Rational d = 2 * (bx * cy - by * cx);
  if (d == 0) return false;
  const Rational bb = bx * bx + by * by;
  const Rational cc = cx * cx + cy * cy;
  const Rational ux = (cy * bb - by * cc) / d;
  const Rational uy = (bx * cc - cx * bb) / d;
  const Rational square = ux * ux + uy * uy;
  return std::ranges::all_of(places, [&](Vec2 place) {
    const Exact p(place);
    const Rational x = p.x - a.x - ux;
    const Rational y = p.y - a.y - uy;
    return x * x + y * y == square;
  });
}

bool are_all_different(std::vector<Vec2> places) {
  std::ranges::sort(places, lexicographically_less);
  return std::ranges::adjacent_find(places) == places.end();
}

double shift_between(const std::vector<Vec2>& from, const std::vector<Vec2>& to) {
  double out = 0.0;
  for (std::size_t i = 0; i < from.size(); ++i) out = std::max(out, distance(from[i], to[i]));
  return out;
}

std::vector<Vec2> near_circle(Rng& random, std::size_t count, Vec2 center, double radius, double noise) {
  std::vector<Vec2> out;
  for (std::size_t i = 0; i < count; ++i) {
    const double angle = 2.0 * std::numbers::pi * random.uniform();
    const double r = radius * (1.0 + noise * random.uniform(-1.0, 1.0));
    out.push_back(center + r * Vec2{std::cos(angle), std::sin(angle)});
  }
  return out;
}

}  // namespace

TEST_CASE("places become collinear exactly, whatever their direction, size and place") {
  Rng random(1);
  for (int round = 0; round < 200; ++round) {
    const double size = std::ldexp(1.0, static_cast<int>(random.below(400)) - 200);
    const Vec2 origin = size * Vec2{random.uniform(-1e3, 1e3), random.uniform(-1e3, 1e3)};
    const double angle = 2.0 * std::numbers::pi * random.uniform();
    const Vec2 along = size * Vec2{std::cos(angle), std::sin(angle)};
    const double noise = round % 2 == 0 ? 0.0 : 1e-3;
    std::vector<Vec2> places;
    for (std::size_t i = 0; i < 3 + random.below(20); ++i)
      places.push_back(origin + random.uniform(-10.0, 10.0) * along +
                       noise * random.uniform(-1.0, 1.0) * perpendicular(along));
    const auto line = on_one_line(places);
    REQUIRE(line);
    REQUIRE(line->places.size() == places.size());
    CHECK(are_collinear(line->places));
    CHECK(are_all_different(line->places));
    CHECK(line->largest_shift == shift_between(places, line->places));
    CHECK(line->largest_shift <= size * (2.0 * noise + 2000.0 * 0x1p-26));
    // What is on a line stays there.
    const auto again = on_one_line(line->places);
    REQUIRE(again);
    CHECK(again->places == line->places);
    CHECK(again->largest_shift == 0.0);
  }
}

TEST_CASE("places along an axis keep what they have in common") {
  const auto level = on_one_line(std::vector<Vec2>{{0, 0.1}, {1, 0.1}, {5, 0.1}, {2.5, 0.1}});
  REQUIRE(level);
  for (const Vec2 p : level->places) CHECK(p.y == 0.1);
  CHECK(level->largest_shift == 0.0);
  const auto upright = on_one_line(std::vector<Vec2>{{-3, 1}, {-3, 2}, {-3, 7}});
  REQUIRE(upright);
  CHECK(upright->places == std::vector<Vec2>{{-3, 1}, {-3, 2}, {-3, 7}});
}

TEST_CASE("places become cocircular exactly, and move by some hundred thousandths of the radius") {
  Rng random(2);
  for (int round = 0; round < 40; ++round) {
    const double size = std::ldexp(1.0, static_cast<int>(random.below(400)) - 200);
    const double radius = size * random.uniform(0.5, 2.0);
    const Vec2 center = size * Vec2{random.uniform(-3.0, 3.0), random.uniform(-3.0, 3.0)};
    const double noise = round % 2 == 0 ? 0.0 : 1e-3;
    const std::vector<Vec2> places =
        near_circle(random, round == 1 ? 1000 : 4 + random.below(60), center, radius, noise);
    const auto circle = on_one_circle(places);
    REQUIRE(circle);
    REQUIRE(circle->places.size() == places.size());
    CHECK(are_cocircular(circle->places));
    CHECK(are_all_different(circle->places));
    CHECK(circle->largest_shift == shift_between(places, circle->places));
    CHECK(circle->largest_shift <= radius * (3.0 * noise + 2e-4));
    const auto again = on_one_circle(circle->places);
    REQUIRE(again);
    CHECK(again->places == circle->places);
    CHECK(again->largest_shift == 0.0);
  }
}

TEST_CASE("far from the origin places become cocircular as well, if there is room") {
  Rng random(3);
  for (const double far : {1e3, 1e5, 1e7}) {
    const std::vector<Vec2> places = near_circle(random, 8, {far, -far}, 1.0, 0.0);
    const auto circle = on_one_circle(places);
    REQUIRE(circle);
    CHECK(are_cocircular(circle->places));
    CHECK(circle->largest_shift <= 0.05);
  }
  // A circle of some thousand steps of the doubles there has no three hundred points.
  std::vector<Vec2> crowd;
  for (int i = 0; i < 300; ++i)
    crowd.push_back(Vec2{1e12, 1e12} +
                    Vec2{std::cos(i * std::numbers::pi / 150), std::sin(i * std::numbers::pi / 150)});
  const auto crowded = on_one_circle(crowd);
  REQUIRE_FALSE(crowded);
  CHECK(crowded.error().text.find("distance from the origin") != std::string::npos);
  // Doubles there are 2^-13 apart, so that none is farther from its circle than that.
  const std::string& text = crowded.error().text;
  const std::string_view within = "they stay within ";
  REQUIRE(text.find(within) != std::string::npos);
  const double off = std::stod(text.substr(text.find(within) + within.size()));
  CHECK(off > 0.0);
  CHECK(off < 0x1p-12);
}

TEST_CASE("what has no line or no circle is refused, and what always has one stays") {
  const std::vector<Vec2> twice{{1, 2}, {3, 4}, {1, 2}, {5, 1}};
  REQUIRE_FALSE(on_one_line(twice));
  CHECK(on_one_line(twice).error().text == "two of the places are the same: 1, 2");
  REQUIRE_FALSE(on_one_circle(twice));
  CHECK(on_one_circle(twice).error().text == "two of the places are the same: 1, 2");
  const auto straight = on_one_circle(std::vector<Vec2>{{0, 0}, {1, 1}, {2, 2}, {3, 3}});
  REQUIRE_FALSE(straight);
  CHECK(straight.error().text.find("line") != std::string::npos);
  const std::vector<Vec2> two{{0.1, 0.2}, {0.3, 0.5}};
  REQUIRE(on_one_line(two));
  CHECK(on_one_line(two)->places == two);
  const std::vector<Vec2> three{{0.1, 0.2}, {0.3, 0.5}, {0.7, 0.1}};
  REQUIRE(on_one_circle(three));
  CHECK(on_one_circle(three)->places == three);
  CHECK(on_one_line(std::vector<Vec2>{})->places.empty());
  // Mirror images of each other have the same place along the line between them.
  const auto mirrored = on_one_line(std::vector<Vec2>{{-8, 0}, {0, 0.5}, {0, -0.5}, {8, 0}});
  REQUIRE_FALSE(mirrored);
  CHECK_THAT(mirrored.error().text, Catch::EndsWith("they stay within 0.5 of the nearest line"));
  // Nearly one place, seen from the origin.
  CHECK_FALSE(on_one_line(std::vector<Vec2>{{1e15, 1e15}, {1e15 + 0.125, 1e15 + 0.25}, {1e15 + 0.25, 1e15 + 0.125}}));
}

TEST_CASE("the nearest circle is that of places on a circle, also of a short arc of it") {
  for (const double arc : {6.0, 1.0, 0.3}) {
    std::vector<Vec2> places;
    for (int i = 0; i <= 10; ++i)
      places.push_back(Vec2{7, -2} + 3.0 * Vec2{std::cos(0.1 * i * arc), std::sin(0.1 * i * arc)});
    const auto circle = nearest_circle(places);
    REQUIRE(circle);
    CHECK(distance(circle->center, {7, -2}) < 1e-9);
    CHECK(std::abs(circle->radius - 3.0) < 1e-9);
  }
  CHECK_FALSE(nearest_circle(std::vector<Vec2>{{0, 0}, {1, 0}}));
  CHECK_FALSE(nearest_circle(std::vector<Vec2>{{1, 1}, {1, 1}, {1, 1}}));
}
