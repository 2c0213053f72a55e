// SPDX-License-Identifier: GPL-3.0-or-later
// Colour maps: their arithmetic, the range that follows edits, and the pixels against that arithmetic.
#include <catch2/catch.hpp>
#include <cmath>
#include <limits>
#include <numbers>

#include "core/base/rng.h"
#include "render/device/recording_device.h"
#include "render/instances/scalar_store.h"
#include "tests/render/drawing.h"
#include "tests/render/images.h"
#include "tests/support/golden_image.h"
#include "tests/support/not_finite.h"

using namespace mes;
using namespace mes::test;
using render::Camera;
using render::ColorMap;
using render::Image;
using render::LayerView;
using render::RecordingDevice;
using render::ScalarRange;
using render::Scene;

namespace {

using enum PrimitiveKind;

/// Dark blue, red, yellow: no two places look alike.
ColorMap warm_map() {
  return {"warm", {{0.0F, 0.1F, 0.5F}, {0.85F, 0.2F, 0.2F}, {1.0F, 0.9F, 0.2F}}, false};
}

LayerStyle mapped(const std::string& map) {
  LayerStyle style;
  style.color_map = map;
  style.color = palette::green;
  return style;
}

bool are_close(Rgb a, Rgb b) {
  return std::abs(a.r - b.r) <= 3 && std::abs(a.g - b.g) <= 3 && std::abs(a.b - b.b) <= 3;
}

/// Dots in a row, 10 pixels apart, and the colours they are drawn in.
std::vector<Rgb> dot_colors(Drawing& drawing, const std::vector<double>& scalars, const LayerStyle& look) {
  std::vector<double> dots;
  for (std::size_t i = 0; i < scalars.size(); ++i)
    dots.insert(dots.end(), {5.5 + 10.0 * static_cast<double>(i), 5.5});
  drawing.set(0, point, dots, {}, scalars);
  LayerStyle style = look;
  style.point_size_px = 7.0;
  const Image image = drawing.draw(pixel_camera(10 * static_cast<int>(scalars.size()), 11), {{0, style}});
  std::vector<Rgb> out;
  for (std::size_t i = 0; i < scalars.size(); ++i) out.push_back(pixel(image, 5 + 10 * static_cast<int>(i), 5));
  return out;
}

}  // namespace

TEST_CASE("a graded map is linear between its colours and clamped at its ends") {
  const ColorMap map{"steps", {{0, 0, 0}, {1, 0, 0}, {1, 1, 1}}, false};
  CHECK(map.at(0.0) == Rgb{0, 0, 0});
  CHECK(map.at(0.25) == Rgb{128, 0, 0});
  CHECK(map.at(0.5) == Rgb{255, 0, 0});
  CHECK(map.at(0.75) == Rgb{255, 128, 128});
  CHECK(map.at(1.0) == Rgb{255, 255, 255});
  CHECK(map.at(-3.0) == map.at(0.0));
  CHECK(map.at(3.0) == map.at(1.0));
  CHECK(map.color_of(2.0, {1.0, 3.0}) == map.at(0.5));
  CHECK(map.color_of(kInfinity, {1.0, 3.0}) == map.at(1.0));
  CHECK(map.color_of(-kInfinity, {1.0, 3.0}) == map.at(0.0));
  CHECK_FALSE(map.color_of(kNan, {1.0, 3.0}).has_value());
  CHECK(map.color_of(2.0, {2.0, 2.0}) == map.at(0.5));
  CHECK(map.color_of(2.1, {2.0, 2.0}) == map.at(1.0));
  CHECK(map.color_of(1.9, {2.0, 2.0}) == map.at(0.0));
  const double huge = std::numeric_limits<double>::max();
  CHECK(map.color_of(0.0, {-huge, huge}) == map.at(0.5));
}

TEST_CASE("categories have colours of their own, by seed, whatever the range") {
  const ColorMap map = render::categorical_map();
  CHECK(map.colors == render::categorical_map(0).colors);
  CHECK(map.colors != render::categorical_map(1).colors);
  CHECK(map.color_of(3.0, {0.0, 1.0}) == map.color_of(3.0, {-50.0, 200.0}));
  CHECK(map.color_of(3.2, {}) == map.color_of(3.0, {}));
  CHECK(map.color_of(-1.0, {}) == map.color_of(63.0, {}));
  for (int i = 0; i < 64; ++i)
    for (int k = 0; k < i; ++k) CHECK_FALSE(map.color_of(i, {}) == map.color_of(k, {}));
}

TEST_CASE("the range of a store is that of its finite values after any change") {
  Rng random(7);
  render::ScalarStore store;
  std::vector<double> model;
  for (int step = 0; step < 3000; ++step) {
    if (random.below(4) == 0) {
      const std::size_t size = random.below(random.below(3) == 0 ? 40000 : 100);
      store.resize(size);
      model.resize(size, kNan);
    }
    for (std::uint64_t i = random.below(6); i > 0 && !model.empty(); --i) {
      const std::size_t at = random.below(model.size());
      const std::uint64_t kind = random.below(10);
      const double value = kind == 0 ? kNan : kind == 1 ? kInfinity : random.uniform(-1.0, 1.0);
      store.set(at, value);
      model[at] = value;
    }
    store.settle();
    ScalarRange range;
    for (const double value : model) range.add(value);
    CHECK(store.range() == range);
  }
}

