// SPDX-License-Identifier: GPL-3.0-or-later
// Voronoi vertices at 10^30, points of no extent, views of any depth: nothing that is finite makes garbage.
#include <catch2/catch.hpp>
#include <cmath>
#include <cstdlib>
#include <vector>

#include "core/base/rng.h"
#include "tests/render/drawing.h"
#include "tests/render/images.h"

using namespace mes;
using namespace mes::test;
using render::Camera;
using render::Image;

namespace {

using enum PrimitiveKind;

Camera unit_camera(double units_across = 2.0) {
  Camera camera;
  camera.set_viewport(200, 200);
  camera.look_at({0.0, 0.0}, units_across / 200.0);
  return camera;
}

/// Largest error of a drawing against the stroke through `p` along `d`, from p on when `from_p`.
double worst_against_line(const Image& image, Vec2 p, Vec2 d, double width_px, bool from_p) {
  const Vec2 u = (1.0 / length(d)) * d;
  double worst = 0.0;
  for (int y = 0; y < image.height; ++y) {
    for (int x = 0; x < image.width; ++x) {
      const Vec2 at{(x + 0.5 - 100.0) / 100.0, (99.5 - y) / 100.0};
      const double along = dot(at - p, u) * 100.0;
      const double across = std::abs(cross(at - p, u)) * 100.0;
      const double sd = (from_p && along < 0.0 ? std::hypot(along, across) : across) - 0.5 * width_px;
      worst = std::max(worst, std::abs(std::clamp(0.5 - sd, 0.0, 1.0) - cover(image, x, y)));
    }
  }
  return worst;
}

}  // namespace

TEST_CASE("segments to far vertices keep their direction") {
  Drawing drawing;
  const Vec2 p{0.31, -0.2};
  for (const double distance : {10.0, 1e4, 1e9, 1e15, 1e19, 1e30, 1e200, 1e307}) {
    for (const double angle : {0.0, 0.4, 1.5707963267948966, 2.2, 3.9, 5.5}) {
      const Vec2 d{std::cos(angle), std::sin(angle)};
      CAPTURE(distance, angle);
      drawing.set(0, segment, {p.x, p.y, distance * d.x, distance * d.y});
      const Vec2 along = Vec2{d.x - p.x / distance, d.y - p.y / distance};
      CHECK(worst_against_line(drawing.draw(unit_camera(), {{0, black(3.0)}}), p, along, 3.0, true) < 0.03);
      // The other way round it is the same stroke.
      drawing.set(0, segment, {distance * d.x, distance * d.y, p.x, p.y});
      CHECK(worst_against_line(drawing.draw(unit_camera(), {{0, black(3.0)}}), p, along, 3.0, true) < 0.03);
    }
  }
}

TEST_CASE("a segment between two far vertices crosses the view where it should") {
  Drawing drawing;
  for (const double distance : {1e3, 1e6, 1e9}) {
    for (const double angle : {0.2, 1.1, 2.9}) {
      const Vec2 d{std::cos(angle), std::sin(angle)};
      const Vec2 a = Vec2{0.1, 0.2} - distance * d;
      const Vec2 b = Vec2{0.1, 0.2} + 3.0 * distance * d;
      drawing.set(0, segment, {a.x, a.y, b.x, b.y});
      CAPTURE(distance, angle);
      // What doubles say at that distance: coordinates of 10^9 are exact to 10^-7, a thousandth of a pixel here.
      CHECK(worst_against_line(drawing.draw(unit_camera(), {{0, black(3.0)}}), {0.1, 0.2}, d, 3.0, false) < 0.03);
    }
  }
}

TEST_CASE("rays and lines are clipped to the view at any angle and from any anchor") {
  Drawing drawing;
  for (int i = 0; i < 24; ++i) {
    const double angle = 0.01 + 0.2617993877991494 * i;
    const Vec2 d{std::cos(angle), std::sin(angle)};
    for (const double back : {0.0, 5.0, 1e4, 1e8}) {
      const Vec2 p = Vec2{-0.2, 0.15} - back * d;
      CAPTURE(angle, back);
      drawing.set(0, ray, {p.x, p.y, 1e-200 * d.x, 1e-200 * d.y});
      CHECK(worst_against_line(drawing.draw(unit_camera(), {{0, black(2.0)}}), back == 0.0 ? p : Vec2{-0.2, 0.15}, d,
                               2.0, back == 0.0) < 0.03);
      drawing.set(1, line, {p.x, p.y, 1e250 * d.x, 1e250 * d.y});
      CHECK(worst_against_line(drawing.draw(unit_camera(), {{1, black(2.0)}}), {-0.2, 0.15}, d, 2.0, false) < 0.03);
    }
    // Pointing away from the view there is nothing to see.
    drawing.set(0, ray, {5.0 * d.x, 5.0 * d.y, d.x, d.y});
    CHECK(covered_area(drawing.draw(unit_camera(), {{0, black(2.0)}})) == 0.0);
  }
}

