// SPDX-License-Identifier: GPL-3.0-or-later
// This checks the generators themselves, by the definition of the crust and in plain loops, so that a wrong generator
// cannot hide a wrong structure.
#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <limits>
#include <set>
#include <utility>

#include "tests/support/shapes/shapes.h"
#include "tests/support/shapes/shapes_benchmark.h"
#include "tests/support/shapes/shapes_degenerate.h"

using namespace mes;
using namespace mes::test;

namespace {

using Edge = std::pair<std::size_t, std::size_t>;

/// The edge qr is crust if its largest opposite angles on both sides add up to at most 90 degrees, that is cot(alpha)
/// cot(beta) >= 1; smallest cotangent = largest angle. O(n^3), in doubles.
std::set<Edge> crust_by_definition(const std::vector<Vec2>& points) {
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  std::set<Edge> crust;
  for (std::size_t q = 0; q < points.size(); ++q) {
    for (std::size_t r = q + 1; r < points.size(); ++r) {
      double left = kInfinity;
      double right = kInfinity;
      for (std::size_t i = 0; i < points.size() && std::min(left, right) >= 0.0; ++i) {
        if (i == q || i == r) continue;
        const Vec2 a = points[q] - points[i];
        const Vec2 b = points[r] - points[i];
        const double side = cross(a, b);
        const double along = dot(a, b);
        if (side > 0.0) left = std::min(left, along / side);
        if (side < 0.0) right = std::min(right, along / -side);
        if (side == 0.0 && along <= 0.0) left = -1.0;  // between q and r
      }
      if (left < 0.0 || right < 0.0) continue;
      const bool is_crust = left == kInfinity || right == kInfinity || left * right >= 1.0;
      if (is_crust) crust.insert({q, r});
    }
  }
  return crust;
}

std::set<Edge> contour_edges(const SampleData& data) {
  std::set<Edge> edges;
  for (const SampleData::Contour& contour : data.contours) {
    for (std::size_t i = 0; i < contour.points.size(); ++i) {
      const std::size_t a = contour.points[i];
      const std::size_t b = contour.points[(i + 1) % contour.points.size()];
      edges.insert({std::min(a, b), std::max(a, b)});
    }
  }
  return edges;
}

double signed_area(const SampleData& data, const SampleData::Contour& contour) {
  double sum = 0.0;
  for (std::size_t i = 0; i < contour.points.size(); ++i)
    sum += cross(data.positions[contour.points[i]], data.positions[contour.points[(i + 1) % contour.points.size()]]);
  return 0.5 * sum;
}

std::size_t odd_count(const std::set<Edge>& crust, std::size_t samples) {
  std::vector<std::size_t> degree(samples, 0);
  for (const Edge& edge : crust) {
    ++degree[edge.first];
    ++degree[edge.second];
  }
  return static_cast<std::size_t>(
      std::count_if(degree.begin(), degree.end(), [](std::size_t d) { return d % 2 == 1; }));
}

}  // namespace

TEST_CASE("the crust of every oracle shape is its contours") {
  for (const double offset : {0.0, 0.37}) {
    for (const double jitter : {0.0, 0.2}) {
      for (const TestShape& shape : oracle_shapes(0.4, {offset, jitter, 3})) {
        INFO(shape.name << " offset " << offset << " jitter " << jitter);
        CHECK(shape.data.positions.size() < 700);
        CHECK(crust_by_definition(shape.data.positions) == contour_edges(shape.data));
      }
    }
  }
}

TEST_CASE("shapes keep the interior on the left") {
  for (const TestShape& shape : oracle_shapes(0.3)) {
    INFO(shape.name);
    double total = 0.0;
    for (const SampleData::Contour& contour : shape.data.contours) total += signed_area(shape.data, contour);
    CHECK(signed_area(shape.data, shape.data.contours[0]) > 0.0);
    CHECK(total > 0.0);
    if (shape.expected.cycles == 1 && shape.expected.components == 1)
      CHECK(signed_area(shape.data, shape.data.contours[1]) < 0.0);
  }
}

TEST_CASE("graded samples are as dense as promised") {
  for (const double jitter : {0.0, 0.25}) {
    const TestShape shape = ellipse_graded(3.0, 1.0, 0.2, {0.1, jitter, 9});
    const double end = (9.0 - 1.0) / 3.0;
    double worst = 0.0;
    for (int i = 0; i < 5000; ++i) {
      const double t = 2.0 * M_PI * i / 5000.0;
      const Vec2 x{3.0 * std::cos(t), std::sin(t)};
      const double lfs = std::hypot(std::max(0.0, std::abs(x.x) - end), x.y);
      double nearest = std::numeric_limits<double>::infinity();
      for (const Vec2 p : shape.data.positions) nearest = std::min(nearest, distance(p, x));
      worst = std::max(worst, nearest / lfs);
    }
    CHECK(worst <= 0.2);
    CHECK(worst >= 0.08);  // and not wastefully denser
  }
}

TEST_CASE("facts of the degenerate inputs agree with the definition") {
  for (const DegenerateInput& input : degenerate_inputs()) {
    INFO(input.name);
    std::vector<Vec2> points;
    for (const Vec2 p : input.positions)
      if (std::find(points.begin(), points.end(), p) == points.end()) points.push_back(p);
    CHECK(points.size() == input.distinct);
    double largest = 0.0;
    double smallest = std::numeric_limits<double>::infinity();
    for (const Vec2 p : points)
      for (const Vec2 q : points) {
        largest = std::max(largest, distance(p, q));
        if (!(p == q)) smallest = std::min(smallest, distance(p, q));
      }
    const bool doubles_suffice = largest < 1e100 && smallest > 1e-100 && largest / smallest < 1e12;
    if (!input.crust_edges || !doubles_suffice || input.name == "flat triangle") continue;
    const std::set<Edge> crust = crust_by_definition(points);
    CHECK(crust.size() == *input.crust_edges);
    REQUIRE(input.odd_samples);
    CHECK(odd_count(crust, points.size()) == *input.odd_samples);
  }
}

TEST_CASE("benchmark inputs are what their names say") {
  const std::vector<Vec2> clean = benchmark_curve(1000);
  std::set<Edge> ring;
  for (std::size_t i = 0; i < clean.size(); ++i) {
    const std::size_t j = (i + 1) % clean.size();
    ring.insert({std::min(i, j), std::max(i, j)});
  }
  CHECK(crust_by_definition(clean) == ring);
  const std::vector<Vec2> rough = rough_curve(1000);
  const std::size_t odd = odd_count(crust_by_definition(rough), rough.size());
  CHECK(odd > 0);
  CHECK(odd < 100);
  CHECK(odd_count(crust_by_definition(noisy_curve(400)), 400) > 40);
  CHECK(odd_count(crust_by_definition(uniform_square(300)), 300) > 60);
  CHECK(benchmark_curve(100) == benchmark_curve(100));
  CHECK(benchmark_curve(100, 2) != benchmark_curve(100));

  std::vector<Vec2> places = duplicate_heavy(400);
  std::sort(places.begin(), places.end(), lexicographically_less);
  places.erase(std::unique(places.begin(), places.end()), places.end());
  CHECK(places.size() <= 100);
  CHECK(places.size() > 80);
}
