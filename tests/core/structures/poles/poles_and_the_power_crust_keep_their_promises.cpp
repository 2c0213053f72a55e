// SPDX-License-Identifier: GPL-3.0-or-later
// Poles against their definition in rationals, labels that spread against labels of triangles, and the power crust
// against the curve.
#include <CGAL/Exact_rational.h>

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <functional>

#include "core/base/rng.h"
#include "core/kernel/pole_predicates.h"
#include "core/structures/crust/curve.h"
#include "core/structures/poles/polar_diagram.h"
#include "tests/support/builtin_layers.h"
#include "tests/support/shapes/shapes.h"
#include "tests/support/workbench.h"

using namespace mes;
using namespace mes::test;

namespace {

using ExactNumber = CGAL::Exact_rational;
struct Point {
  ExactNumber x, y;
};
Point operator-(const Point& a, const Point& b) {
  return {a.x - b.x, a.y - b.y};
}
ExactNumber dot(const Point& a, const Point& b) {
  return a.x * b.x + a.y * b.y;
}
Point exact(Vec2 p) {
  return {p.x, p.y};
}
Point circumcenter(const Point& a, const Point& b, const Point& c) {
  const Point u = b - a;
  const Point v = c - a;
  const ExactNumber twice = 2 * (u.x * v.y - u.y * v.x);
  return {a.x + (v.y * dot(u, u) - u.y * dot(v, v)) / twice, a.y + (u.x * dot(v, v) - v.x * dot(u, u)) / twice};
}
int sign(const ExactNumber& x) {
  return x > 0 ? 1 : (x < 0 ? -1 : 0);
}
/// Of a / sqrt(A) + b / sqrt(B).
int sign_of_sum(const ExactNumber& a, const ExactNumber& square_a, const ExactNumber& b,
                const ExactNumber& square_b) {
  if (sign(a) == sign(b)) return sign(a);
  return sign(sign(a) * a * a * square_b + sign(b) * b * b * square_a);
}

/// Plus and minus pole of every site, by looking at its whole cell.
void check_poles(const TestBench& bench) {
  const auto& delaunay = bench.get<Delaunay>();
  const auto& vertices = bench.get<VoronoiVertices>();
  const auto& poles = bench.get<Poles>();
  REQUIRE(delaunay.dimension() == 2);
  for (const SiteSlot site : delaunay.site_slots()) {
    if (!delaunay.is_site(site)) continue;
    const Point p = exact(delaunay.site_position(site));
    struct Vertex {
      FaceSlot face;
      Point to;  // from p
    };
    std::vector<Vertex> cell;
    SiteSlot before;
    SiteSlot after;
    for (const FaceSlot face : delaunay.face_slots()) {
      const FaceRow& row = delaunay.face(face);
      if (!row.is_alive() || std::ranges::find(row.v, site) == std::end(row.v)) continue;
      if (!row.is_infinite()) {
        const Point center =
            circumcenter(exact(delaunay.site_position(row.v[0])), exact(delaunay.site_position(row.v[1])),
                         exact(delaunay.site_position(row.v[2])));
        cell.push_back({vertices.vertex(face), center - p});
        continue;
      }
      const int i = row.index_of_site(site);
      (row.v[next3(i)] == kInfiniteSite ? after : before) =
          row.v[next3(i)] == kInfiniteSite ? row.v[prev3(i)] : row.v[next3(i)];
    }
    const auto comes_before = [](const Vertex& a, const Vertex& b) {
      const ExactNumber da = dot(a.to, a.to);
      const ExactNumber db = dot(b.to, b.to);
      if (da != db) return da > db;
      return a.to.x != b.to.x ? a.to.x < b.to.x : a.to.y < b.to.y;
    };
    FaceSlot plus = kInfinitePole;
    std::function<bool(const Vertex&)> is_opposite;
    if (before == kNoSlot) {
      const Vertex farthest = *std::ranges::min_element(cell, comes_before);
      plus = farthest.face;
      is_opposite = [farthest](const Vertex& v) { return dot(v.to, farthest.to) < 0; };
    } else {
      const Point in = p - exact(delaunay.site_position(before));
      const Point on = exact(delaunay.site_position(after)) - p;
      // Outward normals lie to the right of the hull, which runs counter-clockwise.
      is_opposite = [in, on](const Vertex& v) {
        return sign_of_sum(v.to.x * in.y - v.to.y * in.x, dot(in, in), v.to.x * on.y - v.to.y * on.x, dot(on, on)) <
               0;
      };
    }
    std::erase_if(cell, [&](const Vertex& v) { return !is_opposite(v); });
    const FaceSlot minus = cell.empty() ? FaceSlot() : std::ranges::min_element(cell, comes_before)->face;
    INFO("site " << site.index() << " at " << delaunay.site_position(site).x << ' '
                 << delaunay.site_position(site).y);
    REQUIRE(poles.plus(site) == plus);
    REQUIRE(poles.minus(site) == minus);
  }
}

double distance_to(Vec2 p, const PowerEdge& edge) {
  const Vec2 along = edge.to - edge.from;
  const double size = dot(along, along);
  const double t = size > 0.0 ? std::clamp(dot(p - edge.from, along) / size, 0.0, 1.0) : 0.0;
  return distance(p, edge.from + t * along);
}

}  // namespace

