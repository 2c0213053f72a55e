// SPDX-License-Identifier: GPL-3.0-or-later
// Off-screen pictures, tiles, and PNG.
#include <catch2/catch.hpp>
#include <cmath>
#include <cstring>

#include "core/base/rng.h"
#include "render/image/png.h"
#include "tests/render/drawing.h"
#include "tests/support/golden_image.h"

using namespace mes;
using namespace mes::test;
using render::Camera;
using render::Image;
using render::LayerView;

namespace {

using enum PrimitiveKind;

std::vector<LayerView> fill_at_random(Drawing& drawing) {
  Rng random(2);
  std::vector<double> segments;
  std::vector<double> disks;
  std::vector<double> fan;
  for (int i = 0; i < 60; ++i) {
    for (int k = 0; k < 4; ++k) segments.push_back(random.uniform(0.0, 150.0));
    disks.insert(disks.end(), {random.uniform(0.0, 150.0), random.uniform(0.0, 150.0), random.uniform(0.0, 30.0)});
    for (int k = 0; k < 6; ++k) fan.push_back(random.uniform(0.0, 150.0));
  }
  drawing.set(0, disk, disks);
  drawing.set(1, segment, segments);
  drawing.set(2, circle, disks);
  drawing.set(3, triangle, {fan.begin(), fan.begin() + 60});
  std::vector<LayerView> views{{0, {}}, {3, {}}, {1, {}}, {2, {}}};
  views[0].style = {.color = palette::sky, .opacity = 0.4, .flat = true};
  views[1].style = {.color = palette::orange, .opacity = 0.4};
  views[2].style = {.color = palette::vermilion, .line_width_px = 2.5, .dashed = true};
  views[3].style = {.color = palette::blue};
  return views;
}

}  // namespace

TEST_CASE("tiles meet without a seam") {
  Drawing drawing;
  const auto views = fill_at_random(drawing);
  Camera camera = pixel_camera(151, 133);
  const Image whole = drawing.draw(camera, views);
  for (const int tile : {16, 37, 64, 150}) {
    const Image tiled = drawing.draw(camera, views, {.background = kWhite, .tile_px = tile});
    REQUIRE(tiled.rgba.size() == whole.rgba.size());
    int worst = 0;
    for (std::size_t i = 0; i < whole.rgba.size(); ++i)
      worst = std::max(worst, std::abs(whole.rgba[i] - tiled.rgba[i]));
    CAPTURE(tile);
    CHECK(worst <= 3);
  }
}

TEST_CASE("a picture beyond the limits of the hardware is drawn all the same") {
  Drawing drawing;
  const int width = drawing.device().max_framebuffer_size() + 100;
  drawing.set(0, point, {0.5, 20.0, width - 50.5, 20.0});
  LayerStyle style;
  style.point_size_px = 9.0;
  const Image image = drawing.draw(pixel_camera(width, 40), {{0, style}});
  CHECK(image.width == width);
  CHECK(cover(image, width - 51, 20) == 1.0);
  CHECK(cover(image, 0, 20) == 1.0);
  CHECK(cover(image, width / 2, 20) == 0.0);
}

TEST_CASE("a size that cannot be drawn is an error") {
  Drawing drawing;
  Camera camera;
  camera.set_viewport(1 << 20, 1 << 20);
  const auto image = render::draw_image(drawing.device(), drawing.scene(), camera, {}, {});
  REQUIRE(!image);
  CHECK(image.error().code == ErrorCode::usage);
}

TEST_CASE("a transparent picture laid on white is the picture on white") {
  Drawing drawing;
  const auto views = fill_at_random(drawing);
  const Image on_white = drawing.draw(pixel_camera(150, 150), views);
  const Image on_nothing = drawing.draw(pixel_camera(150, 150), views, {});
  int worst = 0;
  bool has_empty = false;
  for (std::size_t i = 0; i < on_white.rgba.size(); i += 4) {
    const double alpha = on_nothing.rgba[i + 3] / 255.0;
    has_empty = has_empty || alpha == 0.0;
    for (std::size_t c = 0; c < 3; ++c) {
      const double laid = on_nothing.rgba[i + c] * alpha + 255.0 * (1.0 - alpha);
      worst = std::max(worst, static_cast<int>(std::abs(laid - on_white.rgba[i + c])));
    }
  }
  CHECK(has_empty);
  CHECK(worst <= 3);
}

TEST_CASE("multisampling changes edges by next to nothing") {
  Drawing drawing;
  const auto views = fill_at_random(drawing);
  const Image plain = drawing.draw(pixel_camera(150, 150), views);
  const Image sampled = drawing.draw(pixel_camera(150, 150), views, {.background = kWhite, .samples = 4});
  int worst = 0;
  for (std::size_t i = 0; i < plain.rgba.size(); ++i)
    worst = std::max(worst, std::abs(plain.rgba[i] - sampled.rgba[i]));
  CHECK(worst <= 40);
}

TEST_CASE("PNG keeps every pixel") {
  Rng random(4);
  for (const int level : {render::kPngFast, render::kPngSmall}) {
    for (const bool opaque : {true, false}) {
      Image image{.width = 61, .height = 43, .rgba = std::vector<std::uint8_t>(61 * 43 * 4)};
      for (std::size_t i = 0; i < image.rgba.size(); ++i) {
        image.rgba[i] = opaque && i % 4 == 3 ? 255 : static_cast<std::uint8_t>(random.below(256));
      }
      const auto bytes = render::encode_png(image, level);
      REQUIRE(bytes);
      CHECK(decode_png(bytes->data(), bytes->size()) == image);
      CHECK(*bytes == *render::encode_png(image, level));
      // Colour type: 2 without alpha, 6 with.
      CHECK((*bytes)[25] == std::byte{static_cast<unsigned char>(opaque ? 2 : 6)});
    }
  }
}

TEST_CASE("a picture that is none is no PNG") {
  CHECK(!render::encode_png({}));
  CHECK(!render::encode_png({.width = 2, .height = 2, .rgba = std::vector<std::uint8_t>(15)}));
}