TEST_CASE("choosing a map, changing and locking the range upload no instances") {
  RecordingDevice device;
  Scene scene(device);
  for (const PrimitiveKind kind : kAllPrimitiveKinds) {
    std::vector<double> data;
    std::vector<double> scalars;
    for (std::size_t i = 0; i < 50 * doubles_per(kind); ++i) data.push_back(0.01 * static_cast<double>(i + 1));
    for (std::size_t i = 0; i < 50; ++i) scalars.push_back(static_cast<double>(i));
    scene.apply(instances(static_cast<LayerIndex>(kind), kind, data, {}, scalars));
  }
  const std::uint64_t uploaded = device.counters().bytes_uploaded;
  const std::uint64_t allocated = device.counters().bytes_allocated;
  CHECK(uploaded == scene.bytes_uploaded());
  LayerStyle style;
  for (int i = 0; i < 40; ++i) {
    style.color_map = i % 4 == 0 ? "" : i % 4 == 1 ? "grey" : i % 4 == 2 ? "categories" : "no such map";
    style.range_locked = i % 3 == 0;
    style.range_low = -i;
    style.range_high = 2.0 * i;
    style.flat = i % 5 == 0;
    style.opacity = 0.02 * (i + 1);
    std::vector<LayerView> views;
    for (LayerIndex layer = 0; layer < kPrimitiveKinds; ++layer) views.push_back({layer, style});
    device.forget_calls();
    scene.draw(pixel_camera(100, 100), views, {});
    for (const render::DrawCall& call : device.calls()) CHECK(call.program.mapped == (i % 4 == 1 || i % 4 == 2));
  }
  CHECK(device.counters().bytes_uploaded == uploaded);
  CHECK(device.counters().bytes_allocated == allocated);
  CHECK(device.textures_alive() == 1);
}

TEST_CASE("one changed scalar among 10^5 moves the range and uploads only its instance") {
  RecordingDevice device;
  Scene scene(device);
  std::vector<double> scalars(100000, 0.5);
  scene.apply(instances(0, segment, std::vector<double>(400000, 0.5), {}, scalars));
  CHECK(scene.scalar_range(0) == ScalarRange{0.5, 0.5});
  const std::uint64_t before = device.counters().bytes_uploaded;
  scene.apply(changes(0, segment, 100000, {77777}, {1, 2, 3, 4}, {}, {9.0}));
  CHECK(device.counters().bytes_uploaded - before == 32 + 8);
  CHECK(scene.scalar_range(0) == ScalarRange{0.5, 9.0});
  scene.apply(changes(0, segment, 100000, {77777, 5}, {1, 2, 3, 4, 1, 2, 3, 4}, {}, {kNan, -2.0}));
  CHECK(scene.scalar_range(0) == ScalarRange{-2.0, 0.5});
  scene.apply(changes(0, segment, 5, {}, {}, {}, {1.0}));
  CHECK(scene.scalar_range(0) == ScalarRange{0.5, 0.5});
  scene.forget(0);
  CHECK(scene.scalar_range(0).is_empty());
  CHECK(device.counters().bytes_allocated == 0);
}

TEST_CASE("dots have the colours that the map gives their scalars") {
  Drawing drawing;
  drawing.scene().set_color_maps({render::grey_map(), warm_map(), render::categorical_map(5)});
  const auto check = [&](const std::vector<double>& scalars, LayerStyle style) {
    const std::vector<Rgb> colors = dot_colors(drawing, scalars, style);
    ScalarRange range;
    for (const double scalar : scalars) range.add(scalar);
    if (style.range_locked) range = {style.range_low, style.range_high};
    const auto& maps = drawing.scene().color_maps();
    const ColorMap& map = *std::ranges::find(maps, style.color_map, &ColorMap::name);
    for (std::size_t i = 0; i < scalars.size(); ++i) {
      const Rgb expected = map.color_of(scalars[i], range).value_or(style.color);
      CAPTURE(i, scalars[i], range.low, range.high, map.name);
      CAPTURE(int{colors[i].r}, int{colors[i].g}, int{colors[i].b}, int{expected.r}, int{expected.g},
              int{expected.b});
      CHECK(are_close(colors[i], expected));
    }
  };
  for (const std::string map : {"grey", "warm", "categories"}) {
    check({0, 1, 2, 3, 4, 5, 6, 7, 8, 9}, mapped(map));
    check({-3, -2.4, -1, 0, 1e-3, kNan, 70, 64, kInfinity, -kInfinity}, mapped(map));
    LayerStyle locked = mapped(map);
    locked.range_locked = true;
    locked.range_low = 2.0;
    locked.range_high = 4.0;
    check({0, 1, 2, 2.5, 3, 3.5, 4, 5, 1e300, -1e300, kInfinity, kNan}, locked);
  }
  // Far from zero, close together, tiny, huge, alone, and none at all that is finite.
  check({1e12, 1e12 + 0.25, 1e12 + 0.5, 1e12 + 1.0}, mapped("warm"));
  check({1.0, 1.0 + 0x1p-51, 1.0 + 0x1p-50}, mapped("warm"));
  check({1e-300, 2e-300, 4e-300, -4e-300, 0.0}, mapped("warm"));
  check({-1e308, 0.0, 1e308, 5e307}, mapped("warm"));
  check({0.0, 0.0, kNan}, mapped("warm"));
  check({-7.5}, mapped("warm"));
  check({kInfinity, kNan}, mapped("warm"));
}

