// SPDX-License-Identifier: GPL-3.0-or-later
// Counting disks gives the picture of painting them, whatever was added, moved and removed before.
#include <algorithm>
#include <array>
#include <catch2/catch.hpp>
#include <cmath>
#include <vector>

#include "core/base/rng.h"
#include "render/device/recording_device.h"
#include "render/instances/counted_instances.h"
#include "render/instances/disk_field.h"
#include "tests/render/drawing.h"
#include "tests/render/images.h"

using namespace mes;
using namespace mes::render;
using namespace mes::test;

namespace {

/// From far below a pixel to larger than the view, inside, at its edges and beside it.
std::vector<PixelDisk> random_disks(Rng& rng, std::size_t count, int width, int height) {
  std::vector<PixelDisk> out;
  for (std::size_t i = 0; i < count; ++i) {
    const double radius = std::exp2(-4.0 + 13.0 * rng.uniform());
    out.push_back({(3.0 * rng.uniform() - 1.0) * width, (3.0 * rng.uniform() - 1.0) * height, radius});
    if (i % 7 == 0) out.back().x = std::floor(out.back().x);
    if (i % 11 == 0) out.back().y = std::floor(out.back().y) + 0.5;
    if (i % 13 == 0) out.back().radius = std::ceil(radius);
    if (i % 17 == 0) out.back().radius = 0.0;
  }
  return out;
}

/// The same by the formula of the header, disk by disk in doubles; ramps as in shaders/disk.frag.
double opacity_of_disks_at(const std::vector<PixelDisk>& disks, double opacity, int x, int y) {
  double passes = 1.0;
  for (const PixelDisk& disk : disks) {
    const double q = std::sqrt(std::max(disk.radius * disk.radius - 1.0 / 12.0, 0.25));
    const double strength = std::min(3.0 * disk.radius * disk.radius, 1.0);
    const double distance = std::hypot(x + 0.5 - disk.x, y + 0.5 - disk.y) - q;
    passes *= 1.0 - opacity * strength * std::clamp(0.5 - distance, 0.0, 1.0);
  }
  return 1.0 - passes;
}

/// The largest difference to the formula.
double difference_of_disks(const DiskField& field, const std::vector<PixelDisk>& disks, double opacity) {
  double worst = 0.0;
  for (int y = 0; y < field.height(); ++y)
    for (int x = 0; x < field.width(); ++x)
      worst = std::max(worst, std::abs(field.row(y)[static_cast<std::size_t>(x)] / 65535.0 -
                                       opacity_of_disks_at(disks, opacity, x, y)));
  return worst;
}

std::vector<std::uint16_t> opacities_of_disks(const DiskField& field) {
  const auto rows = field.rows({0, field.height()});
  return {rows.begin(), rows.end()};
}

std::vector<double> coordinates_of_disks(const std::vector<PixelDisk>& disks) {
  std::vector<double> out;
  for (const PixelDisk& disk : disks) out.insert(out.end(), {disk.x, disk.y, disk.radius});
  return out;
}

}  // namespace

TEST_CASE("a field of disks has the opacity of painting without rounding") {
  Rng rng(20);
  constexpr int kWidth = 90;
  constexpr int kHeight = 70;
  for (const std::size_t count : {1U, 5U, 40U, 400U}) {
    for (const double opacity : {0.004, 0.1, 0.5, 1.0}) {
      const auto disks = random_disks(rng, count, kWidth, kHeight);
      DiskField field(kWidth, kHeight, opacity);
      field.add(disks);
      field.settle();
      INFO(count << " disks of opacity " << opacity);
      CHECK(difference_of_disks(field, disks, opacity) < 1e-3);
    }
  }
}