TEST_CASE("primitives without extent are dots or nothing") {
  Drawing drawing;
  drawing.set(0, segment, {0.1, 0.1, 0.1, 0.1});
  CHECK(covered_area(drawing.draw(unit_camera(), {{0, black(6.0)}})) == Approx(3.14159265 * 9.0).epsilon(0.03));
  drawing.set(1, disk, {0.1, 0.1, 0.0});
  CHECK(covered_area(drawing.draw(unit_camera(), {{1, black()}})) < 0.1);
  drawing.set(2, circle, {0.1, 0.1, 0.0});
  CHECK(covered_area(drawing.draw(unit_camera(), {{2, black(6.0)}})) == Approx(3.14159265 * 9.0).epsilon(0.03));
  drawing.set(5, arc, {0.1, 0.1, 0.0, 0.1, 0.1, 0.1, 0.1});
  CHECK(covered_area(drawing.draw(unit_camera(), {{5, black(6.0)}})) == Approx(3.14159265 * 9.0).epsilon(0.03));
  drawing.set(3, triangle, {0.1, 0.1, 0.5, 0.5, 0.9, 0.9});
  CHECK(covered_area(drawing.draw(unit_camera(), {{3, black()}})) == 0.0);
  drawing.set(4, triangle, {0.1, 0.1, 0.1, 0.1, 0.1, 0.1});
  CHECK(covered_area(drawing.draw(unit_camera(), {{4, black()}})) == 0.0);
}

TEST_CASE("huge disks fill what lies inside, and nothing else") {
  Drawing drawing;
  for (const double r : {10.0, 1e3, 1e6, 1e9, 1e12}) {
    CAPTURE(r);
    // The rim passes through the origin; the disk lies left of it.
    drawing.set(0, disk, {-r, 0.0, r});
    CHECK(covered_area(drawing.draw(unit_camera(), {{0, black()}})) ==
          Approx(20000.0).margin(200.0 * 200.0 / 3.0 / 100.0 * 200.0 / r / 2.0 + 20.0));
    drawing.set(1, disk, {-r, 0.0, r + 3.0});
    CHECK(covered_area(drawing.draw(unit_camera(), {{1, black()}})) == Approx(40000.0).margin(1.0));
    drawing.set(2, disk, {-r, 0.0, r - 3.0});
    CHECK(covered_area(drawing.draw(unit_camera(), {{2, black()}})) == 0.0);
    drawing.set(3, circle, {0.0, r, r - 0.5});
    CHECK(covered_area(drawing.draw(unit_camera(), {{3, black(2.0)}})) ==
          Approx(400.0).epsilon(r < 100.0 ? 0.1 : 0.02));
    // From the origin half way around and beyond, towards the left.
    drawing.set(4, arc, {0.0, -r, r, 0.0, 0.0, r, -r});
    CHECK(covered_area(drawing.draw(unit_camera(), {{4, black(2.0)}})) ==
          Approx(200.0 + 0.5 * 3.14159265).epsilon(r < 100.0 ? 0.1 : 0.02));
  }
}

TEST_CASE("a drawing that is a dot lies where it is, however far a view is zoomed out and panned") {
  Drawing drawing;
  std::vector<render::LayerView> views;
  const auto add = [&](PrimitiveKind kind, const std::vector<double>& data) {
    const auto layer = static_cast<LayerIndex>(views.size());
    drawing.set(layer, kind, data);
    views.push_back({layer, black(3.0)});
    views.back().style.point_size_px = 7.0;
  };
  add(point, {0.5, -0.25, 0.0, 0.0});
  add(ray, {0.1, 0.2, 1.0, 3.0});
  add(line, {0.1, 0.2, -2.0, 1.0});
  add(segment, {-1.0, 0.0, 1.0, 0.0});
  add(disk, {0.0, 0.0, 1.0});
  add(circle, {0.0, 0.0, 1.0});
  std::vector<Image> all;
  for (const double units : {1e9, 1e14, 1e16, 1e18, 1e21, 1e24, 1e40, 1e150, 1e280}) {
    Camera camera = unit_camera();
    camera.look_at({0.0, 0.0}, units);
    camera.pan({61.0, 33.0});
    CAPTURE(units);
    const Image whole = drawing.draw(camera, views);
    const Image dot = drawing.draw(camera, {views.front()});
    CHECK(covered_center(dot).x == Approx(161.0).margin(0.01));
    CHECK(covered_center(dot).y == Approx(133.0).margin(0.01));
    // In tiles, and as whatever larger view.
    const Image tiled = drawing.draw(camera, views, {.background = kWhite, .tile_px = 64});
    int worst = 0;
    for (std::size_t i = 0; i < whole.rgba.size(); ++i) {
      worst = std::max(worst, std::abs(whole.rgba[i] - tiled.rgba[i]));
      if (!all.empty()) worst = std::max(worst, std::abs(whole.rgba[i] - all.front().rgba[i]));
    }
    CHECK(worst <= 3);
    all.push_back(whole);
    // Out of view it is not seen.
    camera.pan({2000.0, 0.0});
    CHECK(covered_area(drawing.draw(camera, {views.front()})) == 0.0);
    camera.pan({1e8, -1e8});
    CHECK(covered_area(drawing.draw(camera, {views.front()})) == 0.0);
  }
}