TEST_CASE("triangles in one circle are equally far, whatever rounding says") {
  // Points with whole coordinates on the circle of radius 65, counter-clockwise from (65, 0); times a number so large
  // that the products of doubles are rounded.
  constexpr double kScale = 123456789.0;
  const std::vector<Vec2> on_circle{{63, 16},   {60, 25},   {56, 33},   {52, 39},  {39, 52},  {33, 56},
                                    {25, 60},   {16, 63},   {0, 65},    {-16, 63}, {-25, 60}, {-33, 56},
                                    {-39, 52},  {-52, 39},  {-56, 33},  {-60, 25}, {-63, 16}, {-65, 0},
                                    {-63, -16}, {-52, -39}, {-33, -56}, {0, -65},  {39, -52}, {60, -25}};
  std::vector<StarTriangle> triangles;
  for (std::size_t i = 0; i < on_circle.size(); ++i)
    for (std::size_t j = i + 1; j < on_circle.size(); ++j)
      triangles.push_back({{65 * kScale, 0}, kScale * on_circle[i], kScale * on_circle[j]});
  std::size_t rounded_apart = 0;
  for (const StarTriangle& f : triangles) {
    const StarTriangle& g = triangles.front();
    const RadiusKey key_f = radius_key(f);
    const RadiusKey key_g = radius_key(g);
    rounded_apart += key_f.value != key_g.value ? 1U : 0U;
    REQUIRE(compare_pole_distance(f, key_f, g, key_g) == 0);
  }
  CHECK(rounded_apart > 10);
}

