// SPDX-License-Identifier: GPL-3.0-or-later
// Radii of smallest enclosing circles against limits, in doubles and in rationals.
#include <CGAL/Exact_rational.h>

#include <array>
#include <catch2/catch.hpp>
#include <cmath>
#include <optional>
#include <vector>

#include "core/base/rng.h"
#include "core/kernel/enclosing_circle.h"

using namespace mes;

namespace {

using Rational = CGAL::Exact_rational;
struct RationalPoint {
  Rational x, y;
};
Rational squared_distance(const RationalPoint& a, const RationalPoint& b) {
  return (a.x - b.x) * (a.x - b.x) + (a.y - b.y) * (a.y - b.y);
}

/// By definition: the least squared radius of the circles with two of the points for a diameter that enclose the third,
/// and of the circle through all three.
Rational squared_radius(const std::array<Vec2, 3>& given) {
  std::array<RationalPoint, 3> p;
  for (std::size_t i = 0; i < 3; ++i) p[i] = {Rational(given[i].x), Rational(given[i].y)};
  std::optional<Rational> least;
  const auto take = [&](const RationalPoint& center, const Rational& radius) {
    for (const RationalPoint& point : p)
      if (squared_distance(point, center) > radius) return;
    if (!least || radius < *least) least = radius;
  };
  for (std::size_t i = 0; i < 3; ++i) {
    const RationalPoint& a = p[i];
    const RationalPoint& b = p[(i + 1) % 3];
    take({(a.x + b.x) / 2, (a.y + b.y) / 2}, squared_distance(a, b) / 4);
  }
  // The centre solves two linear equations.
  const Rational ux = p[1].x - p[0].x, uy = p[1].y - p[0].y, vx = p[2].x - p[0].x, vy = p[2].y - p[0].y;
  const Rational det = ux * vy - uy * vx;
  const Rational u = (ux * ux + uy * uy) / 2, v = (vx * vx + vy * vy) / 2;
  const RationalPoint center{p[0].x + (u * vy - uy * v) / det, p[0].y + (ux * v - u * vx) / det};
  take(center, squared_distance(center, p[0]));
  return *least;
}

int sign_of_difference(const Rational& left, const Rational& right) {
  return left < right ? -1 : (right < left ? 1 : 0);
}

void check_radius(const std::array<Vec2, 3>& p, double r) {
  INFO(p[0].x << ' ' << p[0].y << "  " << p[1].x << ' ' << p[1].y << "  " << p[2].x << ' ' << p[2].y << "  r " << r);
  const Rational limit = Rational(r) * Rational(r);
  REQUIRE(compare_enclosing_radius(p[0], p[1], p[2], r) == sign_of_difference(squared_radius(p), limit));
  REQUIRE(compare_enclosing_radius(p[2], p[0], p[1], r) == compare_enclosing_radius(p[0], p[1], p[2], r));
  REQUIRE(compare_enclosing_radius(p[1], p[0], p[2], r) == compare_enclosing_radius(p[0], p[1], p[2], r));
  const Rational half =
      squared_distance({Rational(p[0].x), Rational(p[0].y)}, {Rational(p[1].x), Rational(p[1].y)}) / 4;
  REQUIRE(compare_half_distance(p[0], p[1], r) == sign_of_difference(half, limit));
}

}  // namespace

TEST_CASE("radii are compared with limits as rationals are, near ties and at them") {
  Rng rng(1);
  for (int round = 0; round < 4000; ++round) {
    std::array<Vec2, 3> p;
    const bool is_lattice = rng.below(2) == 0;
    for (Vec2& at : p)
      at = is_lattice ? Vec2{static_cast<double>(rng.below(9)), static_cast<double>(rng.below(9))}
                      : Vec2{1e3 + rng.uniform(), -1e3 + rng.uniform()};
    if (cross(p[1] - p[0], p[2] - p[0]) == 0.0) continue;
    const double near = std::sqrt(CGAL::to_double(squared_radius(p)));
    for (const double r : {near, std::nextafter(near, 0.0), std::nextafter(near, 1e9), 0.5 * near, 2.0 * near, 0.0,
                           0.5 * distance(p[0], p[1])})
      check_radius(p, r);
  }
}

TEST_CASE("a corner is acute, right or obtuse as rationals say, where differences of coordinates round, too") {
  Rng rng(12);
  std::array<std::size_t, 3> seen{};
  std::size_t misled = 0;
  for (int round = 0; round < 4000; ++round) {
    // Nearly a right angle, with coordinates of very different sizes.
    const auto small = [&] { return std::ldexp(rng.uniform(-1.0, 1.0), -static_cast<int>(rng.below(70))); };
    const auto whole = [&] { return static_cast<double>(rng.below(9)) - 4.0; };
    const Vec2 u{1.0 + whole(), 0.5 + whole()};
    Vec2 p{whole(), whole()};
    Vec2 q = p + u;
    Vec2 r = p + perpendicular(u);
    if (round % 4 != 0) {
      Vec2& one = round % 4 == 1 ? p : (round % 4 == 2 ? q : r);
      (one.x == 0.0 ? one.x : one.y == 0.0 ? one.y : one.x) += small();
    }
    if (p == q || q == r || p == r) continue;
    const Rational exact = (Rational(q.x) - Rational(p.x)) * (Rational(r.x) - Rational(p.x)) +
                           (Rational(q.y) - Rational(p.y)) * (Rational(r.y) - Rational(p.y));
    const int expected = exact > 0 ? 1 : (exact < 0 ? -1 : 0);
    REQUIRE(sign_of_corner(p, q, r) == expected);
    REQUIRE(sign_of_corner(p, r, q) == expected);
    ++seen[static_cast<std::size_t>(expected + 1)];
    const double rounded = dot(q - p, r - p);
    misled += (rounded > 0.0 ? 1 : (rounded < 0.0 ? -1 : 0)) == expected ? 0U : 1U;
  }
  for (const std::size_t count : seen) CHECK(count > 100);
  CHECK(misled > 20);  // the inputs do ask for more than doubles
}

TEST_CASE("thin, right and far triangles, and limits at the ends of the range") {
  const std::array<Vec2, 3> right{{{0, 0}, {4, 0}, {0, 3}}};
  check_radius(right, 2.5);
  check_radius(right, std::nextafter(2.5, 3.0));
  check_radius({{{0, 0}, {1, 0}, {0.5, 1e-12}}}, 0.5);
  check_radius({{{0, 0}, {1e-9, 0}, {5e-10, 1}}}, 0.5);
  for (const double unit : {0x1p-500, 0x1p-300, 0x1p300, 0x1p499}) {
    const std::array<Vec2, 3> scaled{{{0, 0}, {0.5 * unit, 0}, {0.25 * unit, 0.375 * unit}}};
    for (const double r : {0.25 * unit, 0.2708333 * unit, 1.0, 0.0}) check_radius(scaled, r);
  }
  CHECK(compare_half_distance({0, 0}, {2, 0}, -1.0) == 1);
  CHECK(is_right_or_obtuse({0, 0}, {4, 0}, {0, 3}));
  CHECK_FALSE(is_right_or_obtuse({0, 0}, {4, 0}, {0x1p-40, 3}));
  CHECK(half_longest_side({0, 0}, {4, 0}, {0, 3}) == 2.5);
}