TEST_CASE("dashes of huge circles and of strokes from far away are the same in each part of a view") {
  Drawing drawing;
  REQUIRE(drawing.device().uses_double());
  std::vector<render::LayerView> views{{0, black(3.0)}};
  views[0].style.dashed = true;
  Camera camera = unit_camera();
  for (const double radius : {1e2, 1e3, 1e5, 1e7, 1e8}) {  // a hundred times as many pixels
    for (const double angle : {0.1, 0.8, 1.5, 2.0, 2.8, 3.5, 4.4, 5.0, 6.1}) {
      const Vec2 d{std::cos(angle), std::sin(angle)};
      const Vec2 center{0.1 - radius * d.x, 0.2 - radius * d.y};
      for (const PrimitiveKind kind : {circle, arc, segment, ray}) {
        CAPTURE(radius, angle, kind);
        std::vector<double> data{center.x, center.y, radius};
        if (kind == arc)
          data = {center.x,
                  center.y,
                  radius,
                  center.x + radius * d.y,
                  center.y - radius * d.x,
                  center.x - radius * d.y,
                  center.y + radius * d.x};
        if (kind == segment) data = {center.x, center.y, 0.1 + radius * d.x, 0.2 + radius * d.y};
        if (kind == ray) data = {center.x, center.y, d.x, d.y};
        drawing.set(0, kind, data);
        const Image whole = drawing.draw(camera, views);
        CHECK(covered_area(whole) > 200.0);
        const Image tiled = drawing.draw(camera, views, {.background = kWhite, .tile_px = 50});
        int worst = 0;
        for (std::size_t i = 0; i < whole.rgba.size(); ++i)
          worst = std::max(worst, std::abs(whole.rgba[i] - tiled.rgba[i]));
        CHECK(worst <= 25);
        drawing.set(0, kind, {});
      }
    }
  }
  // Without doubles they are where they happen to be.
  Drawing plain({.allow_double = false});
  for (const PrimitiveKind kind : {circle, segment}) {
    plain.set(0, kind, kind == circle ? std::vector{0.0, -1e6, 1e6} : std::vector{-1e6, 0.0, 1e6, 0.0});
    const double covered = covered_area(plain.draw(camera, views));
    CHECK(covered > 200.0);
    CHECK(covered < 550.0);
    plain.set(0, kind, {});
  }
}

TEST_CASE("random numbers of every size and views of every depth draw finite pictures") {
  // With NaN on the way pixels turn black or keep what was there; here they must stay on the grey axis of black over
  // white, and a marker drawn last must come out whole.
  Drawing drawing;
  Rng random(7);
  const auto number = [&] {
    const double magnitude = std::pow(10.0, random.uniform(-300.0, 300.0));
    return random.uniform() < 0.1 ? 0.0 : (random.uniform() < 0.5 ? -magnitude : magnitude);
  };
  for (int round = 0; round < 20; ++round) {
    LayerIndex layer = 0;
    std::vector<render::LayerView> views;
    for (const PrimitiveKind kind : kAllPrimitiveKinds) {
      std::vector<double> data;
      for (int i = 0; i < 40; ++i) {
        for (std::size_t k = 0; k < doubles_per(kind); ++k) data.push_back(number());
        if (kind == disk || kind == circle) data.back() = std::abs(data.back());
        if (kind == arc) data.end()[-5] = std::abs(data.end()[-5]);
      }
      drawing.set(
          layer, kind, data,
          {.origin = {number(), 0.0}, .scale = std::ldexp(1.0, static_cast<int>(random.uniform(-900.0, 900.0)))});
      views.push_back({layer, black(3.0)});
      views.back().style.dashed = round % 2 == 0;
      views.back().style.opacity = 0.5;
      ++layer;
    }
    Camera camera = unit_camera();
    camera.look_at({number(), number()}, std::abs(number()) + 1e-300);
    const Image image = drawing.draw(camera, views);
    for (std::size_t i = 0; i < image.rgba.size(); i += 4) {
      REQUIRE(image.rgba[i] == image.rgba[i + 1]);
      REQUIRE(image.rgba[i + 3] == 255);
    }
    drawing.set(layer, point, {camera.center().x, camera.center().y}, {.origin = camera.center(), .scale = 1.0});
    LayerStyle marker;
    marker.color = {255, 0, 0};
    marker.point_size_px = 20.0;
    views.push_back({layer, marker});
    const Image marked = drawing.draw(camera, views);
    for (int y = 95; y < 105; ++y) {
      for (int x = 95; x < 105; ++x) {
        REQUIRE(marked.rgba[marked.offset(x, y)] == 255);
        REQUIRE(marked.rgba[marked.offset(x, y) + 1] == 0);
      }
    }
  }
}
