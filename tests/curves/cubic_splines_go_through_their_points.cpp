// SPDX-License-Identifier: GPL-3.0-or-later
// Against what defines the spline: its points, continuity of two derivatives, its ends; and against curves that it must
// reproduce or come near to.
#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>

#include "core/base/rng.h"
#include "core/curves/interpolation/cubic_interpolation.h"
#include "tests/curves/curve_parts.h"

using namespace mes;
using mes::test::pieces_of;

namespace {

/// With respect to the distance of the ends.
Vec2 first_derivative(const Piece& piece, double t) {
  return (1.0 / distance(piece.from(), piece.to())) * piece.derivative(t);
}
Vec2 second_derivative(const Piece& piece, bool at_end) {
  const auto& p = piece.points;
  const double h = distance(piece.from(), piece.to());
  const Vec2 difference = at_end ? p[3] - 2.0 * p[2] + p[1] : p[2] - 2.0 * p[1] + p[0];
  return (6.0 / (h * h)) * difference;
}

std::vector<Vec2> random_points(Rng& rng, std::size_t count) {
  std::vector<Vec2> out;
  for (std::size_t i = 0; i < count; ++i) out.push_back({rng.uniform(-1, 1), rng.uniform(-1, 1)});
  return out;
}

}  // namespace

TEST_CASE("an open spline goes through its points with two continuous derivatives and straight ends") {
  Rng rng(11);
  for (const std::size_t count : {3U, 4U, 9U, 200U}) {
    const std::vector<Vec2> points = random_points(rng, count);
    const auto curve = cubic_through(points, false);
    REQUIRE(curve.has_value());
    const std::vector<Piece> pieces = pieces_of(*curve);
    REQUIRE(pieces.size() == count - 1);
    for (std::size_t i = 0; i < pieces.size(); ++i) {
      CHECK(pieces[i].from() == points[i]);
      CHECK(pieces[i].to() == points[i + 1]);
      if (i == 0) continue;
      CHECK(length(first_derivative(pieces[i - 1], 1) - first_derivative(pieces[i], 0)) < 1e-10);
      const Vec2 before = second_derivative(pieces[i - 1], true);
      CHECK(length(before - second_derivative(pieces[i], false)) < 1e-9 * (1.0 + length(before)));
    }
    CHECK(length(second_derivative(pieces.front(), false)) < 1e-9);
    CHECK(length(second_derivative(pieces.back(), true)) < 1e-9);
  }
}

TEST_CASE("a closed spline is as smooth where it closes, and near the circle whose points it has") {
  for (const std::size_t count : {3U, 4U, 12U, 40U}) {
    std::vector<Vec2> points;
    for (std::size_t i = 0; i < count; ++i) {
      const double w = 2.0 * std::numbers::pi * static_cast<double>(i) / static_cast<double>(count);
      points.push_back({std::cos(w), std::sin(w)});
    }
    const auto curve = cubic_through(points, true);
    REQUIRE(curve.has_value());
    CHECK(curve->is_closed());
    const std::vector<Piece> pieces = pieces_of(*curve);
    REQUIRE(pieces.size() == count);
    for (std::size_t i = 0; i < count; ++i) {
      const Piece& before = pieces[(i + count - 1) % count];
      CHECK(length(first_derivative(before, 1) - first_derivative(pieces[i], 0)) < 1e-12);
      CHECK(length(second_derivative(before, true) - second_derivative(pieces[i], false)) < 1e-10);
      // The error of a cubic spline is h^4 / 384 of the fourth derivative, and terms of h^6, here below a tenth of that.
      const double h = 2.0 * std::numbers::pi / static_cast<double>(count);
      if (count >= 12) CHECK(std::abs(length(pieces[i].at(0.5)) - 1.0) < 1.1 * h * h * h * h / 384.0);
    }
    // The first point may be repeated.
    points.push_back(points.front());
    CHECK(*cubic_through(points, true) == *curve);
  }
}

TEST_CASE("tangents are those that are given, and few points are lines") {
  const std::vector<Vec2> points{{0, 0}, {1, 1}, {2, 0}};
  const auto curve = cubic_through(points, false, {.at_start = Vec2{0, 5}, .at_end = Vec2{0, -0.1}});
  REQUIRE(curve.has_value());
  const std::vector<Piece> pieces = pieces_of(*curve);
  CHECK(length(first_derivative(pieces.front(), 0) - Vec2{0, 1}) < 1e-12);
  CHECK(length(first_derivative(pieces.back(), 1) - Vec2{0, -1}) < 1e-12);

  const auto line = cubic_through(std::vector<Vec2>{{0, 0}, {0, 0}, {3, 4}}, true);
  REQUIRE(line.has_value());
  CHECK(line->is_polyline());
  CHECK(line->piece_count() == 1);
  CHECK(cubic_through(std::vector<Vec2>{{1, 2}}, false)->piece_count() == 0);
  CHECK_FALSE(cubic_through({}, false).has_value());
  CHECK_FALSE(cubic_through(std::vector<Vec2>{{0, 0}, {NAN, 1}}, false).has_value());
}
