// SPDX-License-Identifier: GPL-3.0-or-later
// The two conditions of the certificate: inputs for which only one of them fails, and the theorem behind the docs,
// that the second can only fail beside conflict edges.
#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <memory>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

#include "core/base/rng.h"
#include "core/builtins/builtins.h"
#include "core/kernel/arc_predicates.h"
#include "core/structures/balls/ball_union.h"
#include "core/structures/certificate/axis_certificate.h"
#include "tests/support/builtin_layers.h"
#include "tests/support/workbench.h"

using namespace mes;
using namespace mes::test;

namespace {

ComputationSettings exactly() {
  ComputationSettings out;
  out.precision = Precision::exact;
  return out;
}

bool has_border_on_conflict(const TestBench& bench) {
  const auto& delaunay = bench.get<Delaunay>();
  const auto& certificate = bench.get<AxisCertificate>();
  const auto& labels = bench.get<Labels>();
  for (const EdgeSlot edge : delaunay.edge_slots())
    if (delaunay.edge(edge).is_alive() && certificate.is_border(edge) && labels.is_conflict(edge)) return true;
  return false;
}

/// Of each border edge, whether another inner ball meets its arc: by looking at all of them.
std::vector<EdgeSlot> edges_met(const StructureSet& structures) {
  const auto& delaunay = structures.get<Delaunay>();
  const auto& labels = structures.get<Labels>();
  const auto& balls = structures.get<InnerBalls>();
  const auto& certificate = structures.get<AxisCertificate>();
  const auto at = [&delaunay](SiteSlot site) { return delaunay.site_position(site); };
  std::vector<EdgeSlot> out;
  for (const EdgeSlot edge : delaunay.edge_slots()) {
    const EdgeRow& row = delaunay.edge(edge);
    if (!row.is_alive() || !certificate.is_border(edge)) continue;
    const FaceSlot inner = labels.is_inside(row.f[0]) ? row.f[0] : row.f[1];
    const FaceRow& own = delaunay.face(inner);
    const int i = own.index_of_edge(edge);
    const OuterArc arc{at(own.v[i]), at(own.v[next3(i)]), at(own.v[prev3(i)])};
    for (const FaceSlot other : delaunay.face_slots()) {
      if (!delaunay.is_finite_face(other) || !labels.is_inside(other)) continue;
      if (balls.ball(other) == balls.ball(inner)) continue;
      const FaceRow& face = delaunay.face(other);
      if (!meets_arc(arc, Corners{at(face.v[0]), at(face.v[1]), at(face.v[2])})) continue;
      out.push_back(edge);
      break;
    }
  }
  return out;
}

std::vector<EdgeSlot> edges_found(const StructureSet& structures) {
  const auto& delaunay = structures.get<Delaunay>();
  std::vector<EdgeSlot> out;
  for (const EdgeSlot edge : delaunay.edge_slots())
    if (delaunay.edge(edge).is_alive() && structures.get<AxisCertificate>().is_bad_edge(edge)) out.push_back(edge);
  return out;
}

}  // namespace

TEST_CASE("two inner balls that touch in a sample are not certified: their centres are joined by the union alone") {
  std::vector<Vec2> points{{0, 0}, {0, 6}, {0, -6}};
  for (const double side : {1.0, -1.0})
    for (const Vec2 p : {Vec2{1, 3}, {2, 4}, {5, 5}, {8, 4}, {9, 3}})
      for (const double y : {p.y, -p.y}) points.push_back({side * p.x, y});
  points.push_back({10, 0});
  points.push_back({-10, 0});
  TestBench bench;
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
  TestBench bench;
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
  TestBench bench;
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
    REQUIRE(edges_met(bench.graph().structures()).empty());
  }
  CHECK(borders > 200);
}

