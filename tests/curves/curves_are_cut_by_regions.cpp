// SPDX-License-Identifier: GPL-3.0-or-later
// Curves within regions, against what lies where: points are asked one by one, of polygons with many sides.
#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <vector>

#include "core/base/rng.h"
#include "core/curves/clip_region.h"
#include "core/curves/curve_bounds.h"
#include "tests/curves/curve_parts.h"
#include "tests/support/pi.h"

using namespace mes;
using mes::test::circle_around;
using mes::test::kPi;

namespace {

using Seen = ClippedCurves::Seen;

PlaneCurve box_between(Vec2 low, Vec2 high) {
  PlaneCurve out(low);
  out.line_to({high.x, low.y});
  out.line_to(high);
  out.line_to({low.x, high.y});
  out.close();
  return out;
}

/// Of all kinds of pieces, which may cross each other.
PlaneCurve any_curve(Rng& random, double size) {
  const auto place = [&] { return Vec2{random.uniform(0, size), random.uniform(0, size)}; };
  PlaneCurve out(place());
  const std::uint64_t pieces = 2 + random.below(6);
  for (std::uint64_t i = 0; i < pieces; ++i) {
    const Vec2 to = place();
    switch (random.below(4)) {
      case 0: out.line_to(to); break;
      case 1: out.quadratic_to(place(), to); break;
      case 2: out.cubic_to(place(), place(), to); break;
      default:
        if (const auto arc = arc_between(out.end(), to, {random.uniform(1, size), random.uniform(1, size)},
                                         random.uniform(0, kPi), random.below(2) == 0, random.below(2) == 0))
          out.arc_to(*arc, to);
    }
  }
  out.close();
  return out;
}

std::vector<Vec2> flattened(const PlaneCurve& curve) {
  std::vector<Vec2> out{curve.start()};
  constexpr int kSteps = 400;
  curve.for_each_piece([&](const Piece& piece) {
    const int steps = piece.kind == PieceKind::line ? 1 : kSteps;
    for (int i = 1; i <= steps; ++i) out.push_back(piece.at(static_cast<double>(i) / steps));
  });
  return out;
}

/// A polygon with many sides for each curve.
struct Shape {
  std::vector<std::vector<Vec2>> rings;

  explicit Shape(const std::vector<PlaneCurve>& curves) {
    for (const PlaneCurve& curve : curves) {
      rings.push_back(flattened(curve));
      rings.back().push_back(rings.back().front());
    }
  }
  int winding(Vec2 p) const {
    int out = 0;
    for (const auto& ring : rings)
      for (std::size_t i = 0; i + 1 < ring.size(); ++i) {
        const Vec2 a = ring[i];
        const Vec2 b = ring[i + 1];
        if ((a.y > p.y) == (b.y > p.y)) continue;
        const double side = cross(b - a, p - a);
        if (b.y > a.y && side > 0) ++out;
        if (b.y < a.y && side < 0) --out;
      }
    return out;
  }
  bool holds(Vec2 p, FillRule rule) const {
    return rule == FillRule::nonzero ? winding(p) != 0 : winding(p) % 2 != 0;
  }
  double distance_to(Vec2 p) const {
    double out = 1e300;
    for (const auto& ring : rings)
      for (std::size_t i = 0; i + 1 < ring.size(); ++i) {
        const Vec2 along = ring[i + 1] - ring[i];
        const double share =
            dot(along, along) == 0 ? 0 : std::clamp(dot(p - ring[i], along) / dot(along, along), 0.0, 1.0);
        out = std::min(out, distance(p, ring[i] + share * along));
      }
    return out;
  }
};

double area_of(const std::vector<PlaneCurve>& curves) {
  double twice = 0;
  for (const PlaneCurve& curve : curves) {
    const std::vector<Vec2> corners = flattened(curve);
    for (std::size_t i = 0; i < corners.size(); ++i) twice += cross(corners[i], corners[(i + 1) % corners.size()]);
  }
  return std::abs(twice) / 2;
}

double length_of_all(const std::vector<PlaneCurve>& curves) {
  double out = 0;
  for (const PlaneCurve& curve : curves) {
    const std::vector<Vec2> corners = flattened(curve);
    for (std::size_t i = 0; i + 1 < corners.size(); ++i) out += distance(corners[i], corners[i + 1]);
  }
  return out;
}

const double kGrid = clip_grid(100);

ClipRegion region_of(const PlaneCurve& curve, FillRule rule = FillRule::nonzero) {
  return ClipRegion::of({&curve, 1}, rule, kGrid);
}

}  // namespace

