// SPDX-License-Identifier: GPL-3.0-or-later
// Arcs, and lengths of vectors where sums of many are taken.
#include <catch2/catch.hpp>
#include <cmath>
#include <limits>
#include <numbers>

#include "core/base/geometry/arc.h"
#include "core/base/geometry/quick_length.h"
#include "core/base/rng.h"

using namespace mes;

namespace {

constexpr double kTurn = 2.0 * std::numbers::pi;

Vec2 on_circle(Vec2 center, double radius, double angle) {
  return center + radius * Vec2{std::cos(angle), std::sin(angle)};
}

}  // namespace

TEST_CASE("an arc turns through the angle from its first end to its second, counter-clockwise") {
  Rng rng(1);
  for (int i = 0; i < 1000; ++i) {
    const Vec2 center{rng.uniform(-3.0, 3.0), rng.uniform(-3.0, 3.0)};
    const double radius = std::pow(10.0, rng.uniform(-3.0, 3.0));
    const double from = rng.uniform(-9.0, 9.0);
    const double sweep = rng.uniform(0.01, kTurn - 0.01);
    const Arc arc{center, radius, on_circle(center, radius, from), on_circle(center, radius, from + sweep)};
    CAPTURE(center.x, center.y, radius, from);
    CHECK(sweep_of(arc) == Approx(sweep).margin(1e-12));
    CHECK(sweep_of({center, radius, arc.to, arc.from}) == Approx(kTurn - sweep).margin(1e-12));
  }
}

TEST_CASE("ends one last bit apart are a short arc one way and nearly a circle the other, equal ends a circle") {
  const Vec2 center{0.125, -0.25};
  const Vec2 right{1.375, -0.25};
  const Vec2 above{1.375, std::nextafter(-0.25, 0.0)};
  CHECK(sweep_of({center, 1.25, right, above}) == Approx((above.y - right.y) / 1.25).epsilon(1e-10));
  CHECK(sweep_of({center, 1.25, above, right}) == Approx(kTurn));
  CHECK(sweep_of({center, 1.25, right, right}) == kTurn);
  CHECK(sweep_of({center, 0.0, center, center}) == kTurn);
}

TEST_CASE("size does not matter to an arc") {
  for (const double size : {1e-300, 1e-150, 1.0, 1e150, 1e300})
    CHECK(sweep_of({{}, size, {size, 0.0}, {0.0, -size}}) == Approx(0.75 * kTurn));
}

TEST_CASE("the box of an arc holds every point of it and touches it on each side") {
  Rng rng(2);
  for (int i = 0; i < 300; ++i) {
    const Vec2 center{rng.uniform(-3.0, 3.0), rng.uniform(-3.0, 3.0)};
    const double radius = rng.uniform(0.1, 5.0);
    // Every other one begins or ends on an axis.
    const double from = i % 2 == 0 ? 0.25 * kTurn * static_cast<double>(i % 8 / 2) : rng.uniform(0.0, kTurn);
    const double sweep = i % 4 < 2 ? rng.uniform(0.01, kTurn - 0.01) : 0.25 * kTurn * static_cast<double>(i % 3 + 1);
    const Box2 box = bounding_box_of(
        Arc{center, radius, on_circle(center, radius, from), on_circle(center, radius, from + sweep)});
    Box2 seen;
    constexpr int kSteps = 4000;
    for (int k = 0; k <= kSteps; ++k) seen.add(on_circle(center, radius, from + sweep * k / kSteps));
    CAPTURE(i, from, sweep);
    CHECK(box.low.x == Approx(seen.low.x).margin(1e-5));
    CHECK(box.low.y == Approx(seen.low.y).margin(1e-5));
    CHECK(box.high.x == Approx(seen.high.x).margin(1e-5));
    CHECK(box.high.y == Approx(seen.high.y).margin(1e-5));
  }
  CHECK(bounding_box_of(Arc{{1, 2}, 3, {4, 2}, {4, 2}}) == Box2{{-2, -1}, {4, 5}});
}

TEST_CASE("a quick length has a relative error of 2^-52, in any unit of length") {
  Rng rng(4);
  const auto component = [&rng] {
    const double size = std::ldexp(1.0 + rng.uniform(), static_cast<int>(rng.below(80)) - 40);
    return rng.below(2) == 0 ? size : -size;
  };
  for (int i = 0; i < 20000; ++i) {
    const Vec2 a{rng.below(20) == 0 ? 0.0 : component(), rng.below(20) == 0 ? 0.0 : component()};
    const double found = quick_length(a);
    const long double exact = std::sqrt(static_cast<long double>(a.x) * a.x + static_cast<long double>(a.y) * a.y);
    if (!(std::abs(exact - found) <= 0x1.001p-52L * exact)) FAIL(a.x << ", " << a.y << ": " << found);
    // From the range of squares to where these are zero or infinite.
    for (const int exponent : {-900, -560, -490, -450, -300, 300, 440, 499, 510, 560, 900}) {
      const Vec2 scaled{std::ldexp(a.x, exponent), std::ldexp(a.y, exponent)};
      if (quick_length(scaled) != std::ldexp(found, exponent)) FAIL(a.x << ", " << a.y << " times 2^" << exponent);
    }
  }
  CHECK(quick_length({}) == 0.0);
  CHECK(quick_length({3.0, -4.0}) == 5.0);
  CHECK(std::isinf(quick_length({std::numeric_limits<double>::infinity(), 1.0})));
  CHECK(std::isnan(quick_length({std::numeric_limits<double>::quiet_NaN(), 1.0})));
}
