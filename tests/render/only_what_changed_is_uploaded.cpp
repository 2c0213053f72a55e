// SPDX-License-Identifier: GPL-3.0-or-later
// Traffic and buffer contents, on a device that counts and checks.
#include <algorithm>
#include <array>
#include <catch2/catch.hpp>
#include <cstring>
#include <limits>
#include <map>

#include "core/base/assert.h"
#include "core/base/rng.h"
#include "render/device/instance_layout.h"
#include "render/device/recording_device.h"
#include "tests/render/drawing.h"

using namespace mes;
using namespace mes::test;
using render::BufferId;
using render::ByteRange;
using render::Camera;
using render::LayerView;
using render::RecordingDevice;
using render::Scene;

namespace {

using enum PrimitiveKind;

/// The instances of a layer and kind as the device holds them, found by drawing it alone.
std::vector<double> held(RecordingDevice& device, Scene& scene, LayerIndex layer) {
  device.forget_calls();
  const std::vector<LayerView> views{{layer, {}}};
  Camera camera = pixel_camera(100, 100);
  camera.look_at({}, 1e9);  // it sees all of them
  scene.draw(camera, views, {});
  std::vector<double> out;
  for (const render::DrawCall& call : device.calls()) {
    const auto bytes = device.contents(call.buffer);
    const std::size_t size = call.instances * render::layout_of(call.program.kind).bytes();
    const std::size_t end = out.size();
    out.resize(end + size / sizeof(double));
    std::memcpy(&out[end], bytes.data(), size);
  }
  return out;
}

std::vector<double> many_segments(std::size_t count) {
  std::vector<double> out;
  for (std::size_t i = 0; i < 4 * count; ++i) out.push_back(0.001 * static_cast<double>(i));
  return out;
}

}  // namespace

TEST_CASE("panning, zooming and restyling upload nothing") {
  RecordingDevice device;
  Scene scene(device);
  for (const PrimitiveKind kind : kAllPrimitiveKinds) {
    std::vector<double> data;
    for (std::size_t i = 0; i < 50 * doubles_per(kind); ++i) data.push_back(0.01 * static_cast<double>(i + 1));
    scene.apply(instances(static_cast<LayerIndex>(kind), kind, data));
  }
  const std::uint64_t after_patches = device.counters().bytes_uploaded;
  const std::uint64_t allocated = device.counters().bytes_allocated;
  CHECK(after_patches == scene.bytes_uploaded());
  Camera camera = pixel_camera(800, 600);
  std::vector<LayerView> views;
  for (LayerIndex layer = 0; layer < kPrimitiveKinds; ++layer) views.push_back({layer, {}});
  for (int i = 0; i < 100; ++i) {
    camera.pan({13.0, -7.0});
    camera.zoom_at({100.0 + i, 200.0}, i < 50 ? 1.7 : 0.6);
    for (LayerView& view : views) {
      view.style.opacity = 0.005 * (i + 1);
      view.style.line_width_px = 0.3 * i;
      view.style.flat = i % 3 == 0;
      view.style.dashed = i % 2 == 0;
    }
    std::swap(views[static_cast<std::size_t>(i) % views.size()], views.front());
    scene.draw(camera, views, {.content_scale = 1.0 + 0.01 * i});
    CHECK(scene.draw_calls() <= kPrimitiveKinds);  // some are out of view
  }
  camera.look_at({}, 1.0);
  scene.draw(camera, views, {});
  CHECK(scene.draw_calls() == kPrimitiveKinds);
  CHECK(device.counters().bytes_uploaded == after_patches);
  CHECK(device.counters().bytes_allocated == allocated);
}

TEST_CASE("one changed instance among 10^5 uploads less than 100 bytes") {
  for (const PrimitiveKind kind : kAllPrimitiveKinds) {
    RecordingDevice device;
    Scene scene(device);
    const std::size_t step = doubles_per(kind);
    scene.apply(instances(0, kind, std::vector<double>(100000 * step, 0.5)));
    const std::uint64_t before = device.counters().bytes_uploaded;
    CHECK(before == 100000 * render::layout_of(kind).bytes());
    scene.apply(changes(0, kind, 100000, {77777}, std::vector<double>(step, 0.25)));
    const std::uint64_t uploaded = device.counters().bytes_uploaded - before;
    CHECK(uploaded > 0);
    CHECK(uploaded < 100);
    CHECK(held(device, scene, 0)[77777 * render::layout_of(kind).doubles()] == 0.25);
  }
}

