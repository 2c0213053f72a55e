// SPDX-License-Identifier: GPL-3.0-or-later
#include <catch2/catch.hpp>
#include <set>

#include "layers_of_a_test.h"

using namespace mes;
using namespace mes::figure;
using test::Layers;
using test::shapes_of;

namespace {

std::vector<double> star(int rays) {
  std::vector<double> out;
  for (int i = 0; i < rays; ++i) {
    const double angle = 0.1 + i;
    out.insert(out.end(), {100.0, 50.0, 100.0 + 40.0 * std::cos(angle), 50.0 + 40.0 * std::sin(angle), 0.0});
  }
  return out;
}

}  // namespace

TEST_CASE("each primitive on the page is one shape, at its place with y downwards") {
  Layers layers;
  layers.add(0, PrimitiveKind::point, {10, 20, 0, 30, 40, 0});
  layers.add(0, PrimitiveKind::disk, {50, 50, 7, 0});
  layers.add(0, PrimitiveKind::circle, {50, 50, 9, 0});
  layers.add(0, PrimitiveKind::segment, {1, 2, 3, 4, 0});
  layers.add(0, PrimitiveKind::triangle, {0, 0, 10, 0, 0, 10, 0});
  layers.add(0, PrimitiveKind::arc, {100, 50, 10, 110, 50, 100, 60, 0});
  layers.add(0, PrimitiveKind::parabola, {20, 60, 30, 80, 40, 60, 0});
  layers.show(0).point_size_px = 8.0;
  const Figure figure = layers.figure();
  REQUIRE(figure.layers.size() == 1);
  const std::vector<Shape> shapes = shapes_of(figure.layers[0]);
  REQUIRE(shapes.size() == 8);
  CHECK(shape_count(figure) == 8);
  // Triangles, disks, segments, parabolas, circles, arcs, points: as the screen stacks them.
  CHECK(shapes[0].kind == ShapeKind::triangle);
  CHECK(shapes[1].kind == ShapeKind::disk);
  CHECK(shapes[1].p[0] == Vec2{50, 50});
  CHECK(shapes[1].radius == 7.0);
  CHECK(shapes[2].kind == ShapeKind::segment);
  CHECK(shapes[2].p[0] == Vec2{1, 98});
  CHECK(shapes[2].p[1] == Vec2{3, 96});
  CHECK(shapes[3].kind == ShapeKind::parabola);
  CHECK(shapes[3].p[0] == Vec2{20, 40});
  CHECK(shapes[3].p[1] == Vec2{40, 40});
  CHECK(shapes[3].p[2] == Vec2{30, 20});
  CHECK(shapes[4].kind == ShapeKind::circle);
  CHECK(shapes[5].kind == ShapeKind::arc);
  CHECK(shapes[5].p[0] == Vec2{110, 50});
  CHECK(shapes[5].p[1] == Vec2{100, 40});
  CHECK(shapes[5].sweep == Approx(1.5707963267948966));
  CHECK(shapes[6].kind == ShapeKind::disk);
  CHECK(shapes[6].radius == Approx(0.5 * 8.0 * 0.75));
  CHECK(shapes[7].p[0] == Vec2{30, 60});
}

TEST_CASE("widths are in points, a pixel being 0.75 of one, and follow the scale") {
  Layers layers;
  layers.add(0, PrimitiveKind::segment, {1, 2, 3, 4, 0});
  layers.show(0).line_width_px = 2.0;
  CHECK(layers.figure().layers[0].line_width == 1.5);
  layers.scale = 3.0;
  CHECK(layers.figure().layers[0].line_width == 4.5);
}

TEST_CASE("a translucent layer paints each shape on its own, a flat one all as a group") {
  Layers layers;
  layers.add(0, PrimitiveKind::disk, {50, 50, 7, 0, 55, 50, 7, 0});
  layers.add(0, PrimitiveKind::segment, {1, 2, 3, 4, 0});
  LayerStyle& style = layers.show(0);
  style.opacity = 0.5;
  Figure figure = layers.figure();
  REQUIRE(figure.layers[0].groups.size() == 1);
  CHECK(figure.layers[0].groups[0].opacity == 1.0);
  for (const Run& run : figure.layers[0].groups[0].runs) CHECK(run.opacity == 0.5);
  style.flat = true;
  figure = layers.figure();
  REQUIRE(figure.layers[0].groups.size() == 1);
  CHECK(figure.layers[0].groups[0].opacity == 0.5);
  for (const Run& run : figure.layers[0].groups[0].runs) CHECK(run.opacity == 1.0);
  style.opacity = 0.0;
  CHECK(shape_count(layers.figure()) == 0);
}

