// SPDX-License-Identifier: GPL-3.0-or-later
// Antialiasing against exact areas, blending against arithmetic.
#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>

#include "core/base/geometry/parabola_arc.h"
#include "core/base/rng.h"
#include "tests/render/drawing.h"
#include "tests/render/images.h"

using namespace mes;
using namespace mes::test;
using render::Image;
using render::LayerView;

namespace {

using enum PrimitiveKind;

constexpr double kPi = std::numbers::pi;

LayerStyle tinted(Rgb color, double opacity) {
  LayerStyle out;
  out.color = color;
  out.opacity = opacity;
  return out;
}

/// What painting `color` with `opacity` over `below` gives, in 0 .. 255.
double over(double color, double opacity, double below) {
  return color * opacity + below * (1.0 - opacity);
}

}  // namespace

TEST_CASE("a disk covers pi r^2") {
  Drawing drawing;
  Rng random(1);
  for (const double r : {0.7, 1.0, 1.5, 2.0, 3.0, 5.3, 12.0, 40.0}) {
    double as_disk = 0.0;
    double as_point = 0.0;
    constexpr int kPlaces = 24;
    for (int i = 0; i < kPlaces; ++i) {
      const Vec2 c{50.0 + random.uniform(), 50.0 + random.uniform()};
      drawing.set(0, disk, {c.x, c.y, r});
      drawing.set(1, point, {c.x, c.y});
      const double disk_area = covered_area(drawing.draw(pixel_camera(100, 100), {{0, black()}}));
      CAPTURE(r, c.x, c.y);
      if (r >= 3.0) CHECK(disk_area == Approx(kPi * r * r).epsilon(0.01));
      as_disk += disk_area / kPlaces;
      as_point += covered_area(drawing.draw(pixel_camera(100, 100), {{1, black(1.0, 2.0 * r)}})) / kPlaces;
    }
    // Small ones are right on average over where they lie in the pixel grid.
    CHECK(as_disk == Approx(kPi * r * r).epsilon(r < 1.2 ? 0.05 : 0.01));
    CHECK(as_point == Approx(kPi * r * r).epsilon(r < 1.2 ? 0.05 : 0.01));
  }
}

TEST_CASE("strokes cover length times width and their caps, at any angle") {
  Drawing drawing;
  for (const double width : {0.3, 1.0, 2.0, 5.0, 9.0}) {
    for (int i = 0; i < 12; ++i) {
      const double angle = 0.13 + kPi / 6.0 * i;
      const Vec2 d{30.0 * std::cos(angle), 30.0 * std::sin(angle)};
      drawing.set(0, segment, {50.3 - d.x, 50.4 - d.y, 50.3 + d.x, 50.4 + d.y});
      const double area = covered_area(drawing.draw(pixel_camera(100, 100), {{0, black(width)}}));
      const double caps = width >= 1.0 ? 0.25 * kPi * width * width : 0.25 * kPi * width;
      CAPTURE(width, angle);
      CHECK(area == Approx(60.0 * width + caps).epsilon(0.015));
    }
  }
}

TEST_CASE("circles cover length times width, whatever strip they are made of") {
  Drawing drawing;
  for (const double r : {2.0, 5.0, 7.0, 30.0, 60.0, 140.0}) {
    for (const double width : {1.0, 3.0}) {
      drawing.set(0, circle, {150.3, 150.4, r});
      const double area = covered_area(drawing.draw(pixel_camera(300, 300), {{0, black(width)}}));
      CAPTURE(r, width);
      CHECK(area == Approx(2.0 * kPi * r * width).epsilon(0.01));
    }
  }
}

TEST_CASE("arcs cover length times width and their caps, wherever they begin and however far they go") {
  Drawing drawing;
  const Vec2 c{150.3, 150.4};
  for (const double r : {5.0, 12.0, 30.0, 60.0, 140.0}) {
    for (const double sweep : {0.02, 0.7, 3.1, kPi, 3.2, 5.0, 6.0}) {
      for (int i = 0; i < 7; ++i) {
        const double from = 0.1 + i;
        const double to = from + sweep;
        drawing.set(0, arc,
                    {c.x, c.y, r, c.x + r * std::cos(from), c.y + r * std::sin(from), c.x + r * std::cos(to),
                     c.y + r * std::sin(to)});
        constexpr double kWidthPx = 2.0;
        // A ramp one pixel wide around a disk of radius 1 covers so much more than the disk.
        constexpr double kCaps = kPi * (1.0 + 1.0 / 12.0);
        const double area = covered_area(drawing.draw(pixel_camera(300, 300), {{0, black(kWidthPx)}}));
        CAPTURE(r, sweep, from);
        // Caps that reach into each other cover less.
        const double gap = (2.0 * kPi - sweep) * r;
        if (gap > kWidthPx) CHECK(area == Approx(r * sweep * kWidthPx + kCaps).epsilon(0.01).margin(0.25));
      }
    }
  }
}