TEST_CASE("the arcs that are met are those that one of all balls meets, while samples move") {
  Rng rng(31);
  int met = 0, free = 0;
  for (int trial = 0; trial < 100; ++trial) {
    // A closed curve, or one with gaps, or whatever there is, or a strip, whose long sides are on the hull; on a grid every
    // third time, and strips always.
    std::vector<Vec2> points;
    const bool is_strip = trial >= 60;
    const bool is_on_grid = trial % 3 == 0 || is_strip;
    const int count = 12 + static_cast<int>(rng.below(40));
    for (int i = 0; i < count; ++i) {
      const double t = 2.0 * std::numbers::pi * (i + rng.uniform(-0.2, 0.2)) / count;
      const double r = 100.0 + 30.0 * std::cos(3.0 * t);
      const Vec2 p = trial % 4 == 3 ? Vec2{rng.uniform(-100.0, 100.0), rng.uniform(-100.0, 100.0)}
                                    : Vec2{r * std::cos(t), r * std::sin(t)};
      points.push_back(is_on_grid ? Vec2{std::round(p.x / 8.0), std::round(p.y / 8.0)} : p);
    }
    if (is_strip) {
      points.resize(rng.below(4));
      const double height = 1.0 + static_cast<double>(rng.below(9));
      for (double x = 0.0; x <= 30.0; x += 1.0)
        for (const double y : {0.0, height})
          if (rng.below(4) != 0) points.push_back({x, y});
    }
    if (trial % 4 == 1) points.resize(points.size() - 4);
    Document document;
    Graph graph{builtins()};
    graph.set_demand(std::vector{find_layer("theorem-check")});
    FramePatch patch;
    JobControl job;
    const auto follow = [&](const Expected<DocumentDelta>& delta) {
      if (!delta) return;
      const auto shared = std::make_shared<const DocumentDelta>(*delta);
      document.apply(*shared);
      graph.post(shared);
      REQUIRE(graph.run(patch, job));
      REQUIRE(edges_found(graph.structures()) == edges_met(graph.structures()));
      const AxisCertificate& certificate = graph.structures().get<AxisCertificate>();
      met += certificate.bad_edge_count() != 0 ? 1 : 0;
      free += certificate.bad_edge_count() == 0 && certificate.has_verdict() ? 1 : 0;
      // Ready, stopped on the way, or neither.
      JobControl stopped;
      stopped.stop_at_look(static_cast<std::int64_t>(rng.below(3)));
      if (rng.below(2) == 0) graph.get_ready(job, rng.below(2) == 0 ? stopped : job);
    };
    SampleData data;
    data.positions = points;
    follow(replace_all(document, data));
    for (int step = 0; step < 30; ++step) {
      const SampleSlot slot(rng.below(points.size()));
      const double reach = is_on_grid ? 3.0 : 12.0;
      const Vec2 by{rng.uniform(-reach, reach), is_strip && rng.below(2) == 0 ? 0.0 : rng.uniform(-reach, reach)};
      const Vec2 to = document.position(slot) + (is_on_grid ? Vec2{std::round(by.x), std::round(by.y)} : by);
      follow(move_samples(document, std::vector{std::pair{document.id(slot), to}}));
    }
  }
  CHECK(met > 100);
  CHECK(free > 100);
}

TEST_CASE("far from 1 arcs are decided in intervals all the same, and alike") {
  Rng rng(5);
  for (int trial = 0; trial < 2000; ++trial) {
    Vec2 p[6];
    for (Vec2& one : p) one = {rng.uniform(-1.0, 1.0), rng.uniform(-1.0, 1.0)};
    const auto turned = [](Vec2 a, Vec2 b, Vec2 c) { return cross(b - a, c - a) > 0.0; };
    if (!turned(p[0], p[1], p[2])) std::swap(p[1], p[2]);
    if (!turned(p[3], p[4], p[5])) std::swap(p[4], p[5]);
    const auto ask = [&p](int exponent) {
      Vec2 q[6];
      for (int i = 0; i < 6; ++i) q[i] = {std::ldexp(p[i].x, exponent), std::ldexp(p[i].y, exponent)};
      return std::pair(meets_arc_quickly(OuterArc{q[0], q[1], q[2]}, Corners{q[3], q[4], q[5]}),
                       meets_arc_quickly(OuterArc{q[0], q[1], q[2]}, q[3], q[4]));
    };
    const auto near = ask(0);
    for (const int exponent : {-480, -300, 300, 465, 490}) {
      INFO("trial " << trial << ", 2^" << exponent);
      REQUIRE(ask(exponent) == near);
    }
  }
}
