// SPDX-License-Identifier: GPL-3.0-or-later
#include <catch2/catch.hpp>
#include <memory>

#include "render/device/recording_device.h"
#include "tests/render/drawing.h"

using namespace mes;
using namespace mes::test;
using render::Image;
using render::LayerTexts;
using render::LayerView;

namespace {

render::Font font() {
  auto read = render::Font::read("assets/fonts/Inter-Regular.otf");
  REQUIRE(read);
  return std::move(*read);
}

std::shared_ptr<const LayerTexts> texts(std::vector<render::PlacedText> list, double size = 16.0, Vec2 shift = {}) {
  return std::make_shared<const LayerTexts>(LayerTexts{font(), size, shift, std::move(list)});
}

std::size_t painted(const Image& image, Rgb color) {
  std::size_t out = 0;
  for (std::size_t i = 0; i < image.rgba.size(); i += 4)
    out += Rgb{image.rgba[i], image.rgba[i + 1], image.rgba[i + 2]} == color ? 1U : 0U;
  return out;
}

}  // namespace

TEST_CASE("words stand in the place of a layer's instances, as they are painted on a picture") {
  Drawing drawing;
  drawing.set(0, PrimitiveKind::point, {20, 20});
  const render::Camera camera = pixel_camera(100, 60);
  const auto words = texts({{{20.0, 20.0}, "17"}, {{60.25, 40.5}, "4 b"}}, 16.0, {5.0, -3.0});
  const Image image = drawing.draw(camera, {{0, {.point_size_px = 30.0}, 1, words}});
  Image expected{100, 60, std::vector<std::uint8_t>(4 * 100 * 60, 255)};
  render::draw_text(expected, font(), 16.0, 25.0, 37.0, {}, "17");
  render::draw_text(expected, font(), 16.0, 65.25, 16.5, {}, "4 b");
  // Letters are placed on quarters of pixels here.
  double difference = 0.0;
  for (int y = 0; y < 60; ++y)
    for (int x = 0; x < 100; ++x) difference += std::abs(cover(image, x, y) - cover(expected, x, y));
  CHECK(covered_area(image) == Approx(covered_area(expected)).epsilon(0.02));
  CHECK(difference < 0.15 * covered_area(expected));
  CHECK(covered_area(image) > 30.0);
}

TEST_CASE("words lie in their layer's place in the stack, with its colour and opacity") {
  Drawing drawing;
  drawing.set(0, PrimitiveKind::disk, {50, 30, 200});
  drawing.set(1, PrimitiveKind::point, {});
  const render::Camera camera = pixel_camera(100, 60);
  const auto words = texts({{{10.0, 10.0}, "888888"}}, 40.0);
  const LayerView disk{0, {.color = palette::sky}};
  const LayerView numbers{1, {.color = palette::vermilion}, 1, words};
  CHECK(painted(drawing.draw(camera, {numbers, disk}), palette::vermilion) == 0);
  CHECK(painted(drawing.draw(camera, {disk, numbers}), palette::vermilion) > 100);
  LayerView pale = numbers;
  pale.style.opacity = 0.5;
  const Image half = drawing.draw(camera, {pale});
  CHECK(painted(half, palette::vermilion) == 0);
  CHECK(covered_area(half) == Approx(0.5 * covered_area(drawing.draw(camera, {numbers}))).epsilon(0.04));
  pale.style.opacity = 0.0;
  CHECK(covered_area(drawing.draw(camera, {pale})) == 0.0);
}

TEST_CASE("tiles of a picture show its words without a seam") {
  Drawing drawing;
  drawing.set(0, PrimitiveKind::point, {});
  const auto words = texts({{{30.3, 31.7}, "123456"}, {{-10.0, 5.0}, "7777"}, {{90.0, 55.0}, "88888"}}, 18.0);
  const std::vector<LayerView> views{{0, {}, 1, words}};
  const Image whole = drawing.draw(pixel_camera(100, 60), views);
  CHECK(covered_area(whole) > 50.0);
  CHECK(drawing.draw(pixel_camera(100, 60), views, {.background = kWhite, .tile_px = 32}) == whole);
}

TEST_CASE("sizes are those of the logical pixel, and a moved view moves the words") {
  Drawing drawing;
  drawing.set(0, PrimitiveKind::point, {});
  const auto words = texts({{{30.0, 30.0}, "64"}}, 16.0, {2.0, 0.0});
  const std::vector<LayerView> views{{0, {}, 1, words}};
  render::Camera camera = pixel_camera(120, 80);
  const Image once = drawing.draw(camera, views);
  const Image twice = drawing.draw(camera, views, {.background = kWhite, .content_scale = 2.0});
  CHECK(covered_area(twice) == Approx(4.0 * covered_area(once)).epsilon(0.05));
  camera.pan({11.0, -6.0});
  const Vec2 moved = covered_center(drawing.draw(camera, views)) - covered_center(once);
  CHECK(moved.x == Approx(11.0).margin(0.01));
  CHECK(moved.y == Approx(-6.0).margin(0.01));
  camera.pan({1e9, 0.0});
  CHECK(covered_area(drawing.draw(camera, views)) == 0.0);
}

TEST_CASE("the same words in the same view are uploaded once, and forgotten with their layer") {
  render::RecordingDevice device;
  const auto words = texts({{{30.0, 30.0}, "64"}});
  {
    render::Scene scene(device);
    scene.apply(instances(0, PrimitiveKind::point, {30, 30}));
    render::Camera camera = pixel_camera(120, 80);
    const std::vector<LayerView> views{{0, {}, 1, words}};
    scene.draw(camera, views, {});
    const auto first = device.counters();
    CHECK(first.masks == 1);
    CHECK(first.mask_rows > 0);
    CHECK(first.mask_rows < 30);
    CHECK(first.instances_drawn == 0);
    scene.draw(camera, views, {});
    CHECK(device.counters().mask_rows == first.mask_rows);
    CHECK(device.counters().masks == 2);
    camera.pan({3.0, 0.0});
    scene.draw(camera, views, {});
    CHECK(device.counters().mask_rows == 2 * first.mask_rows);
    CHECK(device.textures_alive() == 1);
    scene.forget(0);
    CHECK(device.textures_alive() == 0);
    scene.draw(camera, std::vector<LayerView>{{0, {}, 1, std::make_shared<const LayerTexts>()}}, {});
    CHECK(device.textures_alive() == 0);
    scene.draw(camera, views, {});
  }
  CHECK(device.textures_alive() == 0);
}
