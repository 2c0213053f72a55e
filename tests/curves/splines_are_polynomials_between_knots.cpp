// SPDX-License-Identifier: GPL-3.0-or-later
// Against the definition by basis functions (Cox and de Boor), and where the curve is known.
#include <catch2/catch.hpp>
#include <cmath>

#include "core/base/rng.h"
#include "core/curves/interpolation/b_spline.h"
#include "tests/curves/curve_parts.h"

using namespace mes;
using mes::test::pieces_of;

namespace {

/// The basis function by its recursion.
double basis(const std::vector<double>& knots, std::size_t i, std::size_t degree, double t) {
  if (degree == 0) return knots[i] <= t && t < knots[i + 1] ? 1.0 : 0.0;
  const auto part = [](double above, double below, double value) {
    return below > 0.0 ? above / below * value : 0.0;
  };
  return part(t - knots[i], knots[i + degree] - knots[i], basis(knots, i, degree - 1, t)) +
         part(knots[i + degree + 1] - t, knots[i + degree + 1] - knots[i + 1], basis(knots, i + 1, degree - 1, t));
}

Vec2 by_definition(const BSpline& spline, double t) {
  Vec2 sum;
  double weight = 0.0;
  for (std::size_t i = 0; i < spline.controls.size(); ++i) {
    const double w = (spline.weights.empty() ? 1.0 : spline.weights[i]) * basis(spline.knots, i, spline.degree, t);
    sum = sum + w * spline.controls[i];
    weight += w;
  }
  return (1.0 / weight) * sum;
}

}  // namespace

TEST_CASE("each span of a spline is its polynomial") {
  Rng rng(7);
  for (const std::size_t degree : {1U, 2U, 3U, 5U}) {
    BSpline spline{.degree = degree};
    for (int i = 0; i < 9; ++i) spline.controls.push_back({rng.uniform(-1, 1), rng.uniform(-1, 1)});
    double knot = 0.0;
    for (std::size_t i = 0; i < 9 + degree + 1; ++i) spline.knots.push_back(knot += rng.uniform(0.1, 1.0));
    const auto curve = curve_of_spline(spline);
    REQUIRE(curve.has_value());
    const std::vector<Piece> pieces = pieces_of(*curve);
    const std::size_t each = degree > 3 ? 32 : 1;
    REQUIRE(pieces.size() == (9 - degree) * each);
    for (std::size_t span = 0; span < 9 - degree; ++span)
      for (std::size_t k = 0; k < each; ++k)
        for (const double t : {0.0, 0.3, 0.5, 0.9}) {
          const double low = spline.knots[degree + span];
          const double high = spline.knots[degree + span + 1];
          const double at = low + (high - low) * (static_cast<double>(k) + t) / static_cast<double>(each);
          const Vec2 wanted = by_definition(spline, at);
          CHECK(distance(pieces[span * each + k].at(t), wanted) < (degree > 3 ? 1e-6 : 1e-13));
        }
  }
}

TEST_CASE("repeated knots make ends and corners, and a rational quadratic is a circle") {
  const auto clamped = curve_of_spline(BSpline::clamped(3, {{0, 0}, {1, 2}, {3, 2}, {4, 0}, {6, 0}}));
  REQUIRE(clamped.has_value());
  CHECK(clamped->start() == Vec2{0, 0});
  CHECK(distance(clamped->end(), {6, 0}) < 1e-14);
  const auto bezier = curve_of_spline(BSpline::clamped(3, {{0, 0}, {1, 2}, {3, 2}, {4, 0}}));
  REQUIRE(bezier.has_value());
  REQUIRE(bezier->piece_count() == 1);
  CHECK(distance(pieces_of(*bezier)[0].points[1], {1, 2}) < 1e-14);
  CHECK(distance(pieces_of(*bezier)[0].points[2], {3, 2}) < 1e-14);

  const double h = std::sqrt(0.5);
  const auto circle =
      curve_of_spline({.degree = 2,
                       .knots = {0, 0, 0, 1, 1, 2, 2, 3, 3, 4, 4, 4},
                       .controls = {{1, 0}, {1, 1}, {0, 1}, {-1, 1}, {-1, 0}, {-1, -1}, {0, -1}, {1, -1}, {1, 0}},
                       .weights = {1, h, 1, h, 1, h, 1, h, 1}});
  REQUIRE(circle.has_value());
  CHECK(circle->end() == circle->start());
  circle->for_each_piece([](const Piece& piece) {
    for (const double t : {0.0, 0.25, 0.5, 0.8}) CHECK(length(piece.at(t)) == Approx(1.0).epsilon(1e-6));
  });
}

