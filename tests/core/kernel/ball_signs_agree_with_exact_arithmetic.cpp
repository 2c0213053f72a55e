// SPDX-License-Identifier: GPL-3.0-or-later
// The signs that decide the dual complex, and the power test of triangulations, against integers of any size: for
// balls at random, through a common point up to rounding, on a coarse grid where ties are the rule, and of extreme
// sizes.
#include <CGAL/Mpzf.h>

#include <array>
#include <catch2/catch.hpp>
#include <cmath>

#include "core/base/rng.h"
#include "core/kernel/filtered_kernel.h"

using namespace mes;

namespace {

using Ball = BallOf<double>;

template <class Polynomial>
int exact_sign(Polynomial polynomial, const auto&... ball) {
  using Exact = CGAL::Mpzf;
  return static_cast<int>(CGAL::sign(polynomial(BallOf<Exact>{Exact(ball.x), Exact(ball.y), Exact(ball.w)}...)));
}

Ball through(double x, double y, double px, double py) {
  return {x, y, (px - x) * (px - x) + (py - y) * (py - y)};
}

Ball scaled_ball(const Ball& ball, int exponent) {
  return {std::ldexp(ball.x, exponent), std::ldexp(ball.y, exponent), std::ldexp(ball.w, 2 * exponent)};
}

Ball single_ball(int kind, Rng& rng) {
  const double x = rng.uniform(-1.0, 1.0);
  const double y = rng.uniform(-1.0, 1.0);
  switch (kind) {
    case 0: return {x, y, rng.uniform()};
    case 1: return through(x, y, 0.3, 0.7);
    case 2: return through(1e-6 * x, 1e-6 * y, 0.3, 0.7);
    default: {
      const auto whole = [&rng] { return static_cast<double>(rng.below(4)); };
      return {whole(), whole(), whole() + 1.0};
    }
  }
}

FilteredKernel::Weighted_point_2 weighted_point_of(const Ball& ball) {
  return {FilteredKernel::Point_2(ball.x, ball.y), ball.w};
}

}  // namespace

TEST_CASE("signs of balls are those of integers of any size") {
  Rng rng(1);
  for (int run = 0; run < 20000; ++run) {
    const int kind = run % 4;
    const int exponent = run % 3 == 0 ? 0 : (run % 3 == 1 ? 150 : -180);
    std::array<Ball, 4> b;
    for (Ball& ball : b) ball = scaled_ball(single_ball(kind, rng), exponent);
    CAPTURE(run);
    namespace poly = ball_polynomials;
    CHECK(sign_of_orthogonal_radius<FastKernel>(b[0], b[1], b[2]) ==
          exact_sign([](const auto&... x) { return poly::orthogonal_radius(x...); }, b[0], b[1], b[2]));
    CHECK(sign_of_edge_radius<FastKernel>(b[0], b[1]) ==
          exact_sign([](const auto&... x) { return poly::edge_radius(x...); }, b[0], b[1]));
    CHECK(sign_of_excess_at_foot<FastKernel>(b[0], b[1], b[2]) ==
          exact_sign([](const auto&... x) { return poly::excess_at_foot(x...); }, b[0], b[1], b[2]));
    const int at_center =
        exact_sign([](const auto&... x) { return poly::excess_at_center(x...); }, b[0], b[1], b[2], b[3]);
    CHECK(sign_of_excess_at_center<FastKernel>(b[0], b[1], b[2], b[3]) == at_center);
    const FilteredKernel kernel;
    const FastKernel plain;
    const auto ours = kernel.power_side_of_oriented_power_circle_2_object();
    const auto theirs = plain.power_side_of_oriented_power_circle_2_object();
    CHECK(ours(weighted_point_of(b[0]), weighted_point_of(b[1]), weighted_point_of(b[2]), weighted_point_of(b[3])) ==
          theirs(weighted_point_of(b[0]), weighted_point_of(b[1]), weighted_point_of(b[2]), weighted_point_of(b[3])));
  }
}

TEST_CASE("a number of two doubles knows its sign or says that it does not") {
  const TwoDoubles tiny = TwoDoubles::difference(1.0 + 0x1p-45, 1.0);
  CHECK((tiny * tiny).sign() == 1);
  // (1 + e)^2 - 1 - 2 e = e^2 is below the last bit of a double.
  const TwoDoubles one_and = TwoDoubles(1.0) + tiny;
  CHECK((one_and * one_and - TwoDoubles(1.0) - TwoDoubles(2.0) * tiny).sign() == 1);
  const TwoDoubles third = TwoDoubles(0.1) * TwoDoubles(0.3);
  CHECK((third - third).sign() == 0);
  const TwoDoubles vast(1e200);
  CHECK((vast * vast - vast * vast).sign() == 0);
  const TwoDoubles small(1e-200);
  CHECK((small * small).sign() == 0);
}