TEST_CASE("instances next to each other go up together") {
  RecordingDevice device;
  Scene scene(device);
  scene.apply(instances(0, point, std::vector<double>(2000, 0.0)));
  const std::uint64_t updates = device.counters().updates;
  scene.apply(changes(0, point, 1000, {500, 12, 501, 10, 11, 499, 700}, std::vector<double>(14, 1.0)));
  CHECK(device.counters().updates - updates == 3);
}

TEST_CASE("of an instance named twice the later one stays") {
  RecordingDevice device;
  Scene scene(device);
  scene.apply(instances(0, point, {0, 0, 1, 1, 2, 2}));
  scene.apply(changes(0, point, 3, {2, 1, 2, 1}, {10, 10, 11, 11, 12, 12, 13, 13}));
  CHECK(held(device, scene, 0) == std::vector<double>{0, 0, 13, 13, 12, 12});
}

TEST_CASE("growing keeps what is there, shrinking drops the end") {
  RecordingDevice device;
  Scene scene(device);
  scene.apply(instances(0, segment, many_segments(3)));
  for (std::uint32_t count = 3; count < 500; ++count) {
    scene.apply(changes(0, segment, count + 1, {count}, {1.0 * count, 2.0, 3.0, 4.0}));
  }
  std::vector<double> all = held(device, scene, 0);
  REQUIRE(all.size() == 2000);
  const std::vector<double> first = many_segments(3);
  CHECK(std::equal(first.begin(), first.end(), all.begin()));
  for (std::size_t i = 3; i < 500; ++i) CHECK(all[4 * i] == static_cast<double>(i));
  // Growth was geometric: bytes uploaded are those of the instances alone.
  CHECK(device.counters().bytes_uploaded == 500 * 32);

  scene.apply(changes(0, segment, 2, {}, {}));
  CHECK(scene.instances(0, segment) == 2);
  CHECK(held(device, scene, 0).size() == 8);
  scene.apply(changes(0, segment, 0, {}, {}));
  CHECK(held(device, scene, 0).empty());
  // An instance that the same patch drops again is nothing to write.
  scene.apply(changes(0, segment, 1, {0, 5}, {1, 1, 1, 1, 9, 9, 9, 9}));
  CHECK(held(device, scene, 0) == std::vector<double>{1, 1, 1, 1});
}

TEST_CASE("random patches leave the device with what a plain model holds") {
  RecordingDevice device;
  Scene scene(device);
  std::vector<double> model;
  Rng random(3);
  const DrawingFrame frame{.origin = {10.0, -4.0}, .scale = 0.25};
  for (int step = 0; step < 2000; ++step) {
    if (random.below(100) == 0) {
      model.assign(2 * random.below(300), 0.0);
      for (double& v : model) v = random.uniform(-50.0, 50.0);
      scene.apply(instances(0, point, model, frame));
    } else {
      const auto count = static_cast<std::uint32_t>(model.size() / 2);
      const auto grown = static_cast<std::uint32_t>(std::max<std::int64_t>(
          0, static_cast<std::int64_t>(count) + static_cast<std::int64_t>(random.below(7)) - 3));
      std::vector<std::uint32_t> index;
      for (std::uint32_t i = count; i < grown; ++i) index.push_back(i);
      for (std::uint64_t i = random.below(10); i > 0 && grown > 0; --i) {
        index.push_back(static_cast<std::uint32_t>(random.below(grown)));
      }
      std::vector<double> data;
      model.resize(2 * grown);
      for (const std::uint32_t i : index) {
        for (std::size_t k = 0; k < 2; ++k) data.push_back(model[2 * i + k] = random.uniform(-50.0, 50.0));
      }
      scene.apply(changes(0, point, grown, index, data, frame));
    }
    REQUIRE(scene.instances(0, point) == model.size() / 2);
    std::vector<double> expected = model;
    for (std::size_t i = 0; i < expected.size(); ++i) {
      expected[i] = (expected[i] - (i % 2 == 0 ? frame.origin.x : frame.origin.y)) * frame.scale;
    }
    REQUIRE(held(device, scene, 0) == expected);
  }
}

