// SPDX-License-Identifier: GPL-3.0-or-later
// Counting circles gives the picture of painting them, whatever was added, moved and removed before.
#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <vector>

#include "core/base/rng.h"
#include "render/device/recording_device.h"
#include "render/instances/circle_field.h"
#include "render/instances/counted_instances.h"
#include "tests/render/drawing.h"
#include "tests/render/images.h"

using namespace mes;
using namespace mes::render;
using namespace mes::test;

namespace {

constexpr int kCirclesWidth = 90;
constexpr int kCirclesHeight = 70;

/// From points to larger than the view, inside, at its edges and beside it; some on the grid of pixels.
std::vector<PixelDisk> random_circles(Rng& rng, std::size_t count, int width, int height) {
  std::vector<PixelDisk> out;
  for (std::size_t i = 0; i < count; ++i) {
    const double radius = std::exp2(-4.0 + 12.0 * rng.uniform());
    out.push_back({(2.0 * rng.uniform() - 0.5) * width, (2.0 * rng.uniform() - 0.5) * height, radius});
    if (i % 7 == 0) out.back().x = std::floor(out.back().x);
    if (i % 11 == 0) out.back().y = std::floor(out.back().y) + 0.5;
    if (i % 13 == 0) out.back().radius = std::ceil(radius);
    if (i % 17 == 0) out.back().radius = 0.0;
  }
  return out;
}

/// The same by the formula of the header, circle by circle; ramps as in shaders/circle.frag.
double opacity_of_circles_at(const std::vector<PixelDisk>& circles, double opacity, double half_width, int x, int y) {
  double passes = 1.0;
  for (const PixelDisk& circle : circles) {
    const double from_rim = std::abs(std::hypot(x + 0.5 - circle.x, y + 0.5 - circle.y) - circle.radius);
    passes *= 1.0 - opacity * std::clamp(0.5 - (from_rim - half_width), 0.0, 1.0);
  }
  return 1.0 - passes;
}

double difference_of_circles(const CircleField& field, const std::vector<PixelDisk>& circles, double opacity,
                             double half_width) {
  double worst = 0.0;
  for (int y = 0; y < field.height(); ++y)
    for (int x = 0; x < field.width(); ++x)
      worst = std::max(worst, std::abs(field.row(y)[static_cast<std::size_t>(x)] / 65535.0 -
                                       opacity_of_circles_at(circles, opacity, half_width, x, y)));
  return worst;
}

std::vector<std::uint16_t> opacities_of_circles(const CircleField& field) {
  const auto rows = field.rows({0, field.height()});
  return {rows.begin(), rows.end()};
}

std::vector<double> coordinates_of_circles(const std::vector<PixelDisk>& circles) {
  std::vector<double> out;
  for (const PixelDisk& circle : circles) out.insert(out.end(), {circle.x, circle.y, circle.radius});
  return out;
}

/// A drawing on a target of its own, as a window draws it, or as a saved picture.
class Shown {
 public:
  Shown(int width, int height, const GlDeviceOptions& options)
      : drawing_(options),
        camera_(pixel_camera(width, height)),
        area_{0, 0, width, height},
        target_(drawing_.device().create_framebuffer({.width = width, .height = height})) {}
  ~Shown() { drawing_.device().destroy_framebuffer(target_); }

  Drawing& drawing() { return drawing_; }
  Camera& camera() { return camera_; }
  std::uint64_t masks() { return drawing_.device().counters().masks; }
  Image picture(const LayerView& view, Preview preview) {
    drawing_.device().clear(target_, area_, {1.0F, 1.0F, 1.0F, 1.0F});
    drawing_.scene().draw(camera_, std::span(&view, 1), {.target = target_, .preview = preview});
    return read_image(drawing_.device(), target_, area_);
  }

 private:
  Drawing drawing_;
  Camera camera_;
  PixelRect area_;
  FramebufferId target_;
};

}  // namespace