TEST_CASE("a map colours every kind of primitive, thin, thick, dashed and flat") {
  const auto set_all = [](Drawing& drawing) {
    const auto ramp = [](std::size_t count) {
      std::vector<double> out;
      for (std::size_t i = 0; i < count; ++i) out.push_back(static_cast<double>(i));
      return out;
    };
    drawing.scene().set_color_maps({warm_map()});
    drawing.set(0, point, {15, 135, 30, 135, 45, 135, 60, 135, 15, 120, 30, 120, 45, 120, 60, 120}, {}, ramp(8));
    drawing.set(1, disk, {95, 122, 18, 110, 122, 18, 125, 122, 18}, {}, ramp(3));
    drawing.set(2, circle, {170, 120, 22, 170, 120, 15, 170, 120, 8, 170, 120, 3}, {}, ramp(4));
    drawing.set(3, segment, {10, 10, 60, 50, 10, 25, 60, 65, 10, 40, 60, 80, 10, 55, 60, 95}, {}, ramp(4));
    drawing.set(4, ray, {75, 90, 1, 0.3, 75, 90, 1, 0.0, 75, 90, 1, -0.3}, {}, ramp(3));
    drawing.set(5, line, {150, 50, 1, -1, 160, 50, 1, -1, 170, 50, 1, -1}, {}, ramp(3));
    drawing.set(6, triangle, {80, 15, 110, 15, 95, 45, 110, 15, 95, 45, 125, 45, 110, 15, 125, 45, 140, 15}, {},
                ramp(3));
    drawing.set(7, arc, {170, 30, 25, 195, 30, 170, 55, 170, 30, 25, 170, 55, 145, 30, 170, 30, 18, 152, 30, 188, 30},
                {}, ramp(3));
  };
  std::vector<LayerView> views;
  for (LayerIndex layer = 0; layer < 8; ++layer) views.push_back({layer, mapped("warm")});
  views[0].style.point_size_px = 9.0;
  views[1].style.opacity = 0.6;
  views[3].style.line_width_px = 5.0;
  views[4].style.line_width_px = 2.0;
  views[4].style.dashed = true;
  views[5].style.opacity = 0.5;
  views[5].style.line_width_px = 7.0;
  views[6].style.opacity = 0.7;
  views[7].style.line_width_px = 3.0;

  Drawing drawing;
  set_all(drawing);
  CHECK(compare_with_golden(drawing.draw(pixel_camera(200, 150), views), "mapped") == "");
  CHECK(compare_with_golden(drawing.draw(pixel_camera(200, 150), views, {}), "mapped_transparent") == "");
  for (LayerView& view : views) {
    view.style.flat = true;
    view.style.opacity = 0.5;
  }
  const Image flat = drawing.draw(pixel_camera(200, 150), views);
  CHECK(compare_with_golden(flat, "mapped_flat") == "");
  // Where disks overlap the last one shows, no darker than where it is alone.
  CHECK(are_close(pixel(flat, 120, 27), pixel(flat, 138, 27)));
  // Tiles meet without a seam.
  const Image tiled = drawing.draw(pixel_camera(200, 150), views, {.background = kWhite, .tile_px = 64});
  CHECK(compare_with_golden(tiled, "mapped_flat") == "");

  // The other ways of computing far from the centre of the view, and with few extensions.
  for (const render::GlDeviceOptions& options :
       {render::GlDeviceOptions{.allow_double = false},
        render::GlDeviceOptions{.allow_double = false, .allow_precise = false}}) {
    Drawing other(options);
    set_all(other);
    CHECK(compare_with_golden(other.draw(pixel_camera(200, 150), views), "mapped_flat") == "");
  }
}

TEST_CASE("of mapped disks each n-th has its own colour") {
  Drawing drawing;
  drawing.scene().set_color_maps({warm_map()});
  std::vector<double> disks;
  std::vector<double> scalars;
  for (int i = 0; i < 2000; ++i) {
    disks.insert(disks.end(), {5.0 + 0.05 * i, 10.0, i % 500 == 0 ? 4.0 : 0.1});
    scalars.push_back(i);
  }
  drawing.set(0, disk, disks, {}, scalars);
  for (const std::uint32_t every : {20U, 500U}) {
    const Image image = drawing.draw(pixel_camera(110, 20), {{0, mapped("warm"), every}});
    for (int i = 0; i < 4; ++i) {
      const Rgb expected = *warm_map().color_of(500.0 * i, {0.0, 1999.0});
      CHECK(are_close(pixel(image, 5 + 25 * i, 7), expected));
    }
  }
}