TEST_CASE("triangles are a group in any case, all turned the same way") {
  Layers layers;
  layers.add(0, PrimitiveKind::triangle, {0, 0, 10, 0, 0, 10, 0, 0, 10, 10, 0, 10, 10, 0, 5, 5, 5, 9, 9, 9, 0});
  layers.show(0).opacity = 0.5;
  const Figure figure = layers.figure();
  REQUIRE(figure.layers[0].groups.size() == 1);
  CHECK(figure.layers[0].groups[0].opacity == 0.5);
  const std::vector<Shape> shapes = shapes_of(figure.layers[0]);
  REQUIRE(shapes.size() == 3);
  for (const Shape& shape : shapes) CHECK(cross(shape.p[1] - shape.p[0], shape.p[2] - shape.p[0]) > 0.0);
}

TEST_CASE("segments of one look are chained, each still there once, and a curve is one loop") {
  Layers layers;
  // The sides of a polygon, in an order and directions of no sense.
  constexpr int kSides = 12;
  std::vector<double> sides;
  for (int i = 0; i < kSides; ++i) {
    const int side = 5 * i % kSides;
    const auto corner = [](int k) {
      return Vec2{100.0 + 40.0 * std::cos(k % kSides), 50.0 + 40.0 * std::sin(k % kSides)};
    };
    const Vec2 a = corner(i % 2 == 0 ? side : side + 1);
    const Vec2 b = corner(i % 2 == 0 ? side + 1 : side);
    sides.insert(sides.end(), {a.x, a.y, b.x, b.y, 0.0});
  }
  layers.add(0, PrimitiveKind::segment, sides);
  layers.show(0);
  const std::vector<Shape> shapes = shapes_of(layers.figure().layers[0]);
  REQUIRE(shapes.size() == kSides);
  std::set<std::pair<double, double>> corners;
  for (std::size_t i = 0; i < shapes.size(); ++i) {
    corners.emplace(shapes[i].p[0].x, shapes[i].p[0].y);
    CHECK(shapes[i].p[1] == shapes[(i + 1) % shapes.size()].p[0]);
  }
  CHECK(corners.size() == kSides);
}

TEST_CASE("chaining keeps every segment where many meet") {
  Layers layers;
  layers.add(0, PrimitiveKind::segment, star(9));
  layers.show(0);
  std::multiset<std::pair<double, double>> tips;
  const Vec2 middle{100, 50};
  const std::vector<Shape> shapes = shapes_of(layers.figure().layers[0]);
  REQUIRE(shapes.size() == 9);
  for (const Shape& shape : shapes) {
    CHECK((shape.p[0] == middle) != (shape.p[1] == middle));
    const Vec2 tip = shape.p[0] == middle ? shape.p[1] : shape.p[0];
    tips.emplace(tip.x, tip.y);
  }
  for (const auto& tip : tips) CHECK(tips.count(tip) == 1);
}

TEST_CASE("translucent and dashed segments keep their order and direction") {
  for (const bool dashed : {false, true}) {
    Layers layers;
    const std::vector<double> instances = star(9);
    layers.add(0, PrimitiveKind::segment, instances);
    LayerStyle& style = layers.show(0);
    style.dashed = dashed;
    style.opacity = dashed ? 1.0 : 0.5;
    const std::vector<Shape> shapes = shapes_of(layers.figure().layers[0]);
    REQUIRE(shapes.size() == 9);
    for (std::size_t i = 0; i < shapes.size(); ++i) {
      CHECK(shapes[i].p[0] == Vec2{100, 50});
      CHECK(shapes[i].p[1].x == Approx(instances[5 * i + 2]).margin(0.006));
    }
  }
}

