// SPDX-License-Identifier: GPL-3.0-or-later
// Instances in blocks whose boxes are out of view are left out, and no pixel tells.
#include <algorithm>
#include <array>
#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>
#include <numeric>

#include "core/base/rng.h"
#include "render/device/recording_device.h"
#include "render/instances/block_boxes.h"
#include "tests/render/drawing.h"

using namespace mes;
using namespace mes::test;
using render::BlockBoxes;
using render::Camera;
using render::LayerView;

namespace {

using enum PrimitiveKind;

constexpr int kSide = 100;  // cells a side
constexpr double kCell = 60.0;
constexpr std::size_t kCount = std::size_t{kSide} * kSide;

/// An instance that stays within its cell, so that none blends with another and the order does not matter.
std::vector<double> in_cell(PrimitiveKind kind, std::size_t cell, Rng& rng) {
  const Vec2 c{kCell * (static_cast<double>(cell % kSide) + 0.5), kCell * (static_cast<double>(cell / kSide) + 0.5)};
  const auto near = [&] { return c + Vec2{rng.uniform(-9.0, 9.0), rng.uniform(-9.0, 9.0)}; };
  const Vec2 a = near();
  const Vec2 b = near();
  const Vec2 d = near();
  const double r = rng.uniform(1.0, 10.0);
  const auto at = [&](double angle) { return c + r * Vec2{std::cos(angle), std::sin(angle)}; };
  const Vec2 from = at(rng.uniform(0.0, 2.0 * std::numbers::pi));
  const Vec2 to = at(rng.uniform(0.0, 2.0 * std::numbers::pi));
  switch (kind) {
    case point: return {a.x, a.y};
    case disk:
    case circle: return {c.x, c.y, r};
    case segment: return {a.x, a.y, b.x, b.y};
    case triangle:
    case parabola: return {a.x, a.y, b.x, b.y, d.x, d.y};
    case arc: return {c.x, c.y, r, from.x, from.y, to.x, to.y};
    default: return {};
  }
}

/// The instances in the order given.
std::vector<double> in_order(const std::vector<std::vector<double>>& all, const std::vector<std::uint32_t>& order) {
  std::vector<double> out;
  for (const std::uint32_t i : order) out.insert(out.end(), all[i].begin(), all[i].end());
  return out;
}

std::vector<std::uint32_t> row_by_row() {
  std::vector<std::uint32_t> out(kCount);
  std::iota(out.begin(), out.end(), 0U);
  return out;
}

/// Then each block of instances is all over the plane, and none is left out.
std::vector<std::uint32_t> shuffled(Rng& rng) {
  std::vector<std::uint32_t> out = row_by_row();
  for (std::size_t i = out.size() - 1; i > 0; --i) std::swap(out[i], out[rng.below(i + 1)]);
  return out;
}

constexpr std::array kBounded{point, disk, circle, segment, triangle, arc, parabola};

}  // namespace

TEST_CASE("a picture is the same whether blocks out of view are drawn or not") {
  Drawing drawing({.pixel_cost_ns = 0.0, .instance_cost_ns = 0.0});
  Rng rng(21);
  const std::vector<std::uint32_t> ordered = row_by_row();
  const std::vector<std::uint32_t> mixed = shuffled(rng);
  for (const PrimitiveKind kind : kBounded) {
    std::vector<std::vector<double>> all;
    for (std::size_t i = 0; i < kCount; ++i) all.push_back(in_cell(kind, i, rng));
    drawing.set(0, kind, in_order(all, ordered));
    drawing.set(1, kind, in_order(all, mixed));
    const auto compare = [&](int times) {
      for (int i = 0; i < times; ++i) {
        LayerView view{.layer = 0, .style = {.color = {200, 40, 90}, .opacity = 0.6}};
        view.style.line_width_px = rng.uniform(0.2, 9.0);
        view.style.point_size_px = rng.uniform(0.5, 14.0);
        view.style.dashed = i % 4 == 3;
        Camera camera = pixel_camera(150, 90);
        const double extent = kSide * kCell;
        const double scale = std::exp(rng.uniform(std::log(0.05), std::log(1.5)));
        Vec2 center{rng.uniform(-0.1, 1.1) * extent, rng.uniform(-0.1, 1.1) * extent};
        if (i % 2 == 0) {
          // The last instances of a block are cut by the lower edge of the view, or just below it.
          const std::size_t last = (1 + rng.below(3)) * BlockBoxes::kBlock - 1;
          const double row = kCell * (static_cast<double>(last / kSide) + 0.5);
          center = {kCell * static_cast<double>(last % kSide) - rng.uniform(0.0, 60.0) * scale,
                    row + 45.0 * scale + rng.uniform(-12.0, 12.0) * std::max(1.0, scale)};
        }
        camera.look_at(center, scale);
        const auto seen = drawing.draw(camera, {view});
        view.layer = 1;
        CAPTURE(static_cast<int>(kind), i);
        REQUIRE(seen == drawing.draw(camera, {view}));
      }
    };
    compare(40);
    // After edits, some of which bring an instance to the other end of the plane.
    std::vector<std::uint32_t> index;
    std::vector<std::uint32_t> mixed_index;
    std::vector<double> data;
    for (std::uint32_t i = 0; i < 30; ++i) {
      const auto a = static_cast<std::uint32_t>(rng.below(kCount));
      const auto b = static_cast<std::uint32_t>(rng.below(kCount));
      if (std::ranges::count(index, a) + std::ranges::count(index, b) != 0 || a == b) continue;
      std::swap(all[a], all[b]);
      for (const std::uint32_t changed : {a, b}) {
        index.push_back(changed);
        mixed_index.push_back(static_cast<std::uint32_t>(std::ranges::find(mixed, changed) - mixed.begin()));
        data.insert(data.end(), all[changed].begin(), all[changed].end());
      }
    }
    drawing.scene().apply(changes(0, kind, kCount, index, data));
    drawing.scene().apply(changes(1, kind, kCount, mixed_index, data));
    compare(20);
  }
}

