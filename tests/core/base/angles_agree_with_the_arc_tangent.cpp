// SPDX-License-Identifier: GPL-3.0-or-later
// Angles against the arc tangent in long doubles.
#include <algorithm>
#include <bit>
#include <catch2/catch.hpp>
#include <cmath>
#include <cstdint>
#include <limits>

#include "core/base/geometry/angle.h"
#include "core/base/rng.h"

using namespace mes;

TEST_CASE("an angle is the arc tangent within four units in the last place, for vectors of any size") {
  Rng rng(3);
  double worst = 0.0;
  for (int i = 0; i < 200'000; ++i) {
    const auto size = [&] { return i % 2 == 0 ? 0 : static_cast<int>(rng.below(1900)) - 950; };
    const Vec2 v{std::ldexp(rng.uniform(-1.0, 1.0), size()), std::ldexp(rng.uniform(-1.0, 1.0), size())};
    const long double exact = std::atan2(static_cast<long double>(v.y), static_cast<long double>(v.x));
    const double rounded = std::abs(static_cast<double>(exact));
    const double unit = std::nextafter(rounded, 4.0) - rounded;
    worst = std::max(worst, static_cast<double>(std::abs(angle_of(v) - exact)) / unit);
    REQUIRE(angle_of({v.x, -v.y}) == -angle_of(v));
  }
  CHECK(worst < 4.0);
  CHECK(worst > 0.1);
}

TEST_CASE("eighths of turns are exact, and the signs of zeros count as for the arc tangent") {
  for (const double x : {1.0, 0.0, -0.0, -1.0})
    for (const double y : {1.0, 0.0, -0.0, -1.0}) {
      INFO(x << " " << y);
      CHECK(angle_of({x, y}) == std::atan2(y, x));
      CHECK(std::signbit(angle_of({x, y})) == std::signbit(std::atan2(y, x)));
    }
  const double least = std::numeric_limits<double>::denorm_min();
  CHECK(angle_of({1.0, least}) == least);
}

// The functions of the C library do not pass this on each processor.
TEST_CASE("angles have the same bits on each machine") {
  Rng rng(7);
  std::uint64_t sum = 0;
  for (int i = 0; i < 10'000; ++i)
    sum =
        std::rotl(sum, 5) + std::bit_cast<std::uint64_t>(angle_of({rng.uniform(-1.0, 1.0), rng.uniform(-1.0, 1.0)}));
  CHECK(sum == 0xd3fe4176eaaefa7bULL);
}
