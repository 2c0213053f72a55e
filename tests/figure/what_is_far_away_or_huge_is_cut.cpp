// SPDX-License-Identifier: GPL-3.0-or-later
#include <catch2/catch.hpp>

#include "layers_of_a_test.h"

using namespace mes;
using namespace mes::figure;
using test::Layers;
using test::shapes_of;

namespace {

constexpr double kWidth = 200.0;
constexpr double kHeight = 100.0;
// The stroke of a pixel and a point more.
constexpr double kBeyond = 0.375 + 1.0;

Vec2 on_curve(const Shape& shape, double t) {
  const double s = 1.0 - t;
  return s * s * s * shape.p[0] + 3.0 * s * s * t * shape.p[1] + 3.0 * s * t * t * shape.p[2] +
         t * t * t * shape.p[3];
}

std::vector<Shape> seen(PrimitiveKind kind, std::vector<double> instance) {
  Layers layers;
  layers.add(0, kind, std::move(instance));
  layers.show(0);
  return shapes_of(layers.figure(kWidth, kHeight).layers[0]);
}

bool is_near_page(Vec2 p, double beyond) {
  return p.x >= -beyond && p.y >= -beyond && p.x <= kWidth + beyond && p.y <= kHeight + beyond;
}

}  // namespace

TEST_CASE("segments, rays and lines end at the page, on the line that they were on") {
  struct Case {
    PrimitiveKind kind;
    std::vector<double> instance;
  };
  for (const Case& each :
       {Case{PrimitiveKind::segment, {-1e9, 20, 1e9, 60, 0}}, Case{PrimitiveKind::ray, {50, 40, 2e-9, 4e-17, 0}},
        Case{PrimitiveKind::ray, {1e12, 40, -1, 0, 0}},
        Case{PrimitiveKind::line, {-1e6, 40 - 2e-2, 1e200, 2e192, 0}}}) {
    const std::vector<Shape> shapes = seen(each.kind, each.instance);
    REQUIRE(shapes.size() == 1);
    CHECK(shapes[0].kind == ShapeKind::segment);
    for (const Vec2 end : {shapes[0].p[0], shapes[0].p[1]}) {
      CHECK(is_near_page(end, kBeyond + 0.01));
      CHECK(end.y == Approx(60.0).margin(0.011));
    }
    CHECK(std::max(shapes[0].p[0].x, shapes[0].p[1].x) > kWidth + 1.0);
  }
}

TEST_CASE("what lies beyond the page is left out") {
  CHECK(seen(PrimitiveKind::point, {-10, 50, 0}).empty());
  CHECK(seen(PrimitiveKind::segment, {-10, 50, -5, 80, 0}).empty());
  CHECK(seen(PrimitiveKind::segment, {-10, 50, 90, 1000, 0}).empty());
  CHECK(seen(PrimitiveKind::ray, {-10, 50, -1, 0, 0}).empty());
  CHECK(seen(PrimitiveKind::disk, {-100, 50, 90, 0}).empty());
  // Around the page, and beside it.
  CHECK(seen(PrimitiveKind::circle, {100, 50, 150, 0}).empty());
  CHECK(seen(PrimitiveKind::circle, {-1e7, 50, 0.9e7, 0}).empty());
  CHECK(seen(PrimitiveKind::circle, {100, 50, 1e7, 0}).empty());
  CHECK(seen(PrimitiveKind::arc, {100, 50, 98, 2, 50, 100, 148, 0}).size() == 1);
  CHECK(seen(PrimitiveKind::arc, {100, 50, 60, 160, 50, 40, 50, 0}).size() == 1);
  CHECK(seen(PrimitiveKind::arc, {100, -20, 60, 40, -20, 160, -20, 0}).empty());
  CHECK(seen(PrimitiveKind::triangle, {-5, 0, -9, 50, -3, 90, 0}).empty());
}

TEST_CASE("a huge circle is a curve within a thousandth of a point of it") {
  for (const double radius : {1e3, 1e4, 1e7, 1e11}) {
    for (const double angle : {0.0, 0.5, 2.0, 4.0}) {
      const Vec2 through{120.0, 30.0};
      const Vec2 center = through - radius * Vec2{std::cos(angle), std::sin(angle)};
      const std::vector<Shape> shapes = seen(PrimitiveKind::circle, {center.x, center.y, radius, 0});
      INFO(radius << ' ' << angle);
      REQUIRE(shapes.size() == 1);
      REQUIRE(shapes[0].kind == ShapeKind::curve);
      double nearest = 1e9;
      for (int i = 0; i <= 100; ++i) {
        const Vec2 p = on_curve(shapes[0], 0.01 * i);
        const Vec2 in_plane{p.x, kHeight - p.y};
        // Ends and handles are rounded to a hundredth at most.
        CHECK(distance(in_plane, center) == Approx(radius).margin(0.01 + 1e-15 * radius));
        nearest = std::min(nearest, distance(in_plane, through));
      }
      CHECK(nearest < 2.0);
      CHECK_FALSE(is_near_page(shapes[0].p[0], 0.0));
      CHECK_FALSE(is_near_page(shapes[0].p[3], 0.0));
    }
  }
}