TEST_CASE("boxes of curves hold them, and touch them") {
  Rng random(3);
  for (int i = 0; i < 200; ++i) {
    const std::vector<PlaneCurve> curves{any_curve(random, 10)};
    const Box2 box = bounds_of(curves);
    Box2 found;
    for (const Vec2 p : flattened(curves[0])) found.add(p);
    CHECK(box.low.x <= found.low.x + 1e-12);
    CHECK(box.high.y >= found.high.y - 1e-12);
    CHECK(found.low.x - box.low.x < 2e-3);
    CHECK(found.low.y - box.low.y < 2e-3);
    CHECK(box.high.x - found.high.x < 2e-3);
    CHECK(box.high.y - found.high.y < 2e-3);
  }
}

TEST_CASE("the whole plane and what holds a curve change nothing") {
  Rng random(5);
  for (int i = 0; i < 100; ++i) {
    const std::vector<PlaneCurve> curves{any_curve(random, 10), any_curve(random, 10)};
    const ClipRegion around = region_of(box_between({-50, -50}, {60, 60}));
    for (const Ink ink : {Ink::nonzero_area, Ink::even_odd_area, Ink::line})
      for (const ClipRegion& region : {ClipRegion(), around}) {
        const ClippedCurves clipped = region.clipped(curves, ink);
        CHECK(clipped.seen == Seen::whole);
        CHECK(clipped.curves == curves);
      }
    CHECK(region_of(box_between({70, 70}, {80, 80})).clipped(curves, Ink::line).seen == Seen::nothing);
    CHECK(ClipRegion::of({}, FillRule::nonzero, kGrid).clipped(curves, Ink::nonzero_area).seen == Seen::nothing);
  }
}

TEST_CASE("a curve is in itself whole, also where another one is cut") {
  Rng random(8);
  int whole = 0;
  for (int i = 0; i < 200; ++i) {
    const PlaneCurve curve = any_curve(random, 10);
    const ClippedCurves clipped = region_of(curve).clipped({curve}, Ink::nonzero_area);
    whole += clipped.seen == Seen::whole ? 1 : 0;
    CHECK(region_of(curve).clipped({curve}, Ink::line).curves == std::vector{curve});
  }
  CHECK(whole == 200);
  const PlaneCurve disk = circle_around({3, 3}, 1);
  const ClippedCurves both =
      region_of(box_between({0, 0}, {6, 6})).clipped({disk, box_between({5, 1}, {9, 2})}, Ink::nonzero_area);
  CHECK(both.seen == Seen::part);
  REQUIRE(both.curves.size() == 2);
  CHECK(std::ranges::count(both.curves, disk) == 1);
  CHECK(area_of({both.curves[both.curves[0] == disk ? 1 : 0]}) == Approx(1).epsilon(1e-14));
}

TEST_CASE("a region within a curve is what is left of it") {
  const PlaneCurve disk = circle_around({3, 3}, 2);
  const ClippedCurves left = region_of(disk).clipped({box_between({0, 0}, {6, 6})}, Ink::nonzero_area);
  CHECK(left.seen == Seen::part);
  REQUIRE(left.curves.size() == 1);
  CHECK(left.curves[0].arcs().size() == left.curves[0].piece_count());
  CHECK(area_of(left.curves) == Approx(4 * kPi).epsilon(1e-4));
  CHECK(region_of(disk).clipped({box_between({0, 0}, {6, 6})}, Ink::line).seen == Seen::nothing);
}

TEST_CASE("two circles have a lens in common, whose arcs are theirs and end where they cross") {
  const ClippedCurves lens =
      region_of(circle_around({0, 0}, 5)).clipped({circle_around({6, 0}, 5)}, Ink::nonzero_area);
  REQUIRE(lens.curves.size() == 1);
  const PlaneCurve& curve = lens.curves[0];
  CHECK(curve.is_closed());
  for (const PieceKind kind : curve.kinds()) CHECK(kind == PieceKind::arc);
  for (const Vec2 tip : {Vec2{3, 4}, Vec2{3, -4}})
    CHECK(std::ranges::any_of(curve.points(), [&](Vec2 p) { return distance(p, tip) < 1e-13; }));
  CHECK(bounds_of(lens.curves).low.x == Approx(1).epsilon(1e-13));
  CHECK(bounds_of(lens.curves).high.x == Approx(5).epsilon(1e-13));
}