TEST_CASE("shapes have the colours of their scalars, and the plain one where the layer has none") {
  Layers layers;
  for (const LayerIndex layer : {0U, 1U}) {
    layers.add(layer, PrimitiveKind::disk, {50, 50, 7, 1, 55, 50, 7, 3, 60, 50, 7, 2});
    LayerStyle& style = layers.show(layer);
    style.color = {1, 2, 3};
    style.color_map = "grey";
  }
  const Figure figure = layers.figure();
  const std::vector<Run>& plain = figure.layers[0].groups[0].runs;
  REQUIRE(plain.size() == 1);
  CHECK(plain[0].color == Rgb{1, 2, 3});
  const std::vector<Run>& mapped = figure.layers[1].groups[0].runs;
  REQUIRE(mapped.size() == 3);
  const render::ColorMap grey = render::grey_map();
  CHECK(mapped[0].color == grey.at(0.0));
  CHECK(mapped[1].color == grey.at(1.0));
  CHECK(mapped[2].color == grey.at(0.5));
}

TEST_CASE("a locked range colours as the screen does") {
  Layers layers;
  layers.add(1, PrimitiveKind::disk, {50, 50, 7, 1});
  LayerStyle& style = layers.show(1);
  style.color_map = "grey";
  style.range_locked = true;
  style.range_low = 0.0;
  style.range_high = 4.0;
  CHECK(layers.figure().layers[0].groups[0].runs[0].color == render::grey_map().at(0.25));
}

TEST_CASE("dashes begin in the middle of one, and close around a circle") {
  Layers layers;
  layers.add(0, PrimitiveKind::segment, {10, 20, 90, 20, 0});
  layers.add(0, PrimitiveKind::circle, {100, 50, 30, 0});
  LayerStyle& style = layers.show(0);
  style.dashed = true;
  const std::vector<Run> runs = layers.figure().layers[0].groups[0].runs;
  REQUIRE(runs.size() == 2);
  CHECK(runs[0].dashes == Dashes{3.75, 3.0, 1.875});
  const double period = runs[1].dashes.on + runs[1].dashes.off;
  const double around = 2.0 * 3.14159265358979 * 30.0;
  CHECK(std::abs(around / period - std::round(around / period)) < 1e-9);
  CHECK(runs[1].dashes.offset == Approx(0.5 * runs[1].dashes.on));
}

TEST_CASE("the box of the ink holds every stroke and nothing else, and is a page of its own") {
  Layers layers;
  layers.add(0, PrimitiveKind::segment, {20, 30, 60, 30, 0});
  layers.add(0, PrimitiveKind::circle, {80, 50, 10, 0});
  layers.show(0).line_width_px = 4.0;
  const Box2 ink = ink_box(layers.figure());
  CHECK(ink.low.x == Approx(20 - 1.5));
  CHECK(ink.high.x == Approx(90 + 1.5));
  CHECK(ink.low.y == Approx(40 - 1.5));
  CHECK(ink.high.y == Approx(70 + 1.5));
  const Page whole = test::page_of_points(200, 100);
  const Page part = part_of(whole, ink);
  CHECK(part.width == Approx(73));
  CHECK(part.height == Approx(33));
  // What was at the upper left corner of the box is at that of the page: (18.5, 100 - 38.5) in the plane.
  const Vec2 center = part.center + part.center_low;
  CHECK(center.x - 0.5 * part.width == Approx(18.5));
  CHECK(center.y + 0.5 * part.height == Approx(61.5));
}

TEST_CASE("texts count to what a figure covers, but not to its shapes") {
  Figure figure{.width = 200.0, .height = 100.0};
  FigureLayer& layer = figure.layers.emplace_back();
  layer.texts.push_back({.start = {50.0, 40.0}, .size = 10.0, .width = 30.0, .text = "text"});
  CHECK(shape_count(figure) == 0);
  CHECK(ink_box(layer) == Box2{{50.0, 32.0}, {80.0, 42.5}});
  CHECK(ink_below_texts(layer).is_empty());
  layer.texts.push_back({.start = {180.0, 40.0}, .size = 10.0, .width = 30.0, .text = "text"});
  CHECK(ink_box(layer).high == Vec2{210.0, 42.5});
  CHECK(ink_box(figure).high == Vec2{200.0, 42.5});
}
