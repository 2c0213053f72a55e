// SPDX-License-Identifier: GPL-3.0-or-later
// Deep zoom: what double coordinates tell apart is seen apart, at the right pixels, and does not shake.
#include <catch2/catch.hpp>
#include <cmath>

#include "tests/render/drawing.h"
#include "tests/render/images.h"

using namespace mes;
using namespace mes::test;
using render::Camera;
using render::GlDeviceOptions;
using render::Image;
using render::LayerView;

namespace {

using enum PrimitiveKind;

constexpr int kWidth = 400;
constexpr int kHeight = 300;

/// With doubles, with pairs of floats, and with nothing but OpenGL 3.3.
const std::vector<GlDeviceOptions> kWays{
    {}, {.allow_double = false}, {.allow_double = false, .allow_precise = false}};

Camera camera_at(Vec2 center, double view_width) {
  Camera camera;
  camera.set_viewport(kWidth, kHeight);
  camera.look_at(center, view_width / kWidth);
  return camera;
}

/// Every pixel but a rim of `margin` equals that of the other picture moved by (dx, dy) pixels.
int largest_difference_moved(const Image& image, const Image& moved, int dx, int dy, int margin) {
  int largest = 0;
  for (int y = margin; y < image.height - margin; ++y) {
    for (int x = margin; x < image.width - margin; ++x) {
      const int a = image.rgba[image.offset(x, y)];
      const int b = moved.rgba[moved.offset(x + dx, y + dy)];
      largest = std::max(largest, std::abs(a - b));
    }
  }
  return largest;
}

}  // namespace

TEST_CASE("samples at relative distance 1e-13 are seen apart in a view of 1e-12") {
  // Not round in binary, and in different binades of x and y.
  const Vec2 sample{0.7310585786300049, -0.3141592653589793};
  const double step = 1e-13;
  const std::vector<Vec2> offsets{{0, 0}, {step, 0}, {0, step}, {-step, -step}, {2 * step, 3 * step}};
  Drawing drawing;
  std::vector<double> points;
  for (const Vec2 o : offsets) points.insert(points.end(), {sample.x + o.x, sample.y + o.y});
  for (int i = 0; i < 100; ++i) points.insert(points.end(), {std::cos(i), std::sin(i)});
  drawing.set(0, point, points);
  const std::vector<LayerView> views{{0, black(1.0, 9.0)}};
  const Camera camera = camera_at(sample, 1e-12);
  const Image image = drawing.draw(camera, views);

  double expected_area = 0.0;
  for (std::size_t i = 0; i < offsets.size(); ++i) {
    // Where the double that stands for the sample lies, computed without cancellation.
    const Vec2 at{points[2 * i] - sample.x, points[2 * i + 1] - sample.y};
    const Vec2 screen{0.5 * kWidth + at.x / 1e-12 * kWidth, 0.5 * kHeight - at.y / 1e-12 * kWidth};
    Image around{.width = 14, .height = 14, .rgba = std::vector<std::uint8_t>(14 * 14 * 4)};
    const int left = static_cast<int>(std::floor(screen.x)) - 7;
    const int top = static_cast<int>(std::floor(screen.y)) - 7;
    for (int y = 0; y < 14; ++y) {
      for (int x = 0; x < 14; ++x) {
        around.rgba[around.offset(x, y)] = image.rgba[image.offset(left + x, top + y)];
      }
    }
    const Vec2 seen = covered_center(around);
    CAPTURE(i, screen.x, screen.y);
    CHECK(seen.x + left == Approx(screen.x).margin(0.02));
    CHECK(seen.y + top == Approx(screen.y).margin(0.02));
    expected_area += 3.14159265 * 4.5 * 4.5;
  }
  CHECK(covered_area(image) == Approx(expected_area).epsilon(0.01));
}

