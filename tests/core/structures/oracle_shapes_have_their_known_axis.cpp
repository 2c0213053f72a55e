// SPDX-License-Identifier: GPL-3.0-or-later
// Shapes whose medial axis is known by formula, through the whole program: samples in, instances of layers and
// statistics out.
#include <algorithm>
#include <catch2/catch.hpp>
#include <numbers>

#include "tests/support/axis_picture.h"
#include "tests/support/shapes/shapes.h"
#include "tests/support/workbench.h"

using namespace mes;
using namespace mes::test;

namespace {

struct Ball {
  Vec2 center;
  double radius;
};

std::vector<Ball> inner_balls(const TestBench& bench) {
  std::vector<Ball> out;
  const auto values = bench.instances("interior-voronoi-disks", PrimitiveKind::disk);
  for (std::size_t at = 0; at < values.size(); at += stride_of(PrimitiveKind::disk))
    out.push_back({{values[at], values[at + 1]}, values[at + 2]});
  return out;
}

AxisPicture picture_of(const TestBench& bench, const TestShape& shape) {
  return axis_picture(bench.instances("medial-axis", PrimitiveKind::segment), shape.expected.merge_distance);
}

// Each expected place has exactly one of the points within the tolerance, and none is left over.
void check_places(std::vector<Vec2> points, const std::vector<Vec2>& expected, double tolerance) {
  CHECK(points.size() == expected.size());
  for (const Vec2 place : expected) {
    INFO("expected at " << place.x << ", " << place.y << ", tolerance " << tolerance);
    const auto near = [&](Vec2 p) { return distance(p, place) <= tolerance; };
    CHECK(std::ranges::count_if(points, near) == 1);
  }
}

void check_facts(const TestBench& bench, const TestShape& shape) {
  const Facts& facts = shape.expected;
  // The graph as the structure counts it; components and cycles do not care about tiny edges.
  const auto components = static_cast<std::int64_t>(facts.components);
  const auto cycles = static_cast<std::int64_t>(facts.cycles);
  CHECK(bench.count("medial-axis", "components") == components);
  CHECK(bench.count("medial-axis", "cycles") == cycles);
  CHECK(bench.count("medial-axis", "chi") == components - cycles);
  CHECK(bench.count("medial-axis", "isolated") == 0);
  CHECK(bench.count("one-step-crust", "odd_samples") == 0);
  CHECK(bench.count("labels", "conflicts") == 0);
  // And as it is drawn.
  const AxisPicture picture = picture_of(bench, shape);
  CHECK(picture.components == facts.components);
  CHECK(picture.cycles() == facts.cycles);
  if (facts.leaves) CHECK(picture.with_degree(1).size() == *facts.leaves);
  if (facts.branch_points) CHECK(picture.with_degree(3).size() == *facts.branch_points);
  if (facts.axis_length) {
    CHECK(bench.measure("medial-axis", "length") ==
          Approx(*facts.axis_length).margin(facts.axis_length_tolerance + 1e-9));
    CHECK(picture.length == Approx(bench.measure("medial-axis", "length")).epsilon(1e-12));
  }
  if (facts.min_radius)
    CHECK(bench.measure("medial-axis", "radius_min") ==
          Approx(*facts.min_radius).margin(facts.radius_tolerance + 1e-9));
  if (facts.max_radius)
    CHECK(bench.measure("inner-balls", "radius_max") ==
          Approx(*facts.max_radius).margin(facts.radius_tolerance + 1e-9));
}

}  // namespace

TEST_CASE("every oracle shape has the components, cycles, ends, length and radii of its formula") {
  for (const double epsilon : {0.25, 0.1}) {
    for (const double offset : {0.0, 0.37}) {
      for (const double jitter : {0.0, 0.2}) {
        for (const TestShape& shape : oracle_shapes(epsilon, {offset, jitter, 11})) {
          INFO(shape.name << " offset " << offset << " jitter " << jitter);
          const ComparedBench bench(shape.data.positions);
          check_facts(bench, shape);
        }
      }
    }
  }
}

