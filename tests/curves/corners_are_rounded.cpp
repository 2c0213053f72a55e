// SPDX-License-Identifier: GPL-3.0-or-later
#include <catch2/catch.hpp>
#include <cmath>

#include "core/curves/corners.h"
#include "core/curves/interpolation/smooth_curve.h"
#include "core/curves/nearest_place.h"
#include "core/curves/sampling.h"
#include "tests/curves/curve_parts.h"
#include "tests/support/pi.h"

using namespace mes;
using mes::test::kPi;
using mes::test::polygon;

namespace {

constexpr double kCorner = 0.5;

double length_by_chords(const PlaneCurve& curve) {
  double sum = 0.0;
  constexpr int kChords = 20'000;
  curve.for_each_piece([&](const Piece& piece) {
    for (int i = 0; i < kChords; ++i)
      sum += distance(piece.at(static_cast<double>(i) / kChords), piece.at((i + 1.0) / kChords));
  });
  return sum;
}

/// Each kind of piece once.
std::vector<Piece> some_pieces() {
  PlaneCurve curve({0, 0});
  curve.line_to({1, 0});
  curve.quadratic_to({2, 0}, {2, 1});
  curve.cubic_to({2, 2}, {1, 2}, {1, 3});
  curve.arc_to(*arc_between({1, 3}, {0, 3}, {1, 0.7}, 0.3, true, false), {0, 3});
  std::vector<Piece> out;
  curve.for_each_piece([&](const Piece& piece) { out.push_back(piece); });
  return out;
}

}  // namespace

TEST_CASE("a part of a piece runs along the piece") {
  for (const Piece& piece : some_pieces())
    for (const auto& [begin, end] :
         {std::pair(0.0, 1.0), std::pair(0.0, 0.3), std::pair(0.25, 0.8), std::pair(0.6, 1.0)}) {
      const Piece part = piece.part(begin, end);
      CHECK(part.kind == piece.kind);
      for (const double t : {0.0, 0.2, 0.5, 0.9, 1.0})
        CHECK(distance(part.at(t), piece.at(begin + t * (end - begin))) < 1e-14);
    }
}

TEST_CASE("a curve is put together again from its parts, and from nothing that does not fit") {
  PlaneCurve curve({0, 0});
  for (const Piece& piece : some_pieces()) curve.add(piece);
  auto again = PlaneCurve::of_parts(curve.points(), curve.kinds(), curve.arcs(), false);
  REQUIRE(again);
  CHECK(*again == curve);
  CHECK_FALSE(again->is_polyline());
  CHECK_FALSE(PlaneCurve::of_parts(curve.points(), curve.kinds(), curve.arcs(), true));
  CHECK_FALSE(PlaneCurve::of_parts(curve.points(), curve.kinds(), {}, false));
  CHECK_FALSE(PlaneCurve::of_parts({}, {}, {}, false));
  CHECK_FALSE(PlaneCurve::of_parts({{0, 0}}, {PieceKind::line}, {}, false));
  CHECK(PlaneCurve::of_parts({{0, 0}, {1, 0}}, {PieceKind::line}, {}, false)->is_polyline());
}

TEST_CASE("corners are where a polygon has them, with the angle between its sides") {
  const CurveSet shapes{.curves = {polygon({{0, 0}, {4, 0}, {0, 3}}), polygon({{0, 0}, {1, 0}, {1, 1}}, false)}};
  const std::vector<CurveCorner> corners = corners_of(shapes, kCorner);
  REQUIRE(corners.size() == 4);
  std::vector<double> angles;
  for (const CurveCorner& corner : corners) {
    CHECK(corner.curve == (corner.place == Vec2{1, 0} ? 1U : 0U));
    angles.push_back(corner.angle);
    if (corner.place == Vec2{0, 0}) CHECK(corner.angle == Approx(kPi / 2));
    if (corner.place == Vec2{4, 0}) CHECK(corner.angle == Approx(std::atan2(3, 4)));
    if (corner.place == Vec2{0, 3}) CHECK(corner.angle == Approx(std::atan2(4, 3)));
  }
  // A bend below the limit is none, and neither is the start of a circle.
  CHECK(corners_of({.curves = {polygon({{0, 0}, {1, 0}, {2, 0.3}}, false)}}, kCorner).empty());
  PlaneCurve circle({1, 0});
  circle.arc_to({{0, 0}, {1, 0}, {0, 1}, 0.0, 2 * kPi}, {1, 0});
  circle.close();
  CHECK(corners_of({.curves = {circle}}, kCorner).empty());
}