TEST_CASE("a field of circles has the opacity of painting without rounding") {
  Rng rng(40);
  for (const std::size_t count : {1U, 5U, 40U, 400U}) {
    for (const double opacity : {0.01, 0.5, 1.0}) {
      for (const double half_width : {0.5, 0.8, 4.0}) {
        const auto circles = random_circles(rng, count, kCirclesWidth, kCirclesHeight);
        CircleField field(kCirclesWidth, kCirclesHeight, opacity, half_width);
        field.add(circles);
        field.settle();
        INFO(count << " circles of opacity " << opacity << " and half width " << half_width);
        CHECK(difference_of_circles(field, circles, opacity, half_width) < 1e-3);
      }
    }
  }
}

TEST_CASE("the field of circles that are far larger than the view is right") {
  // They pass within a few pixels of the middle of the view.
  for (const double radius : {1e3, 1e5, 1e7, 1e9}) {
    for (const double turn : {0.0, 0.4, 1.6, 2.9, 4.0, 5.5}) {
      const double reach = radius + 3.25;
      const std::vector<PixelDisk> circles{{20.0 + reach * std::cos(turn), 15.0 + reach * std::sin(turn), radius}};
      CircleField field(40, 30, 0.5, 1.3);
      field.add(circles);
      field.settle();
      INFO("radius " << radius << ", direction " << turn);
      CHECK(difference_of_circles(field, circles, 0.5, 1.3) < 1e-3);
    }
  }
}

TEST_CASE("a field of circles is a function of their set") {
  Rng rng(41);
  auto circles = random_circles(rng, 500, kCirclesWidth, kCirclesHeight);
  CircleField once(kCirclesWidth, kCirclesHeight, 0.3, 0.7);
  once.add(circles);
  once.settle();

  // In another order, a few at a time, with others that go again.
  const auto others = random_circles(rng, 500, kCirclesWidth, kCirclesHeight);
  CircleField slowly(kCirclesWidth, kCirclesHeight, 0.3, 0.7);
  slowly.add(others);
  slowly.settle();
  std::ranges::reverse(circles);
  for (std::size_t i = 0; i < circles.size(); i += 3) {
    slowly.add(std::span(circles).subspan(i, std::min<std::size_t>(3, circles.size() - i)));
    if (i % 2 == 0) slowly.settle();
  }
  slowly.remove(others);
  slowly.settle();
  CHECK(opacities_of_circles(slowly) == opacities_of_circles(once));

  slowly.remove(circles);
  slowly.settle();
  CHECK(std::ranges::all_of(opacities_of_circles(slowly),
                            [](std::uint16_t opacity_there) { return opacity_there == 0; }));
}

TEST_CASE("a window draws the same circles by counting and by painting, and a saved picture paints them") {
  constexpr int kWidth = 200;
  constexpr int kHeight = 150;
  for (const bool is_flat : {false, true}) {
    for (const double width : {0.4, 1.0, 5.0}) {
      const LayerView view{
          .layer = 3, .style = {.color = {40, 120, 200}, .opacity = 0.6, .line_width_px = width, .flat = is_flat}};
      Rng rng(42);
      const auto circles = random_circles(rng, 60, kWidth, kHeight);
      Shown painted(kWidth, kHeight, {.instance_cost_ns = 0.0});
      Shown counted(kWidth, kHeight, {.instance_cost_ns = 1e9});
      for (Shown* const shown : {&painted, &counted})
        shown->drawing().set(3, PrimitiveKind::circle, coordinates_of_circles(circles));
      for (const double zoom : {1.0, 0.03, 4.1, 300.0}) {
        for (Shown* const shown : {&painted, &counted}) {
          shown->camera() = pixel_camera(kWidth, kHeight);
          shown->camera().zoom_at({71.0, 40.0}, zoom);
        }
        INFO((is_flat ? "flat" : "blended") << ", width " << width << ", zoom " << zoom);
        const std::uint64_t masks = counted.masks();
        // Painting rounds to a grey level after each circle.
        CHECK(largest_difference(painted.picture(view, Preview::fine), counted.picture(view, Preview::fine)) <= 6);
        CHECK(counted.masks() == masks + 1);
        CHECK(painted.picture(view, Preview::none).rgba == counted.picture(view, Preview::none).rgba);
        CHECK(counted.masks() == masks + 1);
      }
      CHECK(painted.masks() == 0);
    }
  }
}

