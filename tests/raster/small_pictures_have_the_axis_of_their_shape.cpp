// SPDX-License-Identifier: GPL-3.0-or-later
// Disks, ellipses, turned squares and shapes with blunt ends, from a few pixels to hundreds, with soft edges and of two values: area and ends of
// the axis as the shape has them.
#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <functional>
#include <numbers>
#include <vector>

#include "core/curves/sampling.h"
#include "core/raster/trace.h"
#include "tests/raster/rendered.h"
#include "tests/support/workbench.h"

using namespace mes;
using namespace mes::test;

namespace {

/// Places along a side of a pixel: fewer in large pictures.
int places(int fine, double size) {
  return fine > 1 && size > 60.0 ? 8 : fine;
}

struct Shape {
  Vec2 center{};
  double angle = 0.0;
  double along = 0.0;   // half
  double across = 0.0;  // half
  Vec2 in_frame(Vec2 p) const {
    const Vec2 d = p - center;
    return {std::cos(angle) * d.x + std::sin(angle) * d.y, std::cos(angle) * d.y - std::sin(angle) * d.x};
  }
  bool ellipse_has(Vec2 p) const {
    const Vec2 q = in_frame(p);
    const Vec2 u{q.x / along, q.y / across};
    return dot(u, u) <= 1.0;
  }
  bool rectangle_has(Vec2 p) const {
    const Vec2 q = in_frame(p);
    return std::abs(q.x) <= along && std::abs(q.y) <= across;
  }
  int side() const { return static_cast<int>(2.0 * std::hypot(along, across)) + 12; }
};

/// One of `turn` for each of some positions between pixels and directions; the first lies symmetrically.
Shape shape_of(int turn, double along, double across) {
  Shape out{.angle = 0.37 * turn, .along = along, .across = across};
  const double middle = 0.5 * out.side();
  out.center = turn == 0 ? Vec2{std::floor(middle), std::floor(middle)}
                         : Vec2{middle + 0.137 * turn + 0.31, middle - 0.271 + 0.093 * turn};
  return out;
}

struct Found {
  double area = 0.0;
  std::int64_t leaves = 0;
  std::vector<Vec2> samples;
};

Found found_in(const GrayImage& image) {
  const auto tracing = trace(image, {});
  INFO((tracing ? std::string() : tracing.error().text));
  REQUIRE(tracing.has_value());
  REQUIRE(tracing->curves.curves.size() == 1);
  Found out;
  const auto dense = sample(tracing->curves, {.rule = SamplingRule::count, .count = 20'000});
  REQUIRE(dense.has_value());
  const std::vector<Vec2>& p = dense->positions;
  for (std::size_t i = 0; i < p.size(); ++i) out.area += 0.5 * cross(p[i], p[i + 1 < p.size() ? i + 1 : 0]);
  const auto samples = sample(tracing->curves, sampling_of_tracing(tracing->curves));
  REQUIRE(samples.has_value());
  out.samples = samples->positions;
  TestBench bench;
  bench.show({"medial-axis"});
  bench.replace(samples->positions);
  out.leaves = bench.count("medial-axis", "leaves");
  return out;
}

}  // namespace

TEST_CASE("the axis of a traced disk has two ends at most, and the disk its area") {
  for (const double radius : {4.0, 6.0, 8.0, 12.0, 24.0, 50.0, 100.0, 200.0})
    for (const int fine : {1, kFine})
      for (const int turn : {0, 1, 2}) {
        const Shape shape = shape_of(turn, radius, radius);
        const Found disk = found_in(rendered(shape.side(), shape.side(), places(fine, shape.along),
                                             [&](Vec2 p) { return shape.ellipse_has(p); }));
        INFO("radius " << radius << ", fine " << fine << ", turn " << turn);
        CHECK(disk.leaves <= 2);
        // Pixels of two values say where a boundary is within half a pixel, and together within a fraction of that.
        const double true_area = std::numbers::pi * radius * radius;
        if (fine != 1) CHECK(disk.area == Approx(true_area).epsilon(radius < 6.0 ? 0.005 : 0.003));
        double farthest = 0.0;
        for (const Vec2 p : disk.samples) farthest = std::max(farthest, std::abs(distance(p, shape.center) - radius));
        CHECK(farthest < (fine == 1 ? 0.3 : 0.03));
      }
}

TEST_CASE("the axis of a traced ellipse has two ends, and is as long as it should be") {
  for (const double half : {8.0, 12.0, 20.0, 40.0, 100.0, 200.0})
    for (const double ratio : {0.5, 0.8})
      for (const int fine : {1, kFine})
        for (const int turn : {0, 1, 2}) {
          const Shape shape = shape_of(turn, half, ratio * half);
          const Found ellipse = found_in(rendered(shape.side(), shape.side(), places(fine, shape.along),
                                                  [&](Vec2 p) { return shape.ellipse_has(p); }));
          INFO("half " << half << ", ratio " << ratio << ", fine " << fine << ", turn " << turn);
          CHECK(ellipse.leaves == 2);
          if (fine != 1) CHECK(ellipse.area == Approx(std::numbers::pi * half * half * ratio).epsilon(0.003));
        }
}

TEST_CASE("the axis of a traced square ends in its four corners") {
  for (const double side : {12.0, 16.0, 24.0, 50.0, 100.0, 200.0})
    for (const int fine : {1, kFine})
      for (const int turn : {0, 1, 2, 3}) {
        if (fine == 1 && side < 16.0) continue;
        const Shape shape = shape_of(turn, 0.5 * side, 0.5 * side);
        const Found square = found_in(rendered(shape.side(), shape.side(), places(fine, shape.along),
                                               [&](Vec2 p) { return shape.rectangle_has(p); }));
        INFO("side " << side << ", fine " << fine << ", turn " << turn);
        CHECK(square.leaves == 4);
        if (fine != 1) CHECK(square.area == Approx(side * side).epsilon(side < 16.0 ? 0.005 : 0.003));
      }
}

// Blunt ends: without a curve whose curvature has few extremes there were up to ten twigs for each.
TEST_CASE("traced shapes with blunt ends have hardly more twigs than ends") {
  std::int64_t excess = 0, shapes = 0;
  const auto look = [&](const char* name, double size, std::int64_t ends, auto has) {
    for (const int fine : {1, kFine})
      for (const int turn : {0, 1}) {
        const Shape shape = shape_of(turn, size, size);
        const Found found = found_in(rendered(shape.side(), shape.side(), places(fine, size), [&](Vec2 p) {
          const Vec2 q = shape.in_frame(p);
          return has(q);
        }));
        INFO(name << " of " << size << ", fine " << fine << ", turn " << turn << ": " << found.leaves << " ends");
        CHECK(found.leaves >= ends);
        CHECK(found.leaves <= ends + 5);
        excess += found.leaves - ends;
        ++shapes;
      }
  };
  for (const double size : {16.0, 30.0, 60.0, 110.0}) {
    for (const int petals : {3, 5})
      look("flower", size, petals,
           [&](Vec2 q) { return length(q) <= 0.8 * size * (1.0 + 0.25 * std::cos(petals * std::atan2(q.y, q.x))); });
    look("bean", size, 2, [&](Vec2 q) {
      const double turn = std::atan2(q.y, q.x);
      return length(q) <= size * (0.7 + 0.25 * std::cos(turn) + 0.1 * std::cos(2.0 * turn));
    });
    look("capsule", size, 2, [&](Vec2 q) {
      return length(Vec2{std::max(std::abs(q.x) - 0.5 * size, 0.0), q.y}) <= 0.33 * size;
    });
  }
  INFO(excess << " twigs on " << shapes << " shapes");
  CHECK(2 * excess <= shapes);
}

TEST_CASE("a pixel more or less leaves no branch on a disk") {
  const Vec2 center{40.31, 39.73};
  for (const int fine : {1, kFine}) {
    GrayImage image = rendered(80, 80, fine, [&](Vec2 p) { return distance(p, center) <= 30.0; });
    // Above, below, and a notch at the right.
    const auto set = [&](int x, int y, std::uint8_t value) {
      image.values[static_cast<std::size_t>(y) * 80 + static_cast<std::size_t>(x)] = value;
    };
    int top = 0;
    while (image.at(40, top) < 128) ++top;
    set(40, top - 1, 255);
    int right = 79;
    while (image.at(right, 40) < 128) --right;
    set(right, 40, 0);
    INFO("fine " << fine);
    CHECK(found_in(image).leaves <= 2);
  }
}