TEST_CASE("panning by whole pixels shifts the picture, at every depth") {
  const GlDeviceOptions options = GENERATE(from_range(kWays));
  Drawing drawing(options);
  const Vec2 sample{0.7310585786300049, -0.3141592653589793};
  for (const double view_width : {4.0, 1e-3, 1e-6, 1e-9, 1e-12}) {
    CAPTURE(options.allow_double, options.allow_precise, view_width);
    const auto at = [&](double x, double y) { return Vec2{sample.x + x * view_width, sample.y + y * view_width}; };
    std::vector<double> points;
    std::vector<double> segments;
    std::vector<double> circles;
    std::vector<double> arcs;
    for (int i = -20; i < 20; ++i) {
      const Vec2 p = at(0.03 * i, 0.02 * i * (i % 3));
      const Vec2 q = at(0.05 * i, -0.3 + 0.01 * i);
      points.insert(points.end(), {p.x, p.y});
      segments.insert(segments.end(), {p.x, p.y, q.x, q.y});
      circles.insert(circles.end(), {q.x, q.y, std::abs(0.01 * i) * view_width});
      const double r = distance(p, q);
      arcs.insert(arcs.end(), {p.x, p.y, r, q.x, q.y, p.x + r * std::cos(i), p.y + r * std::sin(i)});
    }
    // One that begins in view and ends far outside it.
    segments.insert(segments.end(), {sample.x, sample.y, -1.0, 1.0});
    drawing.set(0, point, points);
    drawing.set(1, segment, segments);
    drawing.set(2, circle, circles);
    drawing.set(3, arc, arcs);
    const std::vector<LayerView> views{{0, black(1.0)}, {1, black(1.5)}, {2, black(1.0)}, {3, black(1.0)}};
    Camera camera = camera_at(sample, view_width);
    const Image before = drawing.draw(camera, views);
    CHECK(covered_area(before) > 1000.0);
    camera.pan({17.0, -9.0});
    const Image after = drawing.draw(camera, views);
    CHECK(largest_difference_moved(before, after, 17, -9, 20) <= 2);
    // And back again, many times: the centre does not drift.
    for (int i = 0; i < 100; ++i) {
      camera.pan({3.0, 5.0});
      camera.pan({-3.0, -5.0});
    }
    camera.pan({-17.0, 9.0});
    CHECK(largest_difference_moved(before, drawing.draw(camera, views), 0, 0, 0) <= 1);
  }
}

TEST_CASE("a line whose ends are far outside passes at the right pixels") {
  // With pairs of floats a view of 1e-9 is placed to a small part of a pixel, with doubles one of 1e-12.
  const GlDeviceOptions options = GENERATE(from_range(kWays));
  Drawing drawing(options);
  const double view_width = drawing.device().uses_double() ? 1e-12 : 1e-9;
  CAPTURE(options.allow_double, options.allow_precise);

  for (const double angle : {0.0, 0.3, 0.785398, 1.5707963, 2.5}) {
    CAPTURE(angle);
    // Coordinates with few bits, so that the ends are exactly where they are computed to be.
    const auto coarse = [](double v) { return std::round(v * 1024.0) / 1024.0; };
    const Vec2 d{coarse(std::cos(angle)), coarse(std::sin(angle))};
    const Vec2 middle{0.25, -0.375};
    const Vec2 a = middle - 0.5 * d;
    const Vec2 b = middle + 0.75 * d;
    // The view's centre lies a known way beside the line.
    const double pixel = view_width / kWidth;
    const Vec2 normal = (1.0 / length(d)) * perpendicular(d);
    Camera camera = camera_at(middle, view_width);
    camera.pan({40.0 * normal.x, -40.0 * normal.y});

    drawing.set(0, segment, {a.x, a.y, b.x, b.y});
    drawing.set(1, ray, {a.x, a.y, d.x, d.y});
    drawing.set(2, line, {b.x, b.y, d.x, d.y});
    for (LayerIndex layer = 0; layer < 3; ++layer) {
      CAPTURE(layer);
      const Image image = drawing.draw(camera, {{layer, black(4.0)}});
      double worst = 0.0;
      double area = 0.0;
      for (int y = 0; y < kHeight; ++y) {
        for (int x = 0; x < kWidth; ++x) {
          const Vec2 p{x + 0.5 - 0.5 * kWidth, 0.5 * kHeight - y - 0.5};
          const double distance_px = std::abs(dot(p, normal) - 40.0);
          const double expected = std::clamp(2.5 - distance_px, 0.0, 1.0);
          worst = std::max(worst, std::abs(expected - cover(image, x, y)));
          area += expected;
        }
      }
      CHECK(area > 500.0);
      CHECK(worst < 0.05 + 1.2e-16 / pixel);
    }
  }
}