TEST_CASE("the axis of an ellipse ends at the centres of curvature, and its radii follow the formula") {
  for (const double a : {2.0, 3.0}) {
    for (const std::size_t n : {100U, 400U}) {
      const TestShape shape = ellipse(a, 1.0, n, {0.3, 0.0, 1});
      INFO(shape.name);
      const ComparedBench bench(shape.data.positions);
      const double c2 = a * a - 1.0;
      const double steps = static_cast<double>(n);
      const double tolerance = 20.0 * a * a * a / (steps * steps);
      check_places(picture_of(bench, shape).with_degree(1), {{c2 / a, 0.0}, {-c2 / a, 0.0}}, tolerance);
      const std::vector<Ball> balls = inner_balls(bench);
      CHECK(balls.size() == n - 2);
      for (const Ball& ball : balls) {
        const double on_axis = std::clamp(ball.center.x, -c2 / a, c2 / a);
        if (!(distance(ball.center, {on_axis, 0.0}) <= tolerance)) FAIL("a ball's centre is off the axis");
        const double radius = std::sqrt(1.0 - on_axis * on_axis / c2);
        if (!(std::abs(ball.radius - radius) <= tolerance)) FAIL("radius " << ball.radius << " not " << radius);
      }
    }
  }
}

TEST_CASE("the axis length of an ellipse converges with the square of the spacing") {
  const auto error = [](std::size_t n) {
    const ComparedBench bench(ellipse(2.0, 1.0, n, {0.25, 0.0, 1}).data.positions);
    return std::abs(bench.measure("medial-axis", "length") - 3.0);
  };
  CHECK(error(100) < 3e-3);
  CHECK(error(400) < 2e-4);
  CHECK(error(100) / error(400) > 10.0);
}

TEST_CASE("a stadium has one straight axis of constant radius, its caps merged into two ends") {
  for (const double epsilon : {0.25, 0.1}) {
    const TestShape shape = stadium(2.0, 1.0, epsilon, {0.3, 0.1, 2});
    INFO(shape.name);
    const ComparedBench bench(shape.data.positions);
    const double tolerance = epsilon * epsilon;
    check_places(picture_of(bench, shape).with_degree(1), {{-2.0, 0.0}, {2.0, 0.0}}, tolerance);
    for (const Ball& ball : inner_balls(bench)) {
      if (!(std::abs(ball.center.y) <= tolerance)) FAIL("a ball's centre is off the axis");
      if (!(std::abs(ball.radius - 1.0) <= tolerance)) FAIL("radius " << ball.radius);
    }
  }
}

TEST_CASE("an annulus with aligned samples has a regular polygon for its axis") {
  for (const std::size_t n : {16U, 60U}) {
    const TestShape shape = annulus_aligned(1.0, 2.0, n);
    INFO(shape.name);
    const ComparedBench bench(shape.data.positions);
    const double sides = static_cast<double>(n);
    const double angle = std::numbers::pi / sides;
    CHECK(bench.measure("medial-axis", "length") == Approx(3.0 * sides * std::tan(angle)).epsilon(1e-12));
    if (n == 16) CHECK(bench.measure("medial-axis", "length") == Approx(9.547794).epsilon(1e-7));
    const AxisPicture picture = picture_of(bench, shape);
    CHECK(picture.nodes.size() == n);
    CHECK(picture.with_degree(2).size() == n);
    for (const AxisPicture::Node& node : picture.nodes)
      CHECK(length(node.position) == Approx(3.0 / (2.0 * std::cos(angle))).epsilon(1e-12));
  }
}