TEST_CASE("segments of zero length are counted through random patches") {
  RecordingDevice device;
  Scene scene(device);
  std::vector<double> model;
  Rng random(4);
  for (int step = 0; step < 2000; ++step) {
    const auto count = static_cast<std::uint32_t>(model.size() / 4);
    const bool is_whole = random.below(50) == 0;
    const auto wanted = static_cast<std::uint32_t>(is_whole ? random.below(60) : count + random.below(7));
    const std::uint32_t grown = is_whole ? wanted : std::max(wanted, 3U) - 3U;
    std::vector<std::uint32_t> index;
    for (std::uint32_t i = is_whole ? 0 : count; i < grown; ++i) index.push_back(i);
    for (std::uint64_t i = random.below(6); !is_whole && i > 0 && grown > 0; --i)
      index.push_back(static_cast<std::uint32_t>(random.below(grown)));
    model.resize(4 * std::size_t{grown});
    std::vector<double> data;
    for (const std::uint32_t i : index) {
      const std::array<double, 4> ends{0.0, 0.0, 0.0, random.below(2) == 0 ? 0.0 : 1.0};
      std::ranges::copy(ends, model.begin() + 4 * static_cast<std::ptrdiff_t>(i));
      data.insert(data.end(), ends.begin(), ends.end());
    }
    scene.apply(is_whole ? instances(0, segment, data) : changes(0, segment, grown, index, data));
    std::uint32_t expected = 0;
    for (std::size_t i = 0; i < model.size(); i += 4) expected += model[i + 3] == 0.0 ? 1U : 0U;
    REQUIRE(scene.zero_length_segments(0) == expected);
  }
  scene.forget(0);
  CHECK(scene.zero_length_segments(0) == 0);
}

TEST_CASE("groups cost a target only when they are used") {
  RecordingDevice device;
  Scene scene(device);
  scene.apply(instances(0, disk, {0, 0, 1, 1, 0, 1}));
  std::vector<LayerView> views{{0, {}}};
  views[0].style.flat = true;
  scene.draw(pixel_camera(100, 100), views, {});
  CHECK(device.counters().composites == 0);
  CHECK(device.framebuffers_alive() == 0);
  views[0].style.opacity = 0.5;
  scene.draw(pixel_camera(100, 100), views, {});
  scene.draw(pixel_camera(90, 50), views, {});
  CHECK(device.counters().composites == 2);
  CHECK(device.framebuffers_alive() == 1);
  views[0].style.opacity = 0.0;
  scene.draw(pixel_camera(100, 100), views, {});
  CHECK(scene.draw_calls() == 0);
}

TEST_CASE("overlays are drawn after all layers, replaced and cleared") {
  RecordingDevice device;
  Scene scene(device);
  scene.apply(instances(0, point, {0, 0}));
  const std::vector<double> hovered{1, 2, 0};
  scene.set_overlay(3, {.kind = point, .data = hovered, .style = {.point_size_px = 11.0}, .ring = true});
  const std::vector<double> box{0, 0, 1, 0, 0, 1, 0, 1, 1, 0};
  scene.set_overlay(1, {.kind = segment, .data = box, .style = {}});
  const std::vector<LayerView> views{{0, {}}};
  scene.draw(pixel_camera(100, 100), views, {});
  REQUIRE(device.calls().size() == 3);
  CHECK(device.calls()[1].program.kind == segment);
  CHECK(device.calls()[2].uniforms.half_width_px == 5.5F);
  CHECK(device.calls()[2].uniforms.ring_px == 0.5F);
  scene.clear_overlay(1);
  scene.set_overlay(3, {.kind = point, .data = {}, .style = {}});
  device.forget_calls();
  scene.draw(pixel_camera(100, 100), views, {});
  CHECK(device.calls().size() == 1);
}

