// SPDX-License-Identifier: GPL-3.0-or-later
// Critical values of the distance to the samples: formulas, and the definition in plain loops over exact rationals.
#include <CGAL/Exact_rational.h>

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <vector>

#include "core/base/rng.h"
#include "core/kernel/enclosing_circle.h"
#include "core/structures/filters/lambda_axis.h"
#include "tests/support/workbench.h"

using namespace mes;
using namespace mes::test;

TEST_CASE("critical values are the radius of a rectangle, and half the width of a neck") {
  Workbench bench;
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
    Workbench bench;
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
        using Rational = CGAL::Exact_rational;
        return (Rational(p.x) - Rational(x.x)) * (Rational(q.x) - Rational(x.x)) +
                   (Rational(p.y) - Rational(x.y)) * (Rational(q.y) - Rational(x.y)) >=
               0;
      });
      if (is_empty) expected.push_back(0.5 * distance(p, q));
    }
    for (const FaceSlot face : delaunay.face_slots()) {
      if (!delaunay.is_finite_face(face) || !axis.is_node(face)) continue;
      bool is_acute = false;
      for (const FaceSlot other : delaunay.face_slots()) {
        if (!delaunay.is_finite_face(other) || bench.get<InnerBalls>().ball(other) != face) continue;
        const FaceRow& row = delaunay.face(other);
        is_acute = is_acute || !is_right_or_obtuse(delaunay.site_position(row.v[0]), delaunay.site_position(row.v[1]),
                                                   delaunay.site_position(row.v[2]));
      }
      if (is_acute) expected.push_back(delaunay.circumradius(face));
    }
    std::ranges::sort(expected);
    expected.erase(std::ranges::unique(expected).begin(), expected.end());
    REQUIRE(values == expected);
  }
}
