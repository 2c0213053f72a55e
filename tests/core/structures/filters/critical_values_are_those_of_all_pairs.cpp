// SPDX-License-Identifier: GPL-3.0-or-later
// Critical values of the distance to the samples: formulas, and the definition in plain loops over exact rationals.
#include <CGAL/Exact_rational.h>

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <utility>
#include <vector>

#include "core/base/rng.h"
#include "core/kernel/enclosing_circle.h"
#include "core/structures/filters/lambda_axis.h"
#include "tests/support/workbench.h"

using namespace mes;
using namespace mes::test;

namespace {

using Rational = CGAL::Exact_rational;

/// Where the centre of their circle lies, for samples on one circle.
enum class Among { outside, between_two, inside };
Among among_them(const std::vector<Vec2>& samples) {
  // The centre from the first three that differ, by the linear equations that have it at one distance from them.
  const auto at = [&](std::size_t i) { return std::pair{Rational(samples[i].x), Rational(samples[i].y)}; };
  const auto [ax, ay] = at(0);
  const auto [bx, by] = at(1);
  const auto [cx, cy] = at(2);
  const Rational d = 2 * ((bx - ax) * (cy - ay) - (by - ay) * (cx - ax));
  const Rational b2 = (bx - ax) * (bx - ax) + (by - ay) * (by - ay);
  const Rational c2 = (cx - ax) * (cx - ax) + (cy - ay) * (cy - ay);
  const Rational x = ax + ((cy - ay) * b2 - (by - ay) * c2) / d;
  const Rational y = ay + ((bx - ax) * c2 - (cx - ax) * b2) / d;
  // The centre is outside of the closed hull where a line through it and a sample has all others on one open side, or
  // behind: where some half plane through the centre holds all of them in its inside.
  bool is_inside = true;
  bool is_between = false;
  for (const Vec2 p : samples) {
    const Rational px = Rational(p.x) - x;
    const Rational py = Rational(p.y) - y;
    bool has_left = false;
    bool has_right = false;
    bool has_opposite = false;
    for (const Vec2 q : samples) {
      const Rational qx = Rational(q.x) - x;
      const Rational qy = Rational(q.y) - y;
      const Rational side = px * qy - py * qx;
      has_left = has_left || side > 0;
      has_right = has_right || side < 0;
      has_opposite = has_opposite || (side == 0 && px * qx + py * qy < 0);
    }
    is_between = is_between || has_opposite;
    is_inside = is_inside && ((has_left && has_right) || has_opposite);
  }
  return is_between ? Among::between_two : is_inside ? Among::inside : Among::outside;
}

double longest_half(const std::vector<Vec2>& samples) {
  double out = 0.0;
  for (const Vec2 p : samples)
    for (const Vec2 q : samples) out = std::max(out, 0.5 * distance(p, q));
  return out;
}

double weak_feature_size(const std::vector<Vec2>& samples) {
  TestBench bench;
  bench.show({"lambda-medial-axis"});
  bench.replace(samples);
  return bench.measure("lambda-axis", "weak_feature_size");
}

}  // namespace

TEST_CASE("critical values are the radius of a rectangle, and half the width of a neck") {
  TestBench bench;
  bench.show({"lambda-medial-axis"});
  CHECK(bench.get<LambdaAxis>().critical_values().empty());
  bench.replace({{0, 0}, {4, 0}, {4, 2}, {0, 2}});
  // One node, whose circle has the radius sqrt(5).
  const std::vector<double> values = bench.get<LambdaAxis>().critical_values();
  REQUIRE(values.size() == 1);
  CHECK(values.front() == Approx(std::sqrt(5.0)));
  // A dumb-bell: the neck is a saddle, and each end a maximum.
  std::vector<Vec2> samples;
  for (int i = 0; i < 40; ++i) {
    const double x = -10.0 + 0.5 * i + 0.25;
    const double y = 1.0 + 0.03 * x * x;
    samples.push_back({x, y});
    samples.push_back({x, -y});
  }
  bench.replace(samples);
  CHECK(bench.measure("lambda-axis", "weak_feature_size") == Approx(1.0).margin(0.01));
}