TEST_CASE("poles are the farthest Voronoi vertices") {
  Rng rng(5);
  SECTION("of random points") {
    std::vector<Vec2> points(120);
    for (Vec2& p : points) p = {rng.uniform(), rng.uniform()};
    check_poles(TestBench(points));
  }
  SECTION("of a lattice, where every comparison is a tie") {
    std::vector<Vec2> points;
    for (int x = 0; x < 7; ++x)
      for (int y = 0; y < 6; ++y) points.push_back({0.1 * x, 0.1 * y});
    check_poles(TestBench(points));
    for (Vec2& p : points) p = {std::round(10.0 * p.x), std::round(10.0 * p.y)};
    check_poles(TestBench(points));
  }
  SECTION("of points of a small grid") {
    for (int round = 0; round < 40; ++round) {
      std::vector<Vec2> points(5 + rng.below(20));
      for (Vec2& p : points) p = {static_cast<double>(rng.below(9)), static_cast<double>(rng.below(9))};
      const TestBench bench(points);
      if (bench.get<Delaunay>().dimension() == 2) check_poles(bench);
    }
  }
  SECTION("of cocircular points") {
    std::vector<Vec2> points;
    for (int x = -65; x <= 65; ++x)
      for (int y = -65; y <= 65; ++y)
        if (x * x + y * y == 65 * 65) points.push_back({static_cast<double>(x), static_cast<double>(y)});
    const TestBench bench(points);
    check_poles(bench);
    CHECK(bench.count("poles", "faces") == 1);
    CHECK(bench.count("poles", "finite") == 36);
    CHECK(bench.count("power-crust", "loops") == 1);
  }
  SECTION("of far apart and tiny coordinates") {
    for (const double scale : {1e-140, 1e150}) {
      std::vector<Vec2> points(30);
      for (Vec2& p : points) p = {scale * rng.uniform(), scale * rng.uniform()};
      check_poles(TestBench(points));
    }
  }
  SECTION("of nearly flat triangles") {
    std::vector<Vec2> points;
    for (int i = 0; i < 20; ++i) points.push_back({0.1 * i, 0x1p-50 * static_cast<double>(rng.below(5))});
    points.push_back({1.0, 1.0});
    check_poles(TestBench(points));
  }
}

TEST_CASE("below dimension two there is no pole and no power crust") {
  for (const std::size_t n : {0U, 1U, 2U, 5U}) {
    std::vector<Vec2> points;
    for (std::size_t i = 0; i < n; ++i) points.push_back({static_cast<double>(i), 2.0 * static_cast<double>(i)});
    TestBench bench(points);
    CHECK(bench.count("poles", "faces") == 0);
    CHECK(bench.count("power-crust", "edges") == 0);
    bench.insert({{0.5, 7.0}});
    bench.remove({bench.ids().back()});
    CHECK(bench.count("poles", "faces") == 0);
    CHECK(bench.trouble().empty());
  }
}

TEST_CASE("on dense samples of smooth curves the power crust is the curve") {
  for (const TestShape& shape : oracle_shapes(0.2, {0.3, 0.1, 7})) {
    INFO(shape.name);
    TestBench bench;
    bench.show({"power-crust", "curve-normals"});
    ComputationSettings settings;
    settings.precision = Precision::exact;
    bench.choose(settings);
    bench.replace(shape.data.positions);
    const auto& diagram = bench.get<PolarDiagram>();
    const auto& crust = bench.get<PowerCrust>();
    const std::size_t contours = shape.expected.components + shape.expected.cycles;
    CHECK(bench.count("power-crust", "loops") == static_cast<std::int64_t>(contours));
    CHECK(bench.count("power-crust", "unbounded") == 0);
    double length = 0.0;
    for (const Curve::Chain& chain : bench.get<Curve>().chains())
      for (std::size_t i = 0; i < chain.sites.size(); ++i)
        length += distance(bench.get<Delaunay>().site_position(chain.sites[i]),
                           bench.get<Delaunay>().site_position(chain.sites[(i + 1) % chain.sites.size()]));
    // It runs through all samples, from each to the next, with a corner at most in between.
    CHECK(bench.measure("power-crust", "length") >= length * (1.0 - 1e-12));
    CHECK(bench.measure("power-crust", "length") <= length * 1.02);
    for (const Vec2 p : shape.data.positions) {
      double nearest = 1e99;
      for (const PowerEdgeSlot edge : diagram.edges().rows())
        if (crust.is_crust(edge)) nearest = std::min(nearest, distance_to(p, diagram.edges()[edge]));
      REQUIRE(nearest < 1e-12);
    }
  }
}