TEST_CASE("the rim of a circle stays smooth and in place when magnified") {
  const GlDeviceOptions options = GENERATE(from_range(kWays));
  Drawing drawing(options);
  for (const double view_width : {1e-2, 1e-4, 1e-6, 1e-9}) {
    // 3-4-5: the rim passes exactly through the point looked at.
    const Vec2 rim{0.75 + 0.125, 1.0 - 0.25};
    const Vec2 center{0.125, -0.25};
    const double r = 1.25;
    const Vec2 normal{0.6, 0.8};
    drawing.set(0, circle, {center.x, center.y, r});
    drawing.set(1, disk, {center.x, center.y, r});
    Camera camera = camera_at(rim, view_width);
    camera.pan({30.0, 20.0});
    const double pixel = view_width / kWidth;
    const Image ring = drawing.draw(camera, {{0, black(3.0)}});
    const Image full = drawing.draw(camera, {{1, black(1.0)}});
    CAPTURE(options.allow_double, options.allow_precise, view_width);
    double worst_ring = 0.0;
    double worst_full = 0.0;
    for (int y = 0; y < kHeight; ++y) {
      for (int x = 0; x < kWidth; ++x) {
        const Vec2 p = pixel * Vec2{x + 0.5 - 0.5 * kWidth - 30.0, 0.5 * kHeight - y - 0.5 + 20.0};
        // Distance to the rim from |p + r n|^2 - r^2, in pixels.
        const double s = (dot(p, p) + 2.0 * r * dot(p, normal)) / (length(p + r * normal) + r) / pixel;
        worst_ring = std::max(worst_ring, std::abs(std::clamp(2.0 - std::abs(s), 0.0, 1.0) - cover(ring, x, y)));
        worst_full = std::max(worst_full, std::abs(std::clamp(0.5 - s, 0.0, 1.0) - cover(full, x, y)));
      }
    }
    CHECK(worst_ring < 0.05);
    CHECK(worst_full < 0.05);
  }
}

