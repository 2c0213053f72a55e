// SPDX-License-Identifier: GPL-3.0-or-later
// The two conditions of the certificate: inputs for which only one of them fails, and the theorem behind the docs,
// that the second can only fail beside conflict edges.
#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "core/base/rng.h"
#include "core/structures/balls/ball_union.h"
#include "core/structures/certificate/axis_certificate.h"
#include "tests/support/workbench.h"

using namespace mes;
using namespace mes::test;

namespace {

ComputationSettings exactly() {
  ComputationSettings out;
  out.precision = Precision::exact;
  return out;
}

bool has_border_on_conflict(const Workbench& bench) {
  const auto& delaunay = bench.get<Delaunay>();
  const auto& certificate = bench.get<AxisCertificate>();
  const auto& labels = bench.get<Labels>();
  for (const EdgeSlot edge : delaunay.edge_slots())
    if (delaunay.edge(edge).is_alive() && certificate.is_border(edge) && labels.is_conflict(edge)) return true;
  return false;
}

}  // namespace

TEST_CASE("two inner balls that touch in a sample are not certified: their centres are joined by the union alone") {
  std::vector<Vec2> points{{0, 0}, {0, 6}, {0, -6}};
  for (const double side : {1.0, -1.0})
    for (const Vec2 p : {Vec2{1, 3}, {2, 4}, {5, 5}, {8, 4}, {9, 3}})
      for (const double y : {p.y, -p.y}) points.push_back({side * p.x, y});
  points.push_back({10, 0});
  points.push_back({-10, 0});
  Workbench bench;
  bench.show({"medial-axis", "a-ball-medial-axis", "theorem-check"});
  bench.choose(exactly());
  bench.insert(points);
  const auto& certificate = bench.get<AxisCertificate>();
  CHECK(certificate.bad_edge_count() == 0);
  CHECK(certificate.bad_site_count() == 1);
  CHECK_FALSE(certificate.is_certified());
  // The one-step axis is two points; the axis of the union is the segment between them.
  CHECK(bench.count("medial-axis", "components") == 2);
  CHECK(bench.count("a-union", "components") == 1);
  CHECK(bench.count("a-union", "dual_singular") == 1);
  CHECK(bench.measure("a-union", "length") == 10.0);
}

TEST_CASE("a ball that bulges through a mended gap and meets another one is not certified") {
  // A curve that is open at the bottom, where an edge that is not crust mends it, and a triangle before the gap.
  Workbench bench;
  bench.show({"medial-axis", "a-ball-medial-axis", "theorem-check"});
  bench.choose(exactly());
  bench.insert({{9, -39},
                {26, -30},
                {37, -14},
                {40, 5},
                {33, 23},
                {19, 35},
                {0, 40},
                {-19, 35},
                {-33, 23},
                {-40, 5},
                {-37, -14},
                {-26, -30},
                {-9, -39},
                {0, -45},
                {9, -42},
                {3, -36}});
  const auto& certificate = bench.get<AxisCertificate>();
  REQUIRE(has_border_on_conflict(bench));
  CHECK(certificate.bad_site_count() == 0);
  CHECK(certificate.bad_edge_count() == 2);
  CHECK_FALSE(certificate.is_certified());
  // The circles cross where no sample is, and there the axis of the union goes on.
  CHECK(bench.count("a-union", "foreign_v_points") > 0);
  CHECK(bench.measure("a-union", "length") > bench.measure("medial-axis", "length") + 1.0);
}

TEST_CASE("no arc of a border of crust edges is met by another inner ball") {
  Rng rng(12);
  Workbench bench;
  bench.show({"theorem-check"});
  int borders = 0;
  for (int trial = 0; trial < 3000; ++trial) {
    // Few points on a small grid, or on circles of whole numbers: much is cocircular or tangent.
    const int grid = 4 + static_cast<int>(rng.below(12));
    std::vector<Vec2> points(4 + rng.below(14));
    for (Vec2& p : points)
      p = {static_cast<double>(rng.below(static_cast<std::uint64_t>(grid))),
           static_cast<double>(rng.below(static_cast<std::uint64_t>(grid)))};
    bench.replace(points);
    const auto& certificate = bench.get<AxisCertificate>();
    if (!certificate.has_verdict() || has_border_on_conflict(bench)) continue;
    ++borders;
    INFO("trial " << trial);
    REQUIRE(certificate.bad_edge_count() == 0);
  }
  CHECK(borders > 200);
}