TEST_CASE("the field of disks that are far larger than the view is right") {
  // Their rims pass within a few pixels of the middle of the view.
  for (const double radius : {1e3, 1e5, 1e7, 1e9}) {
    for (const double turn : {0.0, 0.4, 1.6, 2.9, 4.0, 5.5}) {
      const double reach = radius + 3.25;
      const std::vector<PixelDisk> disks{{20.0 + reach * std::cos(turn), 15.0 + reach * std::sin(turn), radius}};
      DiskField field(40, 30, 0.5);
      field.add(disks);
      field.settle();
      INFO("radius " << radius << ", direction " << turn);
      CHECK(difference_of_disks(field, disks, 0.5) < 1e-3);
    }
  }
}

TEST_CASE("a field is a function of the set of disks") {
  Rng rng(21);
  constexpr int kWidth = 120;
  constexpr int kHeight = 95;
  for (const double opacity : {0.03, 1.0}) {
    auto disks = random_disks(rng, 300, kWidth, kHeight);
    DiskField once(kWidth, kHeight, opacity);
    once.add(disks);
    once.settle();

    // In another order, a few at a time, with others that go again.
    const auto others = random_disks(rng, 500, kWidth, kHeight);
    DiskField slowly(kWidth, kHeight, opacity);
    slowly.add(others);
    slowly.settle();
    std::ranges::reverse(disks);
    for (std::size_t i = 0; i < disks.size(); i += 3) {
      slowly.add(std::span(disks).subspan(i, std::min<std::size_t>(3, disks.size() - i)));
      if (i % 2 == 0) slowly.settle();
    }
    slowly.remove(others);
    slowly.settle();
    CHECK(opacities_of_disks(slowly) == opacities_of_disks(once));

    slowly.remove(disks);
    slowly.settle();
    CHECK(std::ranges::all_of(opacities_of_disks(slowly),
                              [](std::uint16_t opacity_there) { return opacity_there == 0; }));
  }
}

TEST_CASE("only bands of rows that changed are settled") {
  DiskField field(50, 160, 0.5);
  field.add(std::vector<PixelDisk>{{25.0, 80.0, 10.0}});
  const auto settled = field.settle();
  REQUIRE(settled.size() == 1);
  CHECK(settled[0].first <= 69);
  CHECK(settled[0].end >= 91);
  CHECK(settled[0].end - settled[0].first <= 3 * 16);
  CHECK(field.settle().empty());
  // Beside the view nothing changes.
  field.add(std::vector<PixelDisk>{{-30.0, 80.0, 10.0}, {25.0, 300.0, 100.0}});
  CHECK(field.settle().empty());
}

TEST_CASE("the scene draws the same picture by counting and by painting") {
  constexpr int kWidth = 200;
  constexpr int kHeight = 150;
  constexpr std::array kZooms{1.0, 0.37, 4.1};
  for (const bool is_flat : {false, true}) {
    LayerView view{.layer = 3, .style = {.color = {40, 120, 200}, .opacity = 0.3, .flat = is_flat}};
    const auto pictures = [&](double pixel_cost_ns, std::uint64_t masks) {
      Rng rng(22);
      Drawing drawing({.pixel_cost_ns = pixel_cost_ns, .instance_cost_ns = 0.0});
      drawing.set(3, PrimitiveKind::disk, coordinates_of_disks(random_disks(rng, 25, kWidth, kHeight)));
      std::vector<Image> out;
      for (const double zoom : kZooms) {
        Camera camera = pixel_camera(kWidth, kHeight);
        camera.zoom_at({71.0, 40.0}, zoom);
        out.push_back(drawing.draw(camera, {view}));
      }
      CHECK(drawing.device().counters().masks == masks);
      return out;
    };
    const auto painted = pictures(0.0, 0);
    const auto counted = pictures(1e9, kZooms.size());
    for (std::size_t i = 0; i < kZooms.size(); ++i) {
      INFO((is_flat ? "flat" : "blended") << " at zoom " << kZooms[i]);
      // Painting rounds to a grey level after each disk, of which some ten cover a pixel; counting rounds once.
      CHECK(largest_difference(painted[i], counted[i]) <= (is_flat ? 2 : 5));
      CHECK(covered_area(counted[i]) > 1000.0);
    }
  }
}