TEST_CASE("what is left holds the points that both hold, and no others") {
  Rng random(21);
  for (int i = 0; i < 150; ++i) {
    const std::vector<PlaneCurve> curves{any_curve(random, 10), any_curve(random, 10)};
    const std::vector<PlaneCurve> first{any_curve(random, 10)};
    const std::vector<PlaneCurve> second{any_curve(random, 10)};
    const FillRule rule = random.below(2) == 0 ? FillRule::nonzero : FillRule::even_odd;
    const FillRule rule_of_first = random.below(2) == 0 ? FillRule::nonzero : FillRule::even_odd;
    const ClipRegion a = ClipRegion::of(first, rule_of_first, kGrid);
    const ClipRegion b = ClipRegion::of(second, FillRule::nonzero, kGrid);
    const bool is_common = random.below(2) == 0;
    const std::vector<ClipRegion> both{a, b};
    const ClipRegion region = is_common ? ClipRegion::common(a, b) : ClipRegion::united(both, kGrid);
    const ClippedCurves clipped =
        region.clipped(curves, rule == FillRule::nonzero ? Ink::nonzero_area : Ink::even_odd_area);
    const Shape shape(curves);
    const Shape one(first);
    const Shape other(second);
    const Shape result(clipped.curves);
    // Curves that are whole are filled by the rule they had, what was cut by any rule.
    const FillRule rule_of_result = clipped.seen == Seen::whole ? rule : FillRule::even_odd;
    INFO(i);
    for (int k = 0; k < 60; ++k) {
      const Vec2 p{random.uniform(-1, 11), random.uniform(-1, 11)};
      constexpr double kNear = 2e-3;
      if (shape.distance_to(p) < kNear || one.distance_to(p) < kNear || other.distance_to(p) < kNear) continue;
      const bool in_one = one.holds(p, rule_of_first);
      const bool in_other = other.holds(p, FillRule::nonzero);
      const bool is_wanted = shape.holds(p, rule) && (is_common ? in_one && in_other : in_one || in_other);
      CHECK(result.holds(p, rule_of_result) == is_wanted);
    }
    // No piece lies off the curves that were given, and hardly any is a side of a polygon.
    if (clipped.seen != Seen::part) continue;
    for (const PlaneCurve& curve : clipped.curves) {
      CHECK(curve.is_closed());
      curve.for_each_piece([&](const Piece& piece) {
        const Vec2 p = piece.at(0.5);
        CHECK(std::min({shape.distance_to(p), one.distance_to(p), other.distance_to(p)}) < 1e-3);
      });
    }
  }
}

TEST_CASE("of a line those points are left that lie in the region, and no others") {
  Rng random(34);
  for (int i = 0; i < 150; ++i) {
    const std::vector<PlaneCurve> curves{any_curve(random, 10)};
    const std::vector<PlaneCurve> border{any_curve(random, 10)};
    const ClippedCurves inside = region_of(border[0]).clipped(curves, Ink::line);
    const Shape line(curves);
    const Shape region(border);
    const Shape left(inside.curves);
    INFO(i);
    constexpr double kNear = 2e-3;
    for (int k = 0; k < 60; ++k) {
      const auto& corners = line.rings[0];
      const std::size_t side = random.below(corners.size() - 1);
      const Vec2 p = corners[side] + random.uniform() * (corners[side + 1] - corners[side]);
      if (region.distance_to(p) < kNear) continue;
      const auto is_near = [&](const PlaneCurve& part) {
        const std::vector<Vec2> its = flattened(part);
        for (std::size_t n = 0; n + 1 < its.size(); ++n) {
          const Vec2 along = its[n + 1] - its[n];
          const double share =
              dot(along, along) == 0 ? 0 : std::clamp(dot(p - its[n], along) / dot(along, along), 0.0, 1.0);
          if (distance(p, its[n] + share * along) < 0.5 * kNear) return true;
        }
        return false;
      };
      CHECK(std::ranges::any_of(inside.curves, is_near) == (region.winding(p) != 0));
    }
    CHECK(length_of_all(inside.curves) <= length_of_all(curves) * (1 + 1e-9));
    for (const PlaneCurve& part : inside.curves)
      part.for_each_piece([&](const Piece& piece) { CHECK(line.distance_to(piece.at(0.5)) < 1e-3); });
  }
}