TEST_CASE("an arc ends where it should when magnified, whichever way it runs and however long it is") {
  const GlDeviceOptions options = GENERATE(from_range(kWays));
  Drawing drawing(options);
  // 3-4-5: both ends lie exactly on the circle.
  const Vec2 center{0.125, -0.25};
  const double r = 1.25;
  const Vec2 end{0.75 + 0.125, 1.0 - 0.25};
  const Vec2 normal{0.6, 0.8};
  const Vec2 along{-0.8, 0.6};
  const double deepest = drawing.device().uses_double() ? 1e-12 : 1e-9;
  for (const double view_width : {1e-2, 1e-4, 1e-6, 1e-9, deepest}) {
    const double pixel = view_width / kWidth;
    // The far end: a quarter, a half and three quarters of a turn away, on the axes of the first end, and both ends
    // in view with most of the circle, or next to nothing of it, between them.
    for (const Vec2 other : {center + r * along, center - r * normal, center - r * along, end + 60.0 * pixel * along,
                             end - 60.0 * pixel * along}) {
      const double other_px = dot(other - end, along) / pixel;
      const bool is_near = distance(end, other) < view_width;
      for (const bool begins : {true, false}) {
        const Vec2 from = begins ? end : other;
        const Vec2 to = begins ? other : end;
        drawing.set(0, arc, {center.x, center.y, r, from.x, from.y, to.x, to.y});
        Camera camera = camera_at(end, view_width);
        camera.pan({30.0, 20.0});
        const Image image = drawing.draw(camera, {{0, black(6.0)}});
        CAPTURE(options.allow_double, options.allow_precise, view_width, other.x, other.y, begins);
        double worst = 0.0;
        for (int y = 0; y < kHeight; ++y) {
          for (int x = 0; x < kWidth; ++x) {
            const Vec2 px{x + 0.5 - 0.5 * kWidth - 30.0, 0.5 * kHeight - y - 0.5 + 20.0};
            const Vec2 p = pixel * px;
            const double rim = (dot(p, p) + 2.0 * r * dot(p, normal)) / (length(p + r * normal) + r) / pixel;
            const double s = dot(px, along);
            // Beside the end, on the side where the arc goes, until it ends again.
            const bool past_end = begins ? s >= 0.0 : s <= 0.0;
            const bool before_other = begins ? s <= other_px : s >= other_px;
            const bool is_long = (other_px < 0.0) == begins;
            const bool inside = !is_near ? past_end : (is_long ? past_end || before_other : past_end && before_other);
            double sd = std::abs(rim);
            if (!inside) sd = std::min(length(px), is_near ? length(px - (1.0 / pixel) * (other - end)) : 1e9);
            worst = std::max(worst, std::abs(std::clamp(3.5 - sd, 0.0, 1.0) - cover(image, x, y)));
          }
        }
        // The last bit of a coordinate moves an end by so much.
        CHECK(worst < 0.05 + 2.5e-16 / pixel);
      }
    }
  }
}

TEST_CASE("a parabola stays smooth and in place when magnified, and ends where it should") {
  const GlDeviceOptions options = GENERATE(from_range(kWays));
  Drawing drawing(options);
  // 2 y = x^2 from x = -1 to 1.
  drawing.set(0, parabola, {-1.0, 0.5, 0.0, -0.5, 1.0, 0.5});
  const double deepest = drawing.device().uses_double() ? 1e-12 : 1e-9;
  for (const double view_width : {4.0, 1e-1, 1e-4, 1e-6, 1e-9, deepest}) {
    const double pixel = view_width / kWidth;
    for (const double x0 : {-0.75, 0.0, 0.5, 1.0}) {
      const Vec2 at{x0, 0.5 * x0 * x0};
      const double slope_length = std::hypot(1.0, x0);
      const Image image = drawing.draw(camera_at(at, view_width), {{0, black(6.0)}});
      CAPTURE(options.allow_double, options.allow_precise, view_width, x0);
      double worst = 0.0;
      for (int y = 0; y < kHeight; ++y) {
        for (int x = 0; x < kWidth; ++x) {
          const Vec2 px{x + 0.5 - 0.5 * kWidth, 0.5 * kHeight - y - 0.5};
          const Vec2 p = pixel * px;
          // Past an end the cap begins, whose pixels are left out in the largest view.
          if (std::abs(x0 + p.x) > 0.9 && view_width > 1.0) continue;
          double off = std::abs(p.y - x0 * p.x - 0.5 * p.x * p.x) / pixel;
          // Near the curve, relative to the length of the gradient there.
          off /= view_width > 1e-2 ? std::hypot(1.0, x0 + p.x) : slope_length;
          if (view_width > 1e-2 && off > 3.5) continue;
          const bool is_past = x0 == 1.0 && px.x + x0 * px.y > 0.0;
          const double sd = is_past ? length(px) : off;
          worst = std::max(worst, std::abs(std::clamp(3.5 - sd, 0.0, 1.0) - cover(image, x, y)));
        }
      }
      // The last bit of a coordinate moves the curve by so much; a wide stroke of a large curve is not quite as wide.
      CHECK(worst < (view_width > 1e-2 ? 0.35 : 0.06) + 2.5e-16 / pixel);
    }
  }
}