TEST_CASE("counted disks follow the edits of their layer") {
  Rng rng(23);
  constexpr int kWidth = 160;
  constexpr int kHeight = 100;
  Drawing edited({.pixel_cost_ns = 1e9});
  const LayerView view{.layer = 0, .style = {.color = {0, 0, 0}, .opacity = 0.2}};
  std::vector<PixelDisk> disks = random_disks(rng, 200, kWidth, kHeight);
  edited.set(0, PrimitiveKind::disk, coordinates_of_disks(disks));
  Camera camera = pixel_camera(kWidth, kHeight);
  for (int step = 0; step < 60; ++step) {
    // Some disks move, the last ones go, or new ones come.
    const auto count = static_cast<std::size_t>(rng.below(3) == 0 ? 120 + rng.below(100) : disks.size());
    const auto fresh = random_disks(rng, 240, kWidth, kHeight);
    std::vector<std::uint32_t> index;
    for (std::size_t i = disks.size(); i < count; ++i) index.push_back(static_cast<std::uint32_t>(i));
    disks.resize(count);
    const std::uint64_t moved = rng.below(2) == 0 ? rng.below(5) : rng.below(80);
    for (std::uint64_t i = 0; i < moved; ++i) index.push_back(static_cast<std::uint32_t>(rng.below(count)));
    std::vector<PixelDisk> written;
    for (std::size_t i = 0; i < index.size(); ++i) written.push_back(disks[index[i]] = fresh[i % fresh.size()]);
    edited.scene().apply(
        changes(0, PrimitiveKind::disk, static_cast<std::uint32_t>(count), index, coordinates_of_disks(written)));
    if (step % 3 == 1) continue;  // several patches before a picture
    if (step % 10 == 4) camera.pan({3.5, -1.25});
    if (step % 20 == 7) camera.set_viewport(kWidth - step, kHeight + step);

    edited.scene().forget(1);
    edited.set(1, PrimitiveKind::disk, coordinates_of_disks(disks));
    LayerView fresh_view = view;
    fresh_view.layer = 1;
    INFO("step " << step);
    REQUIRE(edited.draw(camera, {view}).rgba == edited.draw(camera, {fresh_view}).rgba);
  }
}

TEST_CASE("a preview of very many disks is a grey level off in the mean, and follows edits") {
  constexpr int kWidth = 400;
  constexpr int kHeight = 300;
  constexpr std::uint32_t kCount = 30000;
  // Balls along an axis, several hundred a pixel.
  const auto disk_at = [](std::uint32_t i) {
    const double t = 6.283185307179586 * i / kCount;
    return PixelDisk{200.0 + 100.0 * std::cos(t), 150.0 + 60.0 * std::sin(2.0 * t), 30.0 + 20.0 * std::cos(3.0 * t)};
  };
  std::vector<PixelDisk> disks;
  for (std::uint32_t i = 0; i < kCount; ++i) disks.push_back(disk_at(i));
  Drawing drawing({.pixel_cost_ns = 1e9});
  GlDevice& device = drawing.device();
  drawing.set(0, PrimitiveKind::disk, coordinates_of_disks(disks));
  const FramebufferId target = device.create_framebuffer({.width = kWidth, .height = kHeight});
  const PixelRect all{0, 0, kWidth, kHeight};
  const auto picture = [&](LayerIndex layer, Preview preview) {
    const LayerView view{.layer = layer, .style = {.color = {0, 0, 0}, .opacity = 0.002}};
    device.clear(target, all, {1.0F, 1.0F, 1.0F, 1.0F});
    drawing.scene().draw(pixel_camera(kWidth, kHeight), std::span(&view, 1), {.target = target, .preview = preview});
    return read_image(device, target, all);
  };
  const auto mean_difference = [](const Image& a, const Image& b) {
    double sum = 0.0;
    for (std::size_t i = 0; i < a.rgba.size(); ++i) sum += std::abs(int{a.rgba[i]} - int{b.rgba[i]});
    return sum / static_cast<double>(a.rgba.size());
  };
  const Image exact = picture(0, Preview::none);
  CHECK(covered_area(exact) > 1000.0);
  CHECK(mean_difference(exact, picture(0, Preview::fine)) <= 1.0);
  CHECK_FALSE(drawing.scene().is_coarse());
  CHECK(mean_difference(exact, picture(0, Preview::coarse)) <= 1.0);
  CHECK(drawing.scene().is_coarse());

  for (const Preview preview : {Preview::fine, Preview::coarse, Preview::none}) {
    static_cast<void>(picture(0, preview));
    const std::vector<std::uint32_t> moved{3, 9000, kCount - 2};
    std::vector<PixelDisk> written;
    for (const std::uint32_t i : moved) {
      disks[i].x += 7.3;
      written.push_back(disks[i]);
    }
    drawing.scene().apply(changes(0, PrimitiveKind::disk, kCount, moved, coordinates_of_disks(written)));
    drawing.set(1, PrimitiveKind::disk, coordinates_of_disks(disks));
    CHECK(picture(0, preview).rgba == picture(1, preview).rgba);
  }
  device.destroy_framebuffer(target);
}