TEST_CASE("straight sides in any direction have a power crust, whatever rounding makes of their samples") {
  // Rounding bends a side, so samples beside its ends have poles up to 10^16 times the extent away.
  for (const Precision precision : {Precision::fast, Precision::exact}) {
    for (const double propagation : {0.0, 1.0}) {
      for (const double turn : {0.1, 0.7, 1.3}) {
        std::vector<Vec2> samples;
        const std::vector<Vec2> corners{{0, 0}, {10, 0}, {10, 3}, {6, 3}, {6, 5}, {0, 5}};
        const Vec2 along{std::cos(turn), std::sin(turn)};
        for (std::size_t i = 0; i < corners.size(); ++i) {
          const Vec2 from = corners[i];
          const Vec2 to = corners[(i + 1) % corners.size()];
          const auto steps = static_cast<int>(std::round(distance(from, to) / 0.1));
          for (int j = 0; j < steps; ++j) {
            const Vec2 p = from + (static_cast<double>(j) / steps) * (to - from);
            samples.push_back(p.x * along + p.y * perpendicular(along));
          }
        }
        INFO("turned by " << turn << ", " << id_of(precision) << ", propagation " << propagation);
        TestBench bench;
        bench.show({"power-crust", "curve-normals"});
        ComputationSettings settings;
        settings.precision = precision;
        settings[Parameter::pole_propagation] = propagation;
        bench.choose(settings);
        bench.replace(samples);
        CHECK(bench.count("power-crust", "loops") == 1);
        CHECK(bench.count("power-crust", "unbounded") == 0);
        // It runs straight between samples, and misses a corner by less than their distance.
        CHECK(bench.measure("power-crust", "length") == Approx(30.0).epsilon(0.01));
        const auto& diagram = bench.get<PolarDiagram>();
        double farthest = 0.0;
        for (const Vec2 p : samples) {
          double nearest = 1e99;
          for (const PowerEdgeSlot edge : diagram.edges().rows())
            if (bench.get<PowerCrust>().is_crust(edge))
              nearest = std::min(nearest, distance_to(p, diagram.edges()[edge]));
          farthest = std::max(farthest, nearest);
        }
        CHECK(farthest < (precision == Precision::exact ? 1e-9 : 1e-5));
        bench.move(bench.ids().front(), samples.front() + Vec2{0.001, 0.002});
        CHECK(bench.trouble().empty());
      }
    }
  }
}

TEST_CASE("labels that spread from pole to pole agree with those of the triangles on dense samples") {
  for (const Precision precision : {Precision::fast, Precision::exact}) {
    for (const TestShape& shape : oracle_shapes(0.25, {0.1, 0.05, 3})) {
      INFO(shape.name << " in " << id_of(precision));
      TestBench bench;
      bench.show({"power-crust"});
      ComputationSettings settings;
      settings.precision = precision;
      settings[Parameter::pole_propagation] = 1.0;
      bench.choose(settings);
      bench.replace(shape.data.positions);
      CHECK(bench.count("pole-labels", "inside") > 0);
      CHECK(bench.count("pole-labels", "against_triangle") == 0);
      CHECK(bench.count("pole-labels", "unreached") == 0);
      CHECK(bench.count("power-crust", "loops") ==
            static_cast<std::int64_t>(shape.expected.components + shape.expected.cycles));
    }
  }
}

TEST_CASE("the union of the interior polar balls has the topology of the shape") {
  for (const TestShape& shape :
       {ellipse(2.0, 1.0, 80, {0.3, 0.1, 11}), two_ellipses(2.0, 1.0, 1.0, 60, {0.3, 0.1, 3}),
        eccentric_hole(1.0, 3.0, 1.0, 0.3, {0.3, 0.1, 5})}) {
    INFO(shape.name);
    TestBench bench;
    bench.show({"p-ball-medial-axis"});
    ComputationSettings settings;
    settings.precision = Precision::exact;
    bench.choose(settings);
    bench.replace(shape.data.positions);
    CHECK(bench.count("p-union", "components") == static_cast<std::int64_t>(shape.expected.components));
    CHECK(bench.count("p-union", "cycles") == static_cast<std::int64_t>(shape.expected.cycles));
    CHECK(bench.count("p-union", "chi") == bench.count("p-union", "chi_dual"));
  }
}

TEST_CASE("the paper's layers are all there") {
  CHECK(std::ranges::count_if(layer_descriptors(), &LayerDescriptor::in_paper) == 41);
}
