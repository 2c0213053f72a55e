// SPDX-License-Identifier: GPL-3.0-or-later
// Centre lines of the exact axis: known shapes, nearest points in a plain loop over all sides, and the lines of samples.
#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <limits>
#include <vector>

#include "core/base/rng.h"
#include "core/curves/curve.h"
#include "core/structures/outline/outline_center_lines.h"
#include "tests/core/structures/outline/outline_bench.h"
#include "tests/support/pi.h"

using namespace mes;
using namespace mes::test;

namespace {

using Polygon = Ring;

struct OutlineBench : AxisBench {
  explicit OutlineBench(const std::vector<Polygon>& polygons) : AxisBench(data_of_rings(polygons)) {}
  CenterLines lines(const CenterLineRequest& request = {}) {
    JobControl job;
    return center_lines_of(axis(), request, job);
  }
};

Polygon rectangle_at(double x, double y, double width, double height) {
  return {{x, y}, {x + width, y}, {x + width, y + height}, {x, y + height}};
}

/// A winding strip with random widths on both sides.
Polygon winding_strip(std::uint64_t seed) {
  Rng rng(seed);
  Polygon out;
  Polygon back;
  for (int i = 0; i <= 40; ++i) {
    const double x = 0.5 * i;
    const double y = 2.0 * std::sin(0.4 * x);
    out.push_back({x, y - rng.uniform(0.4, 0.7)});
    back.push_back({x, y + rng.uniform(0.4, 0.7)});
  }
  out.insert(out.end(), back.rbegin(), back.rend());
  return out;
}

double distance_to_sides(const Polygon& polygon, Vec2 p) {
  double out = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Vec2 a = polygon[i];
    const Vec2 side = polygon[(i + 1) % polygon.size()] - a;
    const double share = std::clamp(dot(p - a, side) / dot(side, side), 0.0, 1.0);
    out = std::min(out, distance(a + share * side, p));
  }
  return out;
}

}  // namespace

TEST_CASE("the centre line of a rectangle is its middle line, and its banks are the long sides") {
  OutlineBench bench({rectangle_at(3.0, 5.0, 10.0, 2.0)});
  CenterLines set = bench.lines();
  REQUIRE(set.lines.size() == 1);
  CenterLine& line = set.lines.front();
  CHECK(line.axis.front() == Vec2{4.0, 6.0});
  CHECK(line.axis.back() == Vec2{12.0, 6.0});
  CHECK(length_of(line) == Approx(8.0).epsilon(1e-14));
  const Widths widths = widths_of(line);
  CHECK(widths.least == 2.0);
  CHECK(widths.largest == 2.0);
  const std::vector<Station> stations = stations_of(line, 1.0);
  REQUIRE(stations.size() == 9);
  for (const Station& at : stations) {
    CHECK(at.left == Vec2{at.axis.x, 7.0});
    CHECK(at.right == Vec2{at.axis.x, 5.0});
    CHECK(at.direction == 0.0);
  }
  smooth(set, kUsualSmoothing);
  extend_to_outline(set, bench.get<OutlineAxis>());
  CHECK(line.points.front().place == Vec2{3.0, 6.0});
  CHECK(line.points.back().place == Vec2{13.0, 6.0});
  // Without pruning the line ends in two corners, and an end there stays.
  CenterLines whole = bench.lines({.least_salience = 0.0});
  REQUIRE(whole.lines.size() == 1);
  CHECK(length_of(whole.lines.front()) == Approx(8.0 + 2.0 * std::sqrt(2.0)));
  CHECK(radius_at(whole.lines.front().banks.front()[0], whole.lines.front().axis.front()) == 0.0);
  const double before = length_of(whole.lines.front());
  extend_to_outline(whole, bench.get<OutlineAxis>());
  CHECK(length_of(whole.lines.front()) == before);
}