TEST_CASE("an arc and what it leaves of its circle are the circle") {
  Drawing drawing;
  const Vec2 c{50.2, 50.7};
  constexpr double kRadius = 40.0;
  drawing.set(0, circle, {c.x, c.y, kRadius});
  const Image whole = drawing.draw(pixel_camera(100, 100), {{0, black(3.0)}});
  Rng random(5);
  for (int i = 0; i < 30; ++i) {
    const double t0 = random.uniform(0.0, 2.0 * kPi);
    // Ends close together, too.
    const double t1 = t0 + random.uniform(0.0, 2.0 * kPi) * std::pow(10.0, -0.4 * i);
    const Vec2 p = c + kRadius * Vec2{std::cos(t0), std::sin(t0)};
    const Vec2 q = c + kRadius * Vec2{std::cos(t1), std::sin(t1)};
    drawing.set(1, arc, {c.x, c.y, kRadius, p.x, p.y, q.x, q.y});
    drawing.set(2, arc, {c.x, c.y, kRadius, q.x, q.y, p.x, p.y});
    const Image first = drawing.draw(pixel_camera(100, 100), {{1, black(3.0)}});
    const Image second = drawing.draw(pixel_camera(100, 100), {{2, black(3.0)}});
    double worst = 0.0;
    for (int y = 0; y < 100; ++y) {
      for (int x = 0; x < 100; ++x)
        worst = std::max(worst, std::abs(std::max(cover(first, x, y), cover(second, x, y)) - cover(whole, x, y)));
    }
    CAPTURE(t0, t1);
    CHECK(worst < 0.02);
  }
  drawing.set(3, arc, {c.x, c.y, kRadius, c.x, c.y + kRadius, c.x, c.y + kRadius});
  CHECK(drawing.draw(pixel_camera(100, 100), {{3, black(3.0)}}).rgba == whole.rgba);
}

TEST_CASE("parabolas cover length times width and their caps, bent little or much, and in parts as a whole") {
  Drawing drawing;
  Rng random(7);
  for (const double width : {2.0, 5.0}) {
    for (const double height : {0.0, 0.5, 5.0, 40.0, 120.0}) {
      for (int i = 0; i < 5; ++i) {
        const double angle = 0.3 + i;
        const Vec2 along{std::cos(angle), std::sin(angle)};
        const Vec2 middle{150.3, 150.4};
        const ParabolaArc whole{middle - 60.0 * along, middle + height * perpendicular(along), middle + 60.0 * along};
        const auto area = [&](const ParabolaArc& arc) {
          drawing.set(0, parabola, {arc.from.x, arc.from.y, arc.control.x, arc.control.y, arc.to.x, arc.to.y});
          return covered_area(drawing.draw(pixel_camera(300, 300), {{0, black(width)}}));
        };
        const double caps = 0.25 * kPi * (width * width + 1.0 / 3.0);
        CAPTURE(width, height, angle);
        CHECK(area(whole) == Approx(length_of(whole) * width + caps).epsilon(0.015));
        const double t = random.uniform(0.2, 0.8);
        CHECK(area(part_of(whole, 0.0, t)) ==
              Approx(length_of(part_of(whole, 0.0, t)) * width + caps).epsilon(0.015));
      }
    }
  }
}

TEST_CASE("triangles cover their area, needles too") {
  Drawing drawing;
  const std::vector<std::vector<double>> triangles{{10.2, 10.3, 80.7, 15.1, 40.4, 90.9},
                                                   {10.2, 10.3, 40.4, 90.9, 80.7, 15.1},
                                                   {10.0, 20.0, 90.0, 30.0, 90.0, 31.5},
                                                   {10.0, 20.0, 90.0, 30.0, 50.0, 25.4},
                                                   {10.0, 20.0, 10.0, 60.0, 50.0, 20.0}};
  for (const auto& t : triangles) {
    drawing.set(0, triangle, t);
    const double exact = 0.5 * std::abs(cross({t[2] - t[0], t[3] - t[1]}, {t[4] - t[0], t[5] - t[1]}));
    CAPTURE(t[0], t[4]);
    CHECK(covered_area(drawing.draw(pixel_camera(100, 100), {{0, black()}})) ==
          Approx(exact).epsilon(0.02).margin(1.0));
  }
}