TEST_CASE("a closed uniform spline ends where it begins, and is smooth there") {
  const auto curve = curve_of_spline(BSpline::closed(3, {{0, 0}, {1, 0}, {1.1, 1}, {0, 1.3}}));
  REQUIRE(curve.has_value());
  CHECK(curve->piece_count() == 4);
  CHECK(curve->end() == curve->start());
  const std::vector<Piece> pieces = pieces_of(*curve);
  CHECK(distance(pieces.front().derivative(0.0), pieces.back().derivative(1.0)) < 1e-12);
}

TEST_CASE("what is no spline gives nothing") {
  const std::vector<Vec2> four{{0, 0}, {1, 0}, {1, 1}, {0, 1}};
  CHECK_FALSE(curve_of_spline({}).has_value());
  CHECK_FALSE(curve_of_spline({.degree = 0, .knots = {0, 1, 2, 3, 4}, .controls = four}).has_value());
  CHECK_FALSE(curve_of_spline({.degree = 3, .knots = {0, 0, 0, 0, 1, 1, 1}, .controls = four}).has_value());
  CHECK_FALSE(curve_of_spline({.degree = 3, .knots = {0, 0, 0, 0, 1, 1, 1, 0}, .controls = four}).has_value());
  CHECK_FALSE(curve_of_spline({.degree = 3, .knots = {0, 0, 0, 0, 0, 0, 0, 0}, .controls = four}).has_value());
  CHECK_FALSE(
      curve_of_spline({.degree = 3, .knots = {0, 0, 0, 0, 1, 1, 1, 1}, .controls = four, .weights = {1, 0, 1, 1}})
          .has_value());
  CHECK_FALSE(curve_of_spline({.degree = 3, .knots = {0, 0, 0, 0, NAN, 1, 1, 1}, .controls = four}).has_value());
  CHECK_FALSE(curve_of_spline(BSpline::clamped(3, {{0, 0}, {1, 1}})).has_value());
}

TEST_CASE("inner knots of full multiplicity end a piece, and a spline that jumps there is two curves") {
  BSpline spline{.degree = 3,
                 .knots = {0, 0, 0, 0, 1, 1, 1, 1, 2, 2, 2, 2},
                 .controls = {{0, 0}, {0, 3}, {3, 6}, {6, 6}, {6, 6}, {9, 6}, {9, 0}, {0, 0}}};
  const auto curve = curve_of_spline(spline);
  REQUIRE(curve.has_value());
  const std::vector<Piece> pieces = pieces_of(*curve);
  REQUIRE(pieces.size() == 2);
  for (std::size_t i = 0; i < 8; ++i) CHECK(distance(pieces[i / 4].points[i % 4], spline.controls[i]) < 1e-13);
  CHECK(curve->start() == curve->end());

  BSpline jumping = spline;
  for (std::size_t i = 4; i < 8; ++i) jumping.controls[i] = jumping.controls[i] + Vec2{100, 0};
  CHECK_FALSE(curve_of_spline(jumping).has_value());
  const std::vector<PlaneCurve> two = curves_of_spline(jumping);
  REQUIRE(two.size() == 2);
  CHECK(distance(two[0].end(), {6, 6}) < 1e-13);
  CHECK(distance(two[1].start(), {106, 6}) < 1e-13);

  // More knots at one place than that leave a control without effect, and rounded knots are one.
  BSpline idle = spline;
  idle.knots.insert(idle.knots.begin() + 4, 1.0);
  idle.controls.insert(idle.controls.begin() + 4, {500, 500});
  REQUIRE(curve_of_spline(idle).has_value());
  CHECK(*curve_of_spline(idle) == *curve);
  BSpline rounded = spline;
  rounded.knots[5] = 1.0 - 1e-9;
  rounded.knots[6] = 1.0 + 1e-12;
  REQUIRE(curve_of_spline(rounded).has_value());
  CHECK(curve_of_spline(rounded)->piece_count() == 2);
  BSpline decreasing = spline;
  decreasing.knots[5] = 0.9;
  CHECK(curves_of_spline(decreasing).empty());
}