TEST_CASE("an arc of a huge circle ends where it ends, and may be seen twice") {
  const double radius = 1e6;
  const Vec2 center{100.0, 50.0 - radius};
  const auto at = [&](double x) { return Vec2{x, center.y + std::sqrt(radius * radius - (x - 100) * (x - 100))}; };
  const Vec2 left = at(70.0);
  const Vec2 right = at(130.0);
  const std::vector<Shape> inner =
      seen(PrimitiveKind::arc, {center.x, center.y, radius, right.x, right.y, left.x, left.y, 0});
  REQUIRE(inner.size() == 1);
  CHECK(distance(inner[0].p[0], {130.0, 50.0}) < 0.02);
  CHECK(distance(inner[0].p[3], {70.0, 50.0}) < 0.02);
  const std::vector<Shape> outer =
      seen(PrimitiveKind::arc, {center.x, center.y, radius, left.x, left.y, right.x, right.y, 0});
  REQUIRE(outer.size() == 2);
  const auto ends_at = [&](double x) {
    return std::ranges::any_of(outer, [&](const Shape& shape) {
      return distance(shape.p[0], {x, 50.0}) < 0.02 || distance(shape.p[3], {x, 50.0}) < 0.02;
    });
  };
  CHECK(ends_at(70.0));
  CHECK(ends_at(130.0));
}

TEST_CASE("a huge disk covers the part of the page that it covers") {
  const auto is_in = [](const Shape& shape, Vec2 p) {
    // A polygon along the rim; p is inside if it lies on the same side of all of it.
    std::vector<Vec2> corners;
    for (int i = 0; i <= 64; ++i) corners.push_back(on_curve(shape, i / 64.0));
    corners.push_back(shape.p[4]);
    corners.push_back(shape.p[5]);
    int turn = 0;
    for (std::size_t i = 0; i < corners.size(); ++i) {
      const Vec2 a = corners[i];
      const Vec2 b = corners[(i + 1) % corners.size()];
      if ((a.y > p.y) == (b.y > p.y)) continue;
      if (p.x < a.x + (p.y - a.y) / (b.y - a.y) * (b.x - a.x)) turn += b.y > a.y ? 1 : -1;
    }
    return turn != 0;
  };
  for (const double radius : {1e3, 1e5, 1e9}) {
    for (const double angle : {0.0, 1.0, 2.5, 5.0}) {
      for (const double depth : {-40.0, 0.0, 60.0, 500.0}) {
        // The rim passes `depth` beyond the middle of the page.
        const Vec2 center = Vec2{100, 50} - (radius - depth) * Vec2{std::cos(angle), std::sin(angle)};
        const std::vector<Shape> shapes = seen(PrimitiveKind::disk, {center.x, center.y, radius, 0});
        INFO(radius << ' ' << angle << ' ' << depth);
        for (double x = 1.0; x < kWidth; x += 22.0) {
          for (double y = 1.0; y < kHeight; y += 14.0) {
            const double inside = radius - distance(center, {x, y});
            if (std::abs(inside) < 0.05) continue;
            CHECK((!shapes.empty() && is_in(shapes[0], {x, kHeight - y})) == (inside > 0.0));
          }
        }
      }
    }
  }
}

TEST_CASE("no circle is without extent, however small it is") {
  for (const double radius : {0.0, 1e-300, 1e-5}) {
    for (const PrimitiveKind kind : {PrimitiveKind::disk, PrimitiveKind::circle}) {
      const std::vector<Shape> shapes = seen(kind, {50, 50, radius, 0});
      REQUIRE(shapes.size() == 1);
      CHECK(shapes[0].radius > 0.0);
      CHECK(shapes[0].radius <= 0.01);
    }
  }
}

TEST_CASE("a huge triangle is cut to pieces that cover the same of the page") {
  const std::vector<Shape> shapes = seen(PrimitiveKind::triangle, {-1e8, -1e8, 1e8, -1e8, 100, 50, 0});
  REQUIRE_FALSE(shapes.empty());
  double area = 0.0;
  for (const Shape& shape : shapes) {
    area += 0.5 * cross(shape.p[1] - shape.p[0], shape.p[2] - shape.p[0]);
    for (std::size_t i = 0; i < 3; ++i) CHECK(is_near_page(shape.p[i], kBeyond + 0.01));
  }
  // Below the apex with a right angle, cut at the lower edge of the page and a little more.
  const double height = 50.0 + kBeyond;
  CHECK(area == Approx(height * height).epsilon(1e-3));
}

TEST_CASE("any coordinates give numbers of the page's size") {
  for (const double size : {1e-300, 1e-20, 1.0, 1e20, 1e150}) {
    Layers layers;
    layers.add(0, PrimitiveKind::disk, {size, size, size, 0, -size, size, 3 * size, 0});
    layers.add(0, PrimitiveKind::circle, {size, -size, 1.4 * size, 0});
    layers.add(0, PrimitiveKind::segment, {-size, -size, size, 2 * size, 0});
    layers.add(0, PrimitiveKind::line, {size, size, size, 1.5 * size, 0});
    layers.add(0, PrimitiveKind::triangle, {-size, -size, size, -size, 0, size, 0});
    layers.add(0, PrimitiveKind::arc, {0, 0, size, size, 0, 0, size, 0});
    layers.show(0).dashed = true;
    for (const Shape& shape : shapes_of(layers.figure(kWidth, kHeight).layers[0])) {
      for (const Vec2 p : shape.p) CHECK(std::max(std::abs(p.x), std::abs(p.y)) < 3000.0);
      CHECK(shape.radius < 1000.0);
    }
  }
}