TEST_CASE("parcels with a common border have a centre line each") {
  OutlineBench bench(
      {rectangle_at(0.0, 0.0, 10.0, 2.0), rectangle_at(10.0, 0.0, 2.0, 8.0), rectangle_at(0.0, 2.0, 10.0, 3.0)});
  const CenterLines set = bench.lines();
  REQUIRE(set.lines.size() == 3);
  std::vector<double> lengths;
  for (const CenterLine& line : set.lines) {
    CHECK(line.rank == 0);
    lengths.push_back(length_of(line));
  }
  CHECK(lengths == std::vector<double>{8.0, 7.0, 6.0});
  // Corners that parcels share join no lines, pruned or not.
  for (const CenterLine& line : bench.lines({.least_salience = 0.0}).lines) CHECK(line.shape < 3);
}

TEST_CASE("a frame has a closed line, and a square has a point") {
  Polygon hole = rectangle_at(2.0, 2.0, 8.0, 4.0);
  std::ranges::reverse(hole);
  OutlineBench frame({rectangle_at(0.0, 0.0, 12.0, 8.0), hole});
  const CenterLines set = frame.lines();
  REQUIRE(set.lines.size() == 1);
  CHECK(set.lines.front().is_closed);
  // Along the sides of the hole, and about each of its corners two arcs of parabolas, to the diagonal.
  const double slope = std::sqrt(2.0) - 1.0;
  const double arc = slope * std::hypot(1.0, slope) + std::asinh(slope);
  CHECK(length_of(set.lines.front()) == Approx(24.0 + 8.0 * arc).epsilon(1e-3));
  CHECK(widths_of(set.lines.front()).least == Approx(2.0).epsilon(1e-12));
  const CenterLines square = OutlineBench({rectangle_at(0.0, 0.0, 2.0, 2.0)}).lines();
  CHECK(square.lines.empty());
  CHECK(square.points == 1);
}

TEST_CASE("each point of the axis is as far from its banks as from the outline") {
  for (std::uint64_t seed = 1; seed <= 10; ++seed) {
    const Polygon strip = winding_strip(seed);
    OutlineBench bench({strip});
    CenterLines set = bench.lines();
    REQUIRE(set.lines.size() == 1);
    CenterLine& line = set.lines.front();
    REQUIRE(line.banks.size() + 1 == line.axis.size());
    for (std::size_t i = 0; i < line.banks.size(); ++i)
      for (const Vec2 at : {line.axis[i], line.axis[i + 1]}) {
        const double radius = distance_to_sides(strip, at);
        for (const Bank& bank : line.banks[i]) CHECK(radius_at(bank, at) == Approx(radius).epsilon(1e-9));
      }
    // Smoothing keeps the line inside, and stations see the left bank at the left.
    smooth(set, kUsualSmoothing);
    for (const Station& at : stations_of(line, 0.25)) {
      CHECK(distance_to_sides(strip, at.axis) <= 0.5 * at.width + 1e-9);
      const Vec2 way{std::cos(at.direction * kPi / 180.0), std::sin(at.direction * kPi / 180.0)};
      // A line that ends in a corner has no width there.
      if (at.width != 0.0) CHECK(cross(way, at.left - at.right) > 0.0);
    }
  }
}

TEST_CASE("the line does not depend on the order and the beginning of contours") {
  const Polygon strip = winding_strip(7);
  Polygon turned = strip;
  std::ranges::rotate(turned, turned.begin() + 17);
  Polygon reversed = strip;
  std::ranges::reverse(reversed);
  const Polygon other = rectangle_at(30.0, 0.0, 4.0, 1.0);
  const CenterLines first = OutlineBench({strip, other}).lines({.most = 3});
  for (const auto& polygons : {std::vector{turned, other}, std::vector{other, reversed}}) {
    const CenterLines again = OutlineBench(polygons).lines({.most = 3});
    REQUIRE(again.lines.size() == first.lines.size());
    for (std::size_t i = 0; i < first.lines.size(); ++i) CHECK(again.lines[i].axis == first.lines[i].axis);
  }
}

TEST_CASE("strips of any thinness have their middle line") {
  for (const double width : {1e-3, 1e-6, 1e-9}) {
    const CenterLines set = OutlineBench({rectangle_at(0.0, 0.0, 1.0, width)}).lines();
    REQUIRE(set.lines.size() == 1);
    CHECK(length_of(set.lines.front()) == Approx(1.0 - width).epsilon(1e-12));
    CHECK(widths_of(set.lines.front()).mean == Approx(width).epsilon(1e-9));
  }
}