TEST_CASE("an edit of counted disks uploads the rows that it changes") {
  RecordingDevice device;
  device.set_pixel_cost_ns(1e6);
  Scene scene(device);
  const FramebufferId target = device.create_framebuffer({.width = 800, .height = 800});
  const LayerView view{.layer = 0, .style = {.opacity = 0.5}};
  std::vector<double> many;
  for (int i = 0; i < 1000; ++i) many.insert(many.end(), {0.8 * i, 799.0 - 0.8 * i, 20.0});
  scene.apply(instances(0, PrimitiveKind::disk, many));
  const Camera camera = pixel_camera(800, 800);
  const auto rows_of_frame = [&] {
    const std::uint64_t before = device.counters().mask_rows;
    scene.draw(camera, std::span(&view, 1), {.target = target});
    return device.counters().mask_rows - before;
  };
  CHECK(rows_of_frame() == 800);
  CHECK(rows_of_frame() == 0);
  scene.apply(changes(0, PrimitiveKind::disk, 1000, {500}, {402.0, 399.0, 21.0}));
  const std::uint64_t rows = rows_of_frame();
  CHECK(rows >= 42);
  CHECK(rows <= 80);
  // A layer that is forgotten keeps no mask.
  const std::size_t textures = device.textures_alive();
  scene.forget(0);
  CHECK(device.textures_alive() == textures - 1);
  device.destroy_framebuffer(target);
}

TEST_CASE("disks are counted only where that takes less time") {
  RecordingDevice device;
  const auto buffer_of = [&](std::size_t count, double radius) {
    std::vector<double> data;
    for (std::size_t i = 0; i < count; ++i) data.insert(data.end(), {400.0, 300.0, radius, 0.0});
    InstanceBuffer buffer(device, PrimitiveKind::disk);
    buffer.replace(static_cast<std::uint32_t>(count), data, {}, false);
    return buffer;
  };
  const PixelFrame frame{.center_x = 400.0, .center_y = 300.0, .width = 800, .height = 600};
  const InstanceBuffer few = buffer_of(3, 5.0);
  const InstanceBuffer many = buffer_of(5000, 200.0);
  PixelFrame away = frame;
  away.center_x = 5000.0;
  // A processor that paints.
  device.set_pixel_cost_ns(3.0);
  CHECK_FALSE(CountedInstances::is_cheaper(few, frame, device));
  CHECK(CountedInstances::is_cheaper(many, frame, device));
  CHECK_FALSE(CountedInstances::is_cheaper(many, away, device));
  device.set_pixel_cost_ns(0.0);
  CHECK_FALSE(CountedInstances::is_cheaper(many, frame, device));
}