TEST_CASE("the balls of an annulus stand on its middle circle") {
  for (const double inner : {1.0, 0.3}) {
    const TestShape shape = annulus(inner, 2.0, 0.1, {0.4, 0.2, 3});
    INFO(shape.name);
    const ComparedBench bench(shape.data.positions);
    const std::vector<Ball> balls = inner_balls(bench);
    CHECK(balls.size() == shape.data.positions.size());
    for (const Ball& ball : balls) {
      if (!(std::abs(length(ball.center) - 0.5 * (inner + 2.0)) <= 0.02)) FAIL("centre at " << length(ball.center));
      if (!(std::abs(ball.radius - 0.5 * (2.0 - inner)) <= 0.02)) FAIL("radius " << ball.radius);
    }
  }
}

TEST_CASE("the axis round an eccentric hole is an ellipse with its foci at the two centres") {
  const TestShape shape = eccentric_hole(1.0, 3.0, 1.0, 0.1, {0.2, 0.1, 4});
  const ComparedBench bench(shape.data.positions);
  CHECK(bench.measure("medial-axis", "length") == Approx(12.3676580).margin(shape.expected.axis_length_tolerance));
  for (const Ball& ball : inner_balls(bench)) {
    const double to_hole = distance(ball.center, {1.0, 0.0});
    if (!(std::abs(to_hole + length(ball.center) - 4.0) <= 0.04)) FAIL("a ball's centre is off the ellipse");
    if (!(std::abs(ball.radius - (to_hole - 1.0)) <= 0.03)) FAIL("radius " << ball.radius);
  }
}

TEST_CASE("a rounded rectangle has its branch points and ends where the formula says") {
  for (const double epsilon : {0.25, 0.1}) {
    const TestShape shape = rounded_rectangle(3.0, 2.0, 0.5, epsilon, {0.3, 0.1, 5});
    INFO(shape.name);
    const ComparedBench bench(shape.data.positions);
    const AxisPicture picture = picture_of(bench, shape);
    // Samples round about a branch point miss its contacts by half a spacing.
    const double tolerance = 4.0 * epsilon * epsilon;
    check_places(picture.with_degree(3), {{-1.0, 0.0}, {1.0, 0.0}}, tolerance);
    check_places(picture.with_degree(1), {{2.5, 1.5}, {-2.5, 1.5}, {-2.5, -1.5}, {2.5, -1.5}}, tolerance);
    for (const Ball& ball : inner_balls(bench)) {
      const Vec2 c{std::abs(ball.center.x), std::abs(ball.center.y)};
      const double radius = std::min(2.0 - c.y, 3.0 - c.x);
      if (!(std::abs(ball.radius - radius) <= tolerance)) FAIL("radius " << ball.radius << " not " << radius);
    }
  }
}

TEST_CASE("two ellipses have two axes, each its own") {
  const TestShape shape = two_ellipses(2.0, 1.0, 0.5, 200, {0.3, 0.0, 6});
  const ComparedBench bench(shape.data.positions);
  check_places(picture_of(bench, shape).with_degree(1), {{-1.5, 0.0}, {1.5, 0.0}, {3.0, 0.0}, {6.0, 0.0}}, 0.004);
}

TEST_CASE("axis nodes are drawn at the leaves and branch points") {
  for (const TestShape& shape : oracle_shapes(0.25, {0.3, 0.2, 8})) {
    INFO(shape.name);
    const ComparedBench bench(shape.data.positions);
    const auto drawn = bench.instances("axis-nodes", PrimitiveKind::point);
    std::int64_t leaves = 0;
    std::int64_t branch_points = 0;
    for (std::size_t at = 0; at < drawn.size(); at += stride_of(PrimitiveKind::point)) {
      leaves += drawn[at + 2] == 1.0 ? 1 : 0;
      branch_points += drawn[at + 2] >= 3.0 ? 1 : 0;
    }
    CHECK(leaves == bench.count("medial-axis", "leaves"));
    CHECK(branch_points == bench.count("medial-axis", "branch_points"));
    CHECK(leaves + branch_points == static_cast<std::int64_t>(drawn.size() / stride_of(PrimitiveKind::point)));
  }
}