TEST_CASE("layers are painted bottom first, with premultiplied colours") {
  Drawing drawing;
  drawing.set(0, disk, {20, 20, 15});
  drawing.set(1, disk, {20, 20, 15});
  const auto at_center = [&](const std::vector<LayerView>& views, const render::ImageOptions& options) {
    const Image image = drawing.draw(pixel_camera(40, 40), views, options);
    const std::size_t i = image.offset(20, 20);
    return std::array<int, 4>{image.rgba[i], image.rgba[i + 1], image.rgba[i + 2], image.rgba[i + 3]};
  };
  const LayerView red{0, tinted({255, 0, 0}, 0.5)};
  const LayerView blue{1, tinted({0, 0, 255}, 0.25)};
  const auto blue_on_top = at_center({red, blue}, {.background = kWhite});
  CHECK(blue_on_top[0] == Approx(over(0, 0.25, over(255, 0.5, 255))).margin(1.5));
  CHECK(blue_on_top[1] == Approx(over(0, 0.25, over(0, 0.5, 255))).margin(1.5));
  CHECK(blue_on_top[2] == Approx(over(255, 0.25, over(0, 0.5, 255))).margin(1.5));
  const auto red_on_top = at_center({blue, red}, {.background = kWhite});
  CHECK(red_on_top[0] == Approx(over(255, 0.5, over(0, 0.25, 255))).margin(1.5));
  CHECK(red_on_top[2] == Approx(over(0, 0.5, over(255, 0.25, 255))).margin(1.5));
  // On nothing: alpha of both, colour not darkened by it.
  const auto on_nothing = at_center({red}, {});
  CHECK(on_nothing[0] == 255);
  CHECK(on_nothing[3] == Approx(127.5).margin(1.0));
}

TEST_CASE("a flat layer is as dark where its disks overlap as where they do not") {
  Drawing drawing;
  drawing.set(0, disk, {20, 20, 15, 30, 20, 15});
  drawing.set(0, segment, {5, 20, 45, 20});
  LayerStyle style = tinted({0, 0, 0}, 0.5);
  const auto view = [&](bool flat) {
    style.flat = flat;
    return drawing.draw(pixel_camera(50, 40), {{0, style}});
  };
  const Image flat = view(true);
  CHECK(cover(flat, 25, 25) == Approx(0.5).margin(0.01));
  CHECK(cover(flat, 12, 25) == Approx(0.5).margin(0.01));
  CHECK(cover(flat, 25, 20) == Approx(0.5).margin(0.01));
  const Image blended = view(false);
  CHECK(cover(blended, 25, 25) == Approx(0.75).margin(0.01));
  CHECK(cover(blended, 12, 25) == Approx(0.5).margin(0.01));
}

TEST_CASE("dashes have the length asked for, from the first end on, whichever way the stroke runs") {
  Drawing drawing;
  LayerStyle style = black(2.0);
  style.dashed = true;
  drawing.set(0, segment, {10.0, 20.0, 210.0, 20.0});
  const Image image = drawing.draw(pixel_camera(220, 40), {{0, style}});
  // Half a dash of 5, then gaps of 4.
  for (int x = 10; x < 210; ++x) {
    const double s = x + 0.5 - 10.0;
    const double from_middle = std::abs(s - 9.0 * std::round(s / 9.0));
    CAPTURE(x);
    if (from_middle < 1.9) CHECK(cover(image, x, 19) == Approx(1.0).margin(0.02));
    if (from_middle > 3.1) CHECK(cover(image, x, 19) == Approx(0.0).margin(0.02));
  }
  // The pattern stays with the stroke: seen from elsewhere it is the same, also when the other end is the nearer one.
  render::Camera camera = pixel_camera(220, 40);
  camera.pan({-150.0, 0.0});
  const Image moved = drawing.draw(camera, {{0, style}});
  for (int x = 0; x < 60; ++x) CHECK(cover(moved, x, 19) == Approx(cover(image, x + 150, 19)).margin(0.02));
}

TEST_CASE("a dashed circle closes without a broken dash") {
  Drawing drawing;
  LayerStyle style = black(2.0);
  style.dashed = true;
  for (const double r : {10.0, 30.3, 61.7}) {
    drawing.set(0, circle, {80, 80, r});
    const Image image = drawing.draw(pixel_camera(160, 160), {{0, style}});
    const double dashes = std::round(2.0 * kPi * r / 9.0);
    int changes = 0;
    bool was_on = true;
    for (int i = 1; i <= 3600; ++i) {
      const double angle = 2.0 * kPi * i / 3600.0;
      const double c =
          cover(image, static_cast<int>(80.0 + r * std::cos(angle)), static_cast<int>(80.0 - r * std::sin(angle)));
      const bool is_on = was_on ? c > 0.2 : c > 0.5;
      if (is_on != was_on) ++changes;
      was_on = is_on;
    }
    CHECK(changes == 2 * static_cast<int>(dashes));
    CHECK(covered_area(image) == Approx(2.0 * kPi * r * 2.0 * 5.0 / 9.0).epsilon(0.03));
  }
}
