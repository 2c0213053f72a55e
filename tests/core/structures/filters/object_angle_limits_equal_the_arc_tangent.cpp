// SPDX-License-Identifier: GPL-3.0-or-later
// Limits of object angles against the arc tangent, for corners one by one and for triangles.
#include <array>
#include <catch2/catch.hpp>
#include <cmath>

#include "core/base/rng.h"
#include "core/kernel/corner_angle.h"
#include "core/kernel/enclosing_circle.h"
#include "core/structures/filters/object_angle.h"

using namespace mes;

TEST_CASE("a limit of angles is reached exactly where the angle as a double is, for one corner and for three") {
  Rng rng(9);
  for (int round = 0; round < 100'000; ++round) {
    const bool is_lattice = round % 2 == 0;
    const auto place = [&] {
      return is_lattice ? Vec2{static_cast<double>(rng.below(5)), static_cast<double>(rng.below(5))}
                        : Vec2{rng.uniform(), rng.uniform()};
    };
    const auto unit = [&] { return std::ldexp(1.0, static_cast<int>(rng.below(3)) * 490 - 490); };
    const double common = unit();
    // One side may be long and the other short.
    const bool is_mixed = round % 5 == 0;
    const Vec2 p = is_mixed ? Vec2{} : common * place();
    const Vec2 q = (is_mixed ? unit() : common) * place();
    const Vec2 r = (is_mixed ? unit() : common) * place();
    if (p == q || p == r) continue;
    const double angle = folded(angle_at(p, q, r));
    for (const double degrees : {45.0, 30.0, 90.0, angle, std::nextafter(angle, 0.0), std::nextafter(angle, 99.0)}) {
      if (degrees < 0.0 || degrees > 90.0) continue;
      const AngleLimit limit(degrees);
      const CornerBits expected = static_cast<CornerBits>((angle >= degrees ? kAngleReaches : 0U) |
                                                          (sign_of_corner(p, q, r) >= 0 ? kNotObtuse : 0U));
      REQUIRE(limit.corner(p, q, r) == expected);
      if (q == r) continue;
      REQUIRE(limit.corners(p, q, r) == std::array{expected, limit.corner(q, r, p), limit.corner(r, p, q)});
    }
  }
}
