// SPDX-License-Identifier: GPL-3.0-or-later
#include <catch2/catch.hpp>
#include <cmath>

#include "core/curves/curve.h"
#include "tests/support/pi.h"

using namespace mes;
using mes::test::kPi;

namespace {

Vec2 on(const EllipticArc& arc, double t) {
  const double angle = arc.start + t * arc.sweep;
  return arc.center + std::cos(angle) * arc.u + std::sin(angle) * arc.v;
}

}  // namespace

TEST_CASE("the two flags choose one of four arcs") {
  struct Case {
    bool is_large, turns_to_v;
    Vec2 center;
    double sweep;
  };
  // Circles of radius 5 through (0, 0) and (6, 0) have their centres at (3, 4) and (3, -4).
  const double small = 2.0 * std::asin(0.6);
  for (const Case& test : {Case{false, true, {3, 4}, small}, Case{false, false, {3, -4}, -small},
                           Case{true, true, {3, -4}, 2 * kPi - small}, Case{true, false, {3, 4}, small - 2 * kPi}}) {
    const auto arc = arc_between({0, 0}, {6, 0}, {5, 5}, 0.0, test.is_large, test.turns_to_v);
    REQUIRE(arc.has_value());
    CHECK(distance(arc->center, test.center) < 1e-14);
    CHECK(arc->sweep == Approx(test.sweep).epsilon(1e-14));
    CHECK(distance(on(*arc, 0.0), {0, 0}) < 1e-14);
    CHECK(distance(on(*arc, 1.0), {6, 0}) < 1e-14);
  }
}

TEST_CASE("a turned ellipse passes through both ends and keeps its radii") {
  const double angle = kPi / 6.0;
  const auto arc = arc_between({1, 2}, {3, 1}, {4, 2}, angle, true, true);
  REQUIRE(arc.has_value());
  CHECK(distance(on(*arc, 0.0), {1, 2}) < 1e-13);
  CHECK(distance(on(*arc, 1.0), {3, 1}) < 1e-13);
  CHECK(length(arc->u) == Approx(4.0).epsilon(1e-14));
  CHECK(length(arc->v) == Approx(2.0).epsilon(1e-14));
  CHECK(std::atan2(arc->u.y, arc->u.x) == Approx(angle).epsilon(1e-14));
  CHECK(arc->sweep > kPi);
}

TEST_CASE("radii that do not reach are made larger, and a missing one makes a line") {
  const auto half = arc_between({0, 0}, {6, 0}, {1, 1}, 0.0, false, true);
  REQUIRE(half.has_value());
  CHECK(distance(half->center, {3, 0}) < 1e-15);
  CHECK(length(half->u) == Approx(3.0).epsilon(1e-15));
  CHECK(half->sweep == Approx(kPi).epsilon(1e-15));
  CHECK_FALSE(arc_between({0, 0}, {6, 0}, {0, 1}, 0.0, false, true).has_value());
  CHECK_FALSE(arc_between({1, 1}, {1, 1}, {2, 2}, 0.0, false, true).has_value());
}

TEST_CASE("an affine map moves every piece as it moves its points") {
  const Affine map = Affine::translation(3, -1) * Affine::rotation(0.7) * Affine{2, 0, 0.5, 1, 0, 0};
  PlaneCurve curve({0, 0});
  curve.line_to({1, 0});
  curve.quadratic_to({2, 0}, {2, 1});
  curve.cubic_to({2, 2}, {1, 2}, {1, 3});
  curve.arc_to(*arc_between({1, 3}, {0, 3}, {1, 0.7}, 0.3, true, false), {0, 3});
  PlaneCurve moved = curve;
  moved.transform(map);
  std::vector<Piece> before;
  std::vector<Piece> after;
  curve.for_each_piece([&](const Piece& piece) { before.push_back(piece); });
  moved.for_each_piece([&](const Piece& piece) { after.push_back(piece); });
  REQUIRE(before.size() == 4);
  REQUIRE(after.size() == 4);
  for (std::size_t i = 0; i < 4; ++i)
    for (const double t : {0.0, 0.25, 0.6, 1.0}) {
      CHECK(distance(after[i].at(t), map.of_point(before[i].at(t))) < 1e-13);
      CHECK(distance(after[i].derivative(t), map.of_vector(before[i].derivative(t))) < 1e-12);
    }
}

TEST_CASE("a closed curve ends where it starts") {
  PlaneCurve open({0, 0});
  open.line_to({1, 0});
  open.line_to({1, 1});
  CHECK_FALSE(open.is_closed());
  open.close();
  CHECK(open.is_closed());
  CHECK(open.piece_count() == 3);
  CHECK(open.end() == Vec2{0, 0});

  PlaneCurve back({0, 0});
  back.line_to({1, 0});
  back.line_to({0, 0});
  back.close();
  CHECK(back.piece_count() == 2);
}

TEST_CASE("an arc about a centre far away keeps its height") {
  for (const double radius : {1e6, 1e9, 1e12, 1e15})
    for (const double ratio : {1.0, 3.0, 0.2})  // of the radii
      for (const bool turns_to_v : {false, true}) {
        CAPTURE(radius, ratio, turns_to_v);
        PlaneCurve curve({0, 0});
        curve.arc_to(*arc_between({0, 0}, {6, 0}, {radius, ratio * radius}, 0.0, false, turns_to_v), {6, 0});
        const double height = 6.0 * 6.0 * ratio / (8.0 * radius);  // the circle of curvature has the radius a^2 / b
        REQUIRE(curve.piece_count() == 1);
        curve.for_each_piece([&](const Piece& piece) {
          CHECK(piece.at(0.5).x == Approx(3.0).epsilon(1e-15));
          CHECK(piece.at(0.5).y == Approx(turns_to_v ? -height : height).epsilon(1e-9));
          CHECK(piece.first_direction().y == Approx(4.0 * piece.at(0.5).y / 6.0 * piece.first_direction().x));
        });
      }
  PlaneCurve straight({0, 0});
  if (const auto arc = arc_between({0, 0}, {6, 0}, {1e100, 1e100}, 0.0, false, true)) straight.arc_to(*arc, {6, 0});
  straight.for_each_piece([](const Piece& piece) { CHECK(distance(piece.at(0.5), {3, 0}) < 1e-90); });
  CHECK(straight.piece_count() == 1);
}