TEST_CASE("a view of a hundredth draws little more than it shows") {
  Rng rng(22);
  for (const PrimitiveKind kind : kBounded) {
    render::RecordingDevice device;
    render::Scene scene(device);
    std::vector<double> data;
    for (std::size_t i = 0; i < kCount; ++i) {
      const std::vector<double> one = in_cell(kind, i, rng);
      data.insert(data.end(), one.begin(), one.end());
    }
    scene.apply(instances(0, kind, data));
    const LayerView view{.layer = 0, .style = {}};
    const auto drawn = [&](Vec2 center, double units_per_pixel) {
      Camera camera = pixel_camera(600, 600);
      camera.look_at(center, units_per_pixel);
      const std::uint64_t before = device.counters().instances_drawn;
      scene.draw(camera, std::span(&view, 1), {});
      return device.counters().instances_drawn - before;
    };
    CAPTURE(static_cast<int>(kind));
    CHECK(drawn({3000.0, 3000.0}, 10.0) == kCount);
    // Blocks are some twenty rows of cells.
    const std::uint64_t near = drawn({300.0, 300.0}, 1.0);
    CHECK(near >= 100);
    CHECK(near <= BlockBoxes::kBlock);
    CHECK(drawn({-900.0, 300.0}, 1.0) == 0);
  }
}

TEST_CASE("what has no end is always drawn") {
  for (const PrimitiveKind kind : {ray, line}) {
    render::RecordingDevice device;
    render::Scene scene(device);
    scene.apply(instances(0, kind, {0.0, 0.0, 1.0, 0.0}));
    Camera camera = pixel_camera(100, 100);
    camera.look_at({1e6, 0.0}, 1.0);
    const LayerView view{.layer = 0, .style = {}};
    scene.draw(camera, std::span(&view, 1), {});
    CHECK(device.counters().instances_drawn == 1);
  }
}

TEST_CASE("runs of blocks hold all instances that meet the view, in order") {
  Rng rng(23);
  for (int round = 0; round < 200; ++round) {
    BlockBoxes boxes;
    const auto count = static_cast<std::uint32_t>(1 + rng.below(9 * BlockBoxes::kBlock));
    std::vector<Vec2> at;
    for (std::uint32_t i = 0; i < count; ++i) {
      at.push_back({static_cast<double>(i / BlockBoxes::kBlock) + rng.uniform(), rng.uniform()});
      boxes.add(i, {at.back(), at.back()});
    }
    const double low = rng.uniform(-1.0, 10.0);
    const Box2 view{{low, 0.25}, {low + rng.uniform(0.0, 3.0), 0.75}};
    std::vector<bool> is_drawn(count, false);
    std::uint32_t end = 0;
    for (const BlockBoxes::Run run : boxes.runs(count, view)) {
      REQUIRE(run.count > 0);
      REQUIRE(run.first >= end);
      end = run.first + run.count;
      REQUIRE(end <= count);
      std::fill(is_drawn.begin() + run.first, is_drawn.begin() + end, true);
    }
    for (std::uint32_t i = 0; i < count; ++i)
      if (view.contains(at[i])) REQUIRE(is_drawn[i]);
  }
}