// An edge is crossed by its dual where its smallest circle holds no other sample.
TEST_CASE("critical edges are those whose smallest circle is empty, among all pairs of samples") {
  Rng rng(21);
  for (int round = 0; round < 12; ++round) {
    std::vector<Vec2> samples;
    const double step =
        round % 2 == 0 ? 1.0 : 0.1;  // squares, whose centres lie on diagonals; steps that are no doubles
    for (int i = 0; i < 30; ++i) {
      const Vec2 at{step * static_cast<double>(rng.below(9)), step * static_cast<double>(rng.below(9))};
      if (std::ranges::find(samples, at) == samples.end()) samples.push_back(at);
    }
    TestBench bench;
    bench.show({"lambda-medial-axis"});
    bench.replace(samples);
    const auto& delaunay = bench.get<Delaunay>();
    const auto& axis = bench.get<MedialAxis>();
    const std::vector<double> values = bench.get<LambdaAxis>().critical_values();
    std::vector<double> expected;
    for (const EdgeSlot edge : delaunay.edge_slots()) {
      if (!delaunay.edge(edge).is_alive() || !axis.is_axis_edge(edge)) continue;
      const Vec2 p = delaunay.site_position(delaunay.edge(edge).v[0]);
      const Vec2 q = delaunay.site_position(delaunay.edge(edge).v[1]);
      const bool is_empty = std::ranges::all_of(samples, [&](Vec2 x) {
        return (Rational(p.x) - Rational(x.x)) * (Rational(q.x) - Rational(x.x)) +
                   (Rational(p.y) - Rational(x.y)) * (Rational(q.y) - Rational(x.y)) >=
               0;
      });
      if (is_empty) expected.push_back(0.5 * distance(p, q));
    }
    for (const FaceSlot face : delaunay.face_slots()) {
      if (!delaunay.is_finite_face(face) || !axis.is_node(face)) continue;
      std::vector<Vec2> around;
      bool has_acute = false;  // some triangle has the centre inside
      for (const FaceSlot other : delaunay.face_slots()) {
        if (!delaunay.is_finite_face(other) || bench.get<InnerBalls>().ball(other) != face) continue;
        const FaceRow& row = delaunay.face(other);
        for (const SiteSlot site : row.v) around.push_back(delaunay.site_position(site));
        has_acute =
            has_acute || !is_right_or_obtuse(delaunay.site_position(row.v[0]), delaunay.site_position(row.v[1]),
                                             delaunay.site_position(row.v[2]));
      }
      const Among among = among_them(around);
      REQUIRE((among != Among::inside || has_acute));
      REQUIRE((among != Among::outside || !has_acute));
      if (has_acute) expected.push_back(delaunay.circumradius(face));
      // Half the distance of two samples that are opposite to each other, which is the diameter.
      if (among == Among::between_two && !has_acute) expected.push_back(longest_half(around));
    }
    std::ranges::sort(expected);
    expected.erase(std::ranges::unique(expected).begin(), expected.end());
    REQUIRE(values == expected);
  }
}

TEST_CASE("the centre of a right triangle is critical, that of an obtuse one is not, and an acute one's is") {
  CHECK(weak_feature_size({{7, 4}, {1, 7}, {7, 7}}) == 0.5 * distance({7, 4}, {1, 7}));
  for (const auto& [apex, expected] :
       {std::pair{Vec2{0, 2}, 2.0}, {Vec2{1.2, 1.6}, 2.0}, {Vec2{0, 2 + 0x1p-40}, 2.0}})
    CHECK(weak_feature_size({{-2, 0}, {2, 0}, apex}) == Approx(expected));
  CHECK(std::isinf(weak_feature_size({{-2, 0}, {2, 0}, {0, 2 - 0x1p-40}})));
  CHECK(std::isinf(weak_feature_size({{-2, 0}, {2, 0}, {1.2, 1.5}})));
  // Far away and tiny, decided by the samples as they are.
  for (const double scale : {0x1p-60, 1.0, 0x1p60}) {
    CHECK(weak_feature_size({{0, 0}, {3 * scale, 0}, {0, 4 * scale}}) == 2.5 * scale);
    CHECK(weak_feature_size({{1e6, 0}, {1e6 + 3, 0}, {1e6, 4}}) == 2.5);
    CHECK(std::isinf(weak_feature_size({{0, 0}, {3 * scale, 0}, {-0x1p-30 * scale, 4 * scale}})));
  }
  // Collinear samples have no axis and no critical values.
  CHECK(std::isinf(weak_feature_size({{0, 0}, {1, 1}, {2, 2}, {5, 5}})));
  CHECK(std::isinf(weak_feature_size({{0, 0}})));
}

TEST_CASE("turning and moving a right triangle on the grid keeps its critical value") {
  Rng rng(3);
  for (int round = 0; round < 300; ++round) {
    const auto whole = [&] { return static_cast<double>(rng.below(2000)) - 1000.0; };
    const Vec2 corner{whole(), whole()};
    Vec2 leg{whole(), whole()};
    if (leg == Vec2{}) leg = {1, 0};
    const double factor = 1.0 + static_cast<double>(rng.below(9));
    const Vec2 p = corner + leg;
    const Vec2 q = corner + factor * perpendicular(leg);
    CHECK(weak_feature_size({corner, p, q}) == 0.5 * distance(p, q));
    CHECK(weak_feature_size({q, corner, p}) == 0.5 * distance(p, q));
  }
}