TEST_CASE("a scene gives everything back") {
  RecordingDevice device;
  {
    Scene scene(device);
    scene.apply(instances(2, disk, {0, 0, 1}));
    scene.apply(instances(1, point, std::vector<double>(20000, 0.0)));
    scene.apply(instances(1, point, {0, 0}));
    CHECK(device.counters().bytes_allocated < 2000);
    scene.forget(2);
    CHECK(device.buffers_alive() == 1);
    LayerStyle style;
    style.flat = true;
    style.opacity = 0.5;
    const std::vector<LayerView> views{{1, style}, {7, style}};
    scene.draw(pixel_camera(10, 10), views, {});
  }
  CHECK(device.buffers_alive() == 0);
  CHECK(device.framebuffers_alive() == 0);
  CHECK(device.counters().bytes_allocated == 0);
}

TEST_CASE("the recording device refuses calls that break the contract") {
  RecordingDevice device;
  const BufferId buffer = device.create_buffer(64);
  const std::vector<std::byte> data(32);
  const auto update = [&](std::vector<ByteRange> ranges) { device.update_buffer(buffer, ranges, data); };
  CHECK_NOTHROW(update({{0, 32}}));
  CHECK_THROWS_AS(update({{40, 32}}), AssertionFailure);
  CHECK_THROWS_AS(update({{0, 16}}), AssertionFailure);
  CHECK_THROWS_AS(update({{0, 16}, {8, 16}}), AssertionFailure);
  CHECK_THROWS_AS(device.resize_buffer(buffer, 32, 48), AssertionFailure);
  render::DrawCall call;
  call.area = {0, 0, 10, 10};
  call.buffer = buffer;
  call.instances = 4;
  call.uniforms.half_view_px = {5.0F, 5.0F};
  CHECK_NOTHROW(device.draw(call));
  call.instances = 5;
  CHECK_THROWS_AS(device.draw(call), AssertionFailure);
  call.instances = 4;
  call.uniforms.center_1[0] = std::numeric_limits<float>::infinity();
  CHECK_THROWS_AS(device.draw(call), AssertionFailure);
  device.destroy_buffer(buffer);
  CHECK_THROWS_AS(device.destroy_buffer(buffer), AssertionFailure);
}

TEST_CASE("the real device holds the same as the recording one") {
  // Growth, scattered and mapped updates on OpenGL, seen through the picture.
  Drawing drawing;
  RecordingDevice recorder;
  Scene model(recorder);
  Rng random(5);
  std::vector<double> all;
  const auto apply = [&](const FramePatch& patch) {
    drawing.scene().apply(patch);
    model.apply(patch);
  };
  apply(instances(0, point, {5, 5}));
  for (std::uint32_t count : {30U, 100U, 900U, 2500U}) {
    std::vector<std::uint32_t> index;
    std::vector<double> data;
    for (std::uint32_t i = 0; i < count; i += 2) {
      index.push_back(i);
      data.push_back(random.uniform(0.0, 200.0));
      data.push_back(random.uniform(0.0, 200.0));
    }
    // New odd ones follow in a second patch, so that both hold gaps in between.
    apply(changes(0, point, count, index, data));
    for (std::uint32_t& i : index) i += 1;
    std::reverse(data.begin(), data.end());
    apply(changes(0, point, count, index, data));
  }
  const std::vector<double> contents = held(recorder, model, 0);
  drawing.set(1, point, contents);
  LayerStyle style;
  style.point_size_px = 3.0;
  const auto camera = pixel_camera(200, 200);
  CHECK(drawing.draw(camera, {{0, style}}) == drawing.draw(camera, {{1, style}}));
}

TEST_CASE("a preview draws each n-th disk, and all of everything else") {
  RecordingDevice device;
  Scene scene(device);
  std::vector<double> disks;
  for (int i = 0; i < 1001; ++i) disks.insert(disks.end(), {0.01 * i, 0.0, 1.0});
  scene.apply(instances(0, disk, disks));
  scene.apply(instances(1, segment, many_segments(1001)));
  const auto drawn = [&](std::uint32_t every) {
    const std::uint64_t before = device.counters().instances_drawn;
    const std::vector<LayerView> views{{0, {}, every}, {1, {}, every}};
    scene.draw(pixel_camera(100, 100), views, {});
    return device.counters().instances_drawn - before;
  };
  CHECK(drawn(1) == 1001 + 1001);
  CHECK(drawn(0) == 1001 + 1001);
  CHECK(drawn(10) == 101 + 1001);
  CHECK(drawn(4096) == 1 + 1001);
}
