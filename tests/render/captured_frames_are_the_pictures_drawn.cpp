// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <catch2/catch.hpp>
#include <cstdlib>

#include "render/frame_capture.h"
#include "tests/render/drawing.h"

using namespace mes;
using namespace mes::test;

namespace {

LayerStyle style(Rgb color, double width = 3.0) {
  LayerStyle out;
  out.color = color;
  out.line_width_px = width;
  out.point_size_px = 9.0;
  out.opacity = 0.7;
  return out;
}

void fill(Drawing& drawing) {
  drawing.set(0, PrimitiveKind::disk, {60, 50, 30, 90, 60, 25});
  drawing.set(1, PrimitiveKind::segment, {3, 4, 140, 92, 10, 90, 150, 10});
}

std::vector<render::LayerView> views() {
  return {{0, style({0xD5, 0x5E, 0x00})}, {1, style({0x00, 0x72, 0xB2})}};
}

int most_different(const render::Image& a, const render::Image& b) {
  REQUIRE(a.width == b.width);
  REQUIRE(a.height == b.height);
  int out = 0;
  for (std::size_t i = 0; i < a.rgba.size(); ++i) out = std::max(out, std::abs(a.rgba[i] - b.rgba[i]));
  return out;
}

// Means of squares of `factor` pixels, by hand.
render::Image averaged(const render::Image& large, int factor) {
  render::Image out{large.width / factor, large.height / factor, {}};
  out.rgba.resize(large.rgba.size() / static_cast<std::size_t>(factor * factor));
  for (int y = 0; y < out.height; ++y) {
    for (int x = 0; x < out.width; ++x) {
      for (std::size_t channel = 0; channel < 4; ++channel) {
        int sum = 0;
        for (int v = 0; v < factor; ++v)
          for (int u = 0; u < factor; ++u) sum += large.rgba[large.offset(factor * x + u, factor * y + v) + channel];
        out.rgba[out.offset(x, y) + channel] =
            static_cast<std::uint8_t>((sum + factor * factor / 2) / (factor * factor));
      }
    }
  }
  return out;
}

}  // namespace

TEST_CASE("a captured frame is the picture that is drawn, in tiles or not, on a colour or on nothing") {
  Drawing drawing;
  fill(drawing);
  const render::Camera camera = pixel_camera(161, 103);
  render::FrameCapture capture(drawing.device());
  for (const std::optional<Rgb> background : {std::optional<Rgb>(kWhite), std::optional<Rgb>()}) {
    const render::Image expected = drawing.draw(camera, views(), {.background = background});
    for (const int tile : {16, 50, 2048}) {
      REQUIRE(capture.draw(drawing.scene(), camera, views(), {.background = background, .tile_px = tile}));
      const auto raw = capture.wait();
      REQUIRE(raw);
      CHECK(most_different(render::to_image(*raw), expected) <= 1);
    }
  }
  CHECK_FALSE(capture.wait());
}

TEST_CASE("supersampling gives the means of a larger picture") {
  Drawing drawing;
  fill(drawing);
  const render::Camera camera = pixel_camera(160, 100);
  render::FrameCapture capture(drawing.device());
  for (const int factor : {2, 4}) {
    render::Camera large = camera;
    large.set_viewport(factor * 160, factor * 100);
    large.look_at(camera.center(), 1.0 / factor);
    const render::Image expected = averaged(
        drawing.draw(large, views(), {.background = kWhite, .content_scale = static_cast<double>(factor)}), factor);
    for (const int tile : {64, 2048}) {
      REQUIRE(capture.draw(drawing.scene(), camera, views(),
                           {.background = kWhite, .supersampling = factor, .tile_px = tile}));
      CHECK(most_different(render::to_image(*capture.wait()), expected) <= factor);
    }
  }
}

TEST_CASE("frames come in order, each as it was when asked for, however many are under way") {
  Drawing drawing;
  const render::Camera camera = pixel_camera(40, 40);
  render::FrameCapture capture(drawing.device());
  constexpr int kFrames = 10;
  for (int i = 0; i < kFrames; ++i) {
    drawing.set(0, PrimitiveKind::disk, {2.0 + 4 * i, 20, 1.9});
    REQUIRE(capture.draw(drawing.scene(), camera, views(), {.background = kWhite}));
  }
  CHECK(capture.pending() == kFrames);
  for (int i = 0; i < kFrames; ++i) {
    const auto raw = capture.wait();
    REQUIRE(raw);
    CHECK(covered_center(render::to_image(*raw)).x == Approx(2.0 + 4 * i).margin(0.1));
  }
  CHECK(capture.pending() == 0);
}

TEST_CASE("a frame comes without being waited for") {
  Drawing drawing;
  fill(drawing);
  render::FrameCapture capture(drawing.device());
  CHECK_FALSE(capture.poll());
  REQUIRE(capture.draw(drawing.scene(), pixel_camera(50, 50), views(), {}));
  drawing.device().finish();
  CHECK(capture.poll());
}