TEST_CASE("round corners of a polygon are arcs of the radius, tangent to its sides") {
  const CurveSet square{.curves = {polygon({{0, 0}, {4, 0}, {4, 4}, {0, 4}})}};
  const CurveSet round = with_round_corners(square, kCorner, 1.0);
  REQUIRE(round.curves.size() == 1);
  CHECK(round.curves[0].is_closed());
  CHECK(corners_of(round, 1e-6).empty());
  CHECK(length_by_chords(round.curves[0]) == Approx(8.0 + 2 * kPi).epsilon(1e-7));
  round.curves[0].for_each_piece([](const Piece& piece) {
    for (const double t : {0.1, 0.5, 0.9}) {
      const Vec2 p = piece.at(t);
      if (piece.kind != PieceKind::arc) continue;
      const Vec2 center{p.x < 2 ? 1.0 : 3.0, p.y < 2 ? 1.0 : 3.0};
      CHECK(distance(center, p) == Approx(1.0).epsilon(1e-12));
    }
  });
  // A radius that no side has room for: half of each side is given up.
  const CurveSet full = with_round_corners(square, kCorner, 50.0);
  CHECK(length_by_chords(full.curves[0]) == Approx(4 * kPi).epsilon(1e-7));
  // The largest radius of a square that stands anyhow: it becomes its circle, whatever is lost to rounding.
  for (int degrees = 0; degrees < 360; degrees += 7) {
    std::vector<Vec2> corners;
    for (int i = 0; i < 4; ++i) {
      const double angle = kPi / 180.0 * (degrees + 90.0 * i);
      corners.push_back({5 + std::sqrt(2.0) * std::cos(angle), 7 + std::sqrt(2.0) * std::sin(angle)});
    }
    for (const double radius : {1.0, 0.999999, 2.0}) {
      const CurveSet circle = with_round_corners({.curves = {polygon(corners)}}, kCorner, radius);
      const auto samples = sample(circle, {.rule = SamplingRule::count, .count = 60});
      REQUIRE(samples);
      CHECK(samples->positions.size() >= 50);
      for (const Vec2 p : samples->positions) CHECK(distance(p, {5, 7}) == Approx(1.0).epsilon(1e-5));
    }
  }
  // An open curve keeps its ends.
  const CurveSet open = with_round_corners({.curves = {polygon({{0, 0}, {2, 0}, {2, 2}}, false)}}, kCorner, 0.5);
  CHECK(open.curves[0].start() == Vec2{0, 0});
  CHECK(open.curves[0].end() == Vec2{2, 2});
  CHECK(length_by_chords(open.curves[0]) == Approx(3.0 + kPi / 4).epsilon(1e-7));
}

TEST_CASE("corners with curved sides become smooth, too, and smooth curves stay as they are") {
  // A lens of two arcs, with corners of 60 degrees.
  PlaneCurve lens({-1, 0});
  const double height = std::sqrt(3.0);
  lens.arc_to(*arc_between({-1, 0}, {1, 0}, {2, 2}, 0.0, false, true), {1, 0});
  lens.arc_to(*arc_between({1, 0}, {-1, 0}, {2, 2}, 0.0, false, true), {-1, 0});
  lens.close();
  REQUIRE(corners_of({.curves = {lens}}, kCorner).size() == 2);
  const CurveSet round = with_round_corners({.curves = {lens}}, kCorner, 0.1);
  CHECK(corners_of(round, 1e-4).empty());
  round.curves[0].for_each_piece([&](const Piece& piece) {
    for (const double t : {0.0, 0.3, 0.7}) {
      // Within both disks of which the lens is the intersection.
      CHECK(distance(piece.at(t), {0, height}) < 2 + 1e-12);
      CHECK(distance(piece.at(t), {0, -height}) < 2 + 1e-12);
    }
  });
  PlaneCurve circle({1, 0});
  circle.arc_to({{0, 0}, {1, 0}, {0, 1}, 0.0, 2 * kPi}, {1, 0});
  circle.close();
  CHECK(with_round_corners({.curves = {circle}}, kCorner, 0.1).curves[0] == circle);
}

TEST_CASE("the nearest place of curves is as near as any that is looked at") {
  CurveSet curves;
  PlaneCurve& curve = curves.curves.emplace_back(Vec2{0, 0});
  for (const Piece& piece : some_pieces()) curve.add(piece);
  curves.curves.push_back(polygon({{5, 5}, {6, 7}, {8, 5}}));
  for (double x = -1; x < 9; x += 0.7)
    for (double y = -1; y < 8; y += 0.7) {
      double least = 1e9;
      for (const PlaneCurve& each : curves.curves)
        each.for_each_piece([&](const Piece& piece) {
          for (int i = 0; i <= 2000; ++i) least = std::min(least, distance(piece.at(i / 2000.0), {x, y}));
        });
      const auto place = nearest_place(curves, {x, y}, 100);
      REQUIRE(place);
      CHECK(distance(*place, {x, y}) <= least + 1e-9);
      CHECK(distance(*place, {x, y}) >= least - 2e-3);
      CHECK(nearest_place(curves, {x, y}, 1.001 * least + 1e-9).has_value());
      CHECK_FALSE(nearest_place(curves, {x, y}, 0.99 * least - 1e-4).has_value());
    }
  CHECK_FALSE(nearest_place({.points = {{0, 0}}}, {0, 0}, 1));
}

TEST_CASE("a smooth curve passes through its points and is a circle where these are dense on one") {
  std::vector<Vec2> points;
  constexpr int kPoints = 40;
  for (int i = 0; i < kPoints; ++i)
    points.push_back({std::cos(2 * kPi * i / kPoints), std::sin(2 * kPi * i / kPoints)});
  const PlaneCurve curve = smooth_curve(points, true, 0.9);
  CHECK(curve.is_closed());
  CHECK(curve.piece_count() == kPoints);
  std::size_t i = 0;
  curve.for_each_piece([&](const Piece& piece) {
    CHECK(piece.from() == points[i++]);
    // The sagitta of a chord is 3e-3.
    for (const double t : {0.25, 0.5, 0.75}) CHECK(std::abs(length(piece.at(t)) - 1.0) < 2e-5);
  });
  // A right angle stays one; two points are a line, and one is a point.
  const PlaneCurve corner = smooth_curve(std::vector<Vec2>{{0, 0}, {1, 0}, {2, 0}, {2, 1}, {2, 2}}, false, 0.9);
  CHECK(corners_of({.curves = {corner}}, kCorner).size() == 1);
  CHECK(smooth_curve(std::vector<Vec2>{{0, 0}, {1, 0}}, true, 0.9).is_polyline());
  CHECK(smooth_curve(std::vector<Vec2>{{3, 4}, {3, 4}}, true, 0.9).piece_count() == 0);
}
