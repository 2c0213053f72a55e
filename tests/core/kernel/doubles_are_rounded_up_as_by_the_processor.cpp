// SPDX-License-Identifier: GPL-3.0-or-later
// The arithmetic that the browser build has instead of a mode of rounding, against this mode: for numbers at random of
// any size, for whole numbers, whose results are often exact, and for the ends of the range.
#include <array>
#include <bit>
#include <catch2/catch.hpp>
#include <cfenv>
#include <cmath>
#include <cstdint>
#include <limits>

#include "core/base/rng.h"
#include "web/include/rounded_up.h"

using namespace mes;

namespace {

using Results = std::array<double, 6>;

Results by_arithmetic(double a, double b) {
  return {
      rounded_up::sum(a, b),      rounded_up::difference(a, b),         rounded_up::product(a, b),
      rounded_up::quotient(a, b), rounded_up::square_root(std::abs(a)), rounded_up::square_root_down(std::abs(a))};
}

// The compiler must not move operations past a change of the mode.
Results by_processor(double first, double second) {
  const volatile double a = first;
  const volatile double b = second;
  const volatile double size = std::abs(first);
  std::array<volatile double, 6> out{};
  std::fesetround(FE_UPWARD);
  out[0] = a + b;
  out[1] = a - b;
  out[2] = a * b;
  out[3] = a / b;
  out[4] = std::sqrt(size);
  std::fesetround(FE_DOWNWARD);
  out[5] = std::sqrt(size);
  std::fesetround(FE_TONEAREST);
  return {out[0], out[1], out[2], out[3], out[4], out[5]};
}

double any_number(Rng& rng) {
  using Limits = std::numeric_limits<double>;
  switch (rng.below(6)) {
    case 0: return std::bit_cast<double>(rng.next());
    case 1: return static_cast<double>(rng.below(2001)) - 1000.0;
    case 2: return std::ldexp(rng.uniform(-1.0, 1.0), static_cast<int>(rng.below(60)) - 30);
    case 3: return std::ldexp(rng.uniform(-1.0, 1.0), -1000 - static_cast<int>(rng.below(80)));
    case 4: return std::ldexp(rng.uniform(-1.0, 1.0), 1000 + static_cast<int>(rng.below(25)));
    default:
      return std::array{0.0,
                        -0.0,
                        Limits::infinity(),
                        -Limits::infinity(),
                        Limits::denorm_min(),
                        -Limits::denorm_min(),
                        Limits::max(),
                        Limits::lowest(),
                        1.0,
                        2.0}[rng.below(10)];
  }
}

}  // namespace

TEST_CASE("sums, products, quotients and roots are rounded up as by the processor") {
  Rng rng(5);
  for (int i = 0; i < 1'000'000; ++i) {
    const double a = any_number(rng);
    const double b = any_number(rng);
    const Results ours = by_arithmetic(a, b);
    const Results expected = by_processor(a, b);
    for (std::size_t k = 0; k < ours.size(); ++k) {
      const bool is_same = ours[k] == expected[k] || (std::isnan(ours[k]) && std::isnan(expected[k]));
      if (is_same) continue;
      CAPTURE(k, a, b, ours[k], expected[k]);
      REQUIRE(is_same);
    }
  }
}