TEST_CASE("triangles far larger than the view have straight edges in place") {
  Drawing drawing;
  const double view_width = 1e-11;
  const Vec2 middle{0.25, -0.375};
  // The view is on an edge of slope 1/2, half way between two corners.
  drawing.set(0, triangle, {-0.75, -0.875, 1.25, 0.125, 0.5, 1.0});
  const Image image = drawing.draw(camera_at(middle, view_width), {{0, black(1.0)}});
  const Vec2 normal = (1.0 / std::sqrt(5.0)) * Vec2{1.0, -2.0};
  double worst = 0.0;
  for (int y = 0; y < kHeight; ++y) {
    for (int x = 0; x < kWidth; ++x) {
      const Vec2 p{x + 0.5 - 0.5 * kWidth, 0.5 * kHeight - y - 0.5};
      worst = std::max(worst, std::abs(std::clamp(0.5 - dot(p, normal), 0.0, 1.0) - cover(image, x, y)));
    }
  }
  CHECK(worst < 0.06);
}

TEST_CASE("the inside of a disk or a triangle stays covered, however small a part of it is in view") {
  for (const GlDeviceOptions& way : kWays) {
    GlDeviceOptions painted = way;
    painted.pixel_cost_ns = 0.0;
    Drawing drawing(painted);
    drawing.set(0, disk, {0.25, 0.5, 1.0});
    drawing.set(1, triangle, {-2.0, -2.0, 3.0, -2.0, 0.0, 4.0});
    drawing.set(2, disk, {0.25, 0.5, 0x1p40, 0.25, 0.5, 0x1p-40});
    // Deep inside, near the rim of the first, and in the middle of it.
    for (const Vec2 p : {Vec2{0.9, 0.1}, Vec2{0.25 + 0.999, 0.5}, Vec2{0.25, 0.5}}) {
      Camera camera;
      camera.set_viewport(16, 12);
      for (int exponent = 8; exponent <= 240; exponent += 4) {
        camera.look_at(p, std::ldexp(1.0, -exponent - 8));
        for (const LayerIndex layer : {0U, 1U, 2U}) {
          INFO("layer " << layer << ", pixels of 2^-" << exponent + 8 << ", at " << p.x << ' ' << p.y);
          const Image image = drawing.draw(camera, {{layer, black(1.0)}});
          CHECK(covered_area(image) == Approx(16 * 12));
        }
      }
    }
    // Just outside of the first there is nothing at any zoom.
    Camera camera;
    camera.set_viewport(16, 12);
    for (int exponent = 16; exponent <= 240; exponent += 8) {
      camera.look_at({0.25 + 1.001, 0.5}, std::ldexp(1.0, -exponent));
      CHECK(covered_area(drawing.draw(camera, {{0, black(1.0)}})) == 0.0);
    }
  }
}

TEST_CASE("a drawing far from the origin pans and zooms like any other") {
  Drawing drawing;
  const double offset = 1e15;
  const DrawingFrame frame{.origin = {offset, -offset}, .scale = 1.0 / 128.0};
  drawing.set(0, point, {offset + 1.0, -offset + 2.0, offset - 3.5, -offset - 1.0}, frame);
  drawing.set(1, segment, {offset + 1.0, -offset + 2.0, offset - 3.5, -offset - 1.0}, frame);
  const std::vector<LayerView> views{{0, black(1.0, 7.0)}, {1, black(2.0)}};
  Camera camera = camera_at({offset, -offset}, 10.0);
  const Image before = drawing.draw(camera, views);
  CHECK(cover(before, 240, 70) == Approx(1.0));
  CHECK(cover(before, 60, 190) == Approx(1.0));
  camera.pan({1.0, 0.0});
  CHECK(largest_difference_moved(before, drawing.draw(camera, views), 1, 0, 3) <= 2);
}
