// SPDX-License-Identifier: GPL-3.0-or-later
// The test of triangulations for a point in a circle, against integers of any length and the kernel's own answer: for
// points at random, neighbours on smooth curves, thin quadrilaterals across a shape, a coarse grid where ties are the
// rule, far from the origin, of mixed and of extreme sizes.
#include <CGAL/Mpzf.h>

#include <array>
#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>

#include "core/base/rng.h"
#include "core/kernel/filtered_kernel.h"

using namespace mes;

namespace {

using Four = std::array<Vec2, 4>;

Vec2 on_curve(double t) {
  const double r = 1.0 + 0.2 * std::cos(5.0 * t);
  return {r * std::cos(t), r * std::sin(t)};
}

Four points_of(int kind, Rng& rng) {
  Four out;
  const double t = rng.uniform(0.0, 2.0 * std::numbers::pi);
  const double h = std::pow(10.0, rng.uniform(-8.0, -2.0));
  for (std::size_t i = 0; i < 4; ++i) {
    const auto step = static_cast<double>(i);
    Vec2& p = out[i];
    switch (kind) {
      case 0: p = {rng.uniform(-1.0, 1.0), rng.uniform(-1.0, 1.0)}; break;
      case 1: p = on_curve(t + h * step); break;
      case 2: p = on_curve((i < 2 ? t : t + 3.0) + h * step); break;
      case 3: p = {static_cast<double>(rng.below(4)), static_cast<double>(rng.below(4))}; break;
      case 4: p = 0x1p40 * Vec2{1.0, 1.0} + on_curve(t + step); break;
      case 5: p = std::ldexp(1.0, static_cast<int>(rng.below(100)) - 50) * on_curve(t + step); break;
      default: p = {std::cos(t + step), std::sin(t + step)}; break;  // cocircular up to rounding
    }
  }
  return out;
}
constexpr int kKinds = 7;

FilteredKernel::Point_2 point_of(Vec2 p) {
  return {p.x, p.y};
}

}  // namespace

TEST_CASE("the side of a circle is that of integers of any length") {
  Rng rng(1);
  std::array<int, 3> met{};
  for (int run = 0; run < 21000; ++run) {
    Four p = points_of(run % kKinds, rng);
    const int exponent = std::array{0, 0, 120, -130, 390, -390}[static_cast<std::size_t>(run / kKinds % 6)];
    for (Vec2& place : p) place = {std::ldexp(place.x, exponent), std::ldexp(place.y, exponent)};
    CAPTURE(run);
    const int exact = static_cast<int>(CGAL::sign(circle_polynomials::in_circle<CGAL::Mpzf>(p[0], p[1], p[2], p[3])));
    ++met[static_cast<std::size_t>(exact + 1)];
    CHECK(sign_of_in_circle(p[0], p[1], p[2], p[3]) == exact);
    // Two that change places turn the side over, wherever the fourth point, which serves as origin, then is.
    CHECK(sign_of_in_circle(p[1], p[0], p[2], p[3]) == -exact);
    CHECK(sign_of_in_circle(p[3], p[1], p[2], p[0]) == -exact);
    const auto ours = FilteredKernel().side_of_oriented_circle_2_object();
    const auto theirs = FastKernel().side_of_oriented_circle_2_object();
    CHECK(ours(point_of(p[0]), point_of(p[1]), point_of(p[2]), point_of(p[3])) ==
          theirs(point_of(p[0]), point_of(p[1]), point_of(p[2]), point_of(p[3])));
  }
  for (const int count : met) CHECK(count > 100);
}

TEST_CASE("what doubles leave open across a densely sampled shape, twice their length decides") {
  Rng rng(2);
  int open = 0;
  for (int run = 0; run < 1000; ++run) {
    const double t = rng.uniform(0.0, 2.0 * std::numbers::pi);
    const double h = 1e-7;
    const Vec2 a = on_curve(t), b = on_curve(t + h), c = on_curve(-t), d = on_curve(-t - rng.uniform(0.9, 1.1) * h);
    if (circle_polynomials::quick_in_circle(a, b, c, d) != 0) continue;
    ++open;
    const TwoDoubles longer = circle_polynomials::in_circle<GivenDouble>(a, b, c, d);
    CHECK(longer.sign() != 0);
  }
  CHECK(open > 100);
}