TEST_CASE("counted circles follow the edits of their layer") {
  constexpr int kWidth = 160;
  constexpr int kHeight = 100;
  Rng rng(43);
  Shown edited(kWidth, kHeight, {.instance_cost_ns = 1e9});
  const LayerView view{.layer = 0, .style = {.color = {0, 0, 0}, .opacity = 0.2}};
  auto circles = random_circles(rng, 200, kWidth, kHeight);
  edited.drawing().set(0, PrimitiveKind::circle, coordinates_of_circles(circles));
  for (int step = 0; step < 30; ++step) {
    const auto count = static_cast<std::size_t>(120 + rng.below(100));
    const auto fresh = random_circles(rng, 240, kWidth, kHeight);
    std::vector<std::uint32_t> index;
    for (std::size_t i = circles.size(); i < count; ++i) index.push_back(static_cast<std::uint32_t>(i));
    circles.resize(count);
    for (int i = 0; i < 4; ++i) index.push_back(static_cast<std::uint32_t>(rng.below(count)));
    std::vector<PixelDisk> written;
    for (std::size_t i = 0; i < index.size(); ++i) written.push_back(circles[index[i]] = fresh[i]);
    edited.drawing().scene().apply(
        changes(0, PrimitiveKind::circle, static_cast<std::uint32_t>(count), index, coordinates_of_circles(written)));
    if (step % 10 == 4) edited.camera().pan({3.5, -1.25});
    edited.drawing().scene().forget(1);
    edited.drawing().set(1, PrimitiveKind::circle, coordinates_of_circles(circles));
    LayerView other = view;
    other.layer = 1;
    INFO("step " << step);
    REQUIRE(edited.picture(view, Preview::fine).rgba == edited.picture(other, Preview::fine).rgba);
  }
}

TEST_CASE("a preview of very many circles is a grey level off in the mean") {
  constexpr int kWidth = 400;
  constexpr int kHeight = 300;
  constexpr int kCount = 60000;
  std::vector<PixelDisk> circles;
  for (int i = 0; i < kCount; ++i) {
    const double t = 6.283185307179586 * i / kCount;
    circles.push_back(
        {200.0 + 120.0 * std::cos(t), 150.0 + 60.0 * std::sin(2.0 * t), 20.0 + 15.0 * std::cos(3.0 * t)});
  }
  const LayerView view{.layer = 0, .style = {.color = {0, 0, 0}, .opacity = 0.004}};
  Shown shown(kWidth, kHeight, {.instance_cost_ns = 1e9});
  shown.drawing().set(0, PrimitiveKind::circle, coordinates_of_circles(circles));
  const Image fine = shown.picture(view, Preview::fine);
  CHECK_FALSE(shown.drawing().scene().is_coarse());
  const Image coarse = shown.picture(view, Preview::coarse);
  CHECK(shown.drawing().scene().is_coarse());
  CircleField field(kWidth, kHeight, 0.004, 0.5);
  field.add(circles);
  field.settle();
  double fine_off = 0.0;
  double coarse_off = 0.0;
  for (int y = 0; y < kHeight; ++y) {
    for (int x = 0; x < kWidth; ++x) {
      const double exact = 255.0 * (1.0 - field.row(y)[static_cast<std::size_t>(x)] / 65535.0);
      const std::size_t at = fine.offset(x, kHeight - 1 - y);
      fine_off += std::abs(exact - fine.rgba[at]);
      coarse_off += std::abs(exact - coarse.rgba[at]);
    }
  }
  CHECK(fine_off / (kWidth * kHeight) <= 1.0);
  CHECK(coarse_off / (kWidth * kHeight) <= 4.0);
  CHECK(fine_off < coarse_off);
}
