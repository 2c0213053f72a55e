// SPDX-License-Identifier: GPL-3.0-or-later
// What the quick filter of arcs says is what the exact predicate says.
#include <catch2/catch.hpp>
#include <cmath>

#include "core/base/rng.h"
#include "core/kernel/arc_predicates.h"

namespace mes {
namespace {

double turn_of(const Corners& t) {
  return cross(t.b - t.a, t.c - t.a);
}

Corners turned_left(Corners t) {
  if (turn_of(t) < 0.0) std::swap(t.b, t.c);
  return t;
}

}  // namespace

TEST_CASE("a disk that the filter lets pass by does not meet the arc") {
  Rng random(11);
  std::size_t missed = 0;
  std::size_t not_met = 0;
  // Reals, small integers (where centres coincide and directions run along the ends of arcs), and tiny and huge ones.
  for (int kind = 0; kind < 4; ++kind) {
    const auto place = [&]() -> Vec2 {
      if (kind == 1) return {static_cast<double>(random.below(5)), static_cast<double>(random.below(5))};
      const double scale = kind == 2 ? 0x1p-300 : (kind == 3 ? 0x1p300 : 1.0);
      const double x = random.uniform(-1.0, 1.0);
      return {scale * x, scale * random.uniform(-1.0, 1.0)};
    };
    for (int i = 0; i < 20000; ++i) {
      const Corners own = turned_left({place(), place(), place()});
      const Corners other = turned_left({place(), place(), place()});
      if (!(turn_of(own) > 0.0) || !(turn_of(other) > 0.0)) continue;
      const OuterArc arc{own.a, own.b, own.c};
      const bool meets = meets_arc(arc, other);
      if (!meets && kind == 0) ++not_met;
      if (!ArcFilter(arc).misses(other)) continue;
      if (kind == 0) ++missed;
      REQUIRE_FALSE(meets);
    }
  }
  // It is of use where products of four coordinates are doubles: of disks that do not meet the arc it knows most.
  CHECK(missed > not_met / 2);
}

}  // namespace mes
