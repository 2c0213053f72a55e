// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <utility>
#include <vector>

#include "core/base/rng.h"
#include "core/curves/filled_area.h"
#include "tests/curves/curve_parts.h"

using namespace mes;
using mes::test::circle_around;
using mes::test::kPi;
using mes::test::polygon;

namespace {

/// The corners of a polygon that is near the curve.
std::vector<Vec2> near_polygon(const PlaneCurve& curve) {
  constexpr int kSteps = 400;
  std::vector<Vec2> out;
  curve.for_each_piece([&](const Piece& piece) {
    const int steps = piece.kind == PieceKind::line ? 1 : kSteps;
    for (int i = 0; i < steps; ++i) out.push_back(piece.at(static_cast<double>(i) / steps));
  });
  return out;
}

/// How often the curves go around a point, and how far the nearest of their lines is.
struct Around {
  int winding = 0;
  int crossings = 0;
  double distance = 1e300;
};
Around around(const std::vector<PlaneCurve>& curves, Vec2 p) {
  Around out;
  for (const PlaneCurve& curve : curves) {
    const std::vector<Vec2> corners = near_polygon(curve);
    for (std::size_t i = 0; i < corners.size(); ++i) {
      const Vec2 a = corners[i];
      const Vec2 b = corners[(i + 1) % corners.size()];
      const Vec2 along = b - a;
      const double t = std::clamp(dot(p - a, along) / std::max(dot(along, along), 1e-300), 0.0, 1.0);
      out.distance = std::min(out.distance, length(p - (a + t * along)));
      if ((a.y > p.y) == (b.y > p.y)) continue;
      if (cross(along, p - a) * (b.y > a.y ? 1.0 : -1.0) <= 0.0) continue;
      out.winding += b.y > a.y ? 1 : -1;
      ++out.crossings;
    }
  }
  return out;
}

void check_points(const std::vector<PlaneCurve>& before, const std::vector<PlaneCurve>& after, Rng& rng) {
  for (int i = 0; i < 200; ++i) {
    const Vec2 p{rng.uniform(-12, 12), rng.uniform(-12, 12)};
    const Around was = around(before, p);
    if (was.distance < 1e-3) continue;
    CAPTURE(p.x, p.y, was.winding);
    REQUIRE((around(after, p).crossings % 2 == 1) == (was.winding != 0));
  }
}

PlaneCurve star(Vec2 center, double radius, int corners, int step) {
  std::vector<Vec2> points;
  for (int i = 0; i < corners; ++i) {
    const double angle = 0.3 + 2.0 * kPi * i * step / corners;
    points.push_back(center + radius * Vec2{std::cos(angle), std::sin(angle)});
  }
  return polygon(points);
}

}  // namespace

TEST_CASE("what random curves enclose by the nonzero rule is enclosed by the even-odd rule, too") {
  Rng rng(7);
  int changed = 0;
  for (int round = 0; round < 60; ++round) {
    std::vector<PlaneCurve> curves;
    const int count = 1 + round % 4;
    for (int i = 0; i < count; ++i) {
      const Vec2 center{rng.uniform(-5, 5), rng.uniform(-5, 5)};
      switch (round % 3) {
        case 0: curves.push_back(circle_around(center, rng.uniform(1, 6))); break;
        case 1: curves.push_back(star(center, rng.uniform(2, 6), 7, 3)); break;
        default: {
          std::vector<Vec2> points;
          for (int k = 0; k < 8; ++k) points.push_back({rng.uniform(-10, 10), rng.uniform(-10, 10)});
          curves.push_back(polygon(points));
        }
      }
    }
    const FilledArea area = nonzero_area(curves);
    REQUIRE_FALSE(area.is_unknown);
    changed += area.is_changed ? 1 : 0;
    if (!area.is_changed) CHECK(area.curves == curves);
    check_points(curves, area.curves, rng);
  }
  CHECK(changed > 30);
}

TEST_CASE("curves are unchanged where both rules give the same area") {
  const auto stay = [](const std::vector<PlaneCurve>& curves) {
    const FilledArea area = nonzero_area(curves);
    return !area.is_changed && !area.is_unknown && area.curves == curves;
  };
  const auto square = [](double low, double high, bool is_reverse) {
    std::vector<Vec2> points{{low, low}, {high, low}, {high, high}, {low, high}};
    if (is_reverse) std::swap(points[1], points[3]);
    return polygon(points);
  };
  CHECK(stay({}));
  CHECK(stay({circle_around({0, 0}, 3)}));
  CHECK(stay({circle_around({-5, 0}, 3), circle_around({5, 0}, 3)}));
  CHECK(stay({square(-5, 5, false), square(-3, 3, true)}));
  CHECK(stay({square(-5, 5, true), square(-3, 3, false), square(-1, 1, true)}));
  CHECK(stay({polygon({{-5, -5}, {5, 5}, {-5, 5}, {5, -5}})}));
  CHECK(stay({polygon({{0, 0}, {9, 3}}, false), square(-5, 5, false)}));
}

TEST_CASE("curves within an area that is filled go, and the others stay to the last bit") {
  const PlaneCurve outer = circle_around({0, 0}, 9);
  const PlaneCurve hole = polygon({{-4, -4}, {-4, 4}, {4, 4}, {4, -4}});
  const PlaneCurve island = circle_around({0, 0}, 2);
  const PlaneCurve within_island = circle_around({0, 0}, 1);
  const PlaneCurve line = polygon({{-9, 9}, {9, 9}}, false);
  const FilledArea area = nonzero_area({outer, hole, line, island, within_island});
  CHECK(area.is_changed);
  CHECK(area.curves == std::vector<PlaneCurve>{outer, hole, island, line});
}

TEST_CASE("the union of two disks consists of arcs, and curves twice in one place count once") {
  const FilledArea two = nonzero_area({circle_around({-3, 0}, 5), circle_around({3, 0}, 5)});
  REQUIRE(two.is_changed);
  REQUIRE(two.curves.size() == 1);
  double length = 0.0;
  two.curves[0].for_each_piece([&](const Piece& piece) {
    CHECK(piece.kind == PieceKind::arc);
    length += 5.0 * std::abs(piece.arc.sweep);
  });
  CHECK(length == Approx(4.0 * 5.0 * (kPi - std::acos(3.0 / 5.0))).epsilon(1e-9));

  const PlaneCurve triangle = polygon({{0, 0}, {8, 0}, {0, 8}});
  const FilledArea once = nonzero_area({triangle, triangle});
  CHECK(once.is_changed);
  CHECK(once.curves == std::vector<PlaneCurve>{triangle});
}

TEST_CASE("curves that cross each other too often are unknown, and stay") {
  std::vector<PlaneCurve> curves;
  for (int i = 0; i < 100; ++i) {
    const double at = -10.0 + 0.2 * i;
    curves.push_back(polygon({{at, -11}, {at + 0.1, -11}, {at + 0.1, 11}, {at, 11}}));
    curves.push_back(polygon({{-11, at}, {11, at}, {11, at + 0.1}, {-11, at + 0.1}}));
  }
  const FilledArea area = nonzero_area(curves);
  CHECK(area.is_unknown);
  CHECK(area.curves == curves);
}
