// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/draw/layer_mirror.h"

#include <catch2/catch.hpp>
#include <limits>

#include "core/base/assert.h"

using namespace mes;

namespace {

constexpr LayerIndex kLayer = 2;

KindPatch reset_with(std::uint32_t count, std::vector<double> data) {
  KindPatch patch;
  patch.reset = true;
  patch.count = count;
  patch.data = std::move(data);
  return patch;
}

KindPatch change(std::uint32_t count, std::vector<std::uint32_t> index, std::vector<double> data) {
  KindPatch patch;
  patch.count = count;
  patch.count_changed = true;
  patch.index = std::move(index);
  patch.data = std::move(data);
  return patch;
}

FramePatch frame_of(PrimitiveKind kind, KindPatch patch) {
  FramePatch frame;
  LayerPatch layer;
  layer.layer = kLayer;
  layer[kind] = std::move(patch);
  frame.layers.push_back(std::move(layer));
  frame.layer_count = 1;
  return frame;
}

std::vector<double> points_of(const LayerMirror& mirror) {
  const auto values = mirror.instances(kLayer, PrimitiveKind::point);
  return {values.begin(), values.end()};
}

}  // namespace

TEST_CASE("instances are what the patches say, one after the other") {
  LayerMirror mirror;
  CHECK(mirror.count(kLayer, PrimitiveKind::point) == 0);
  mirror.apply(frame_of(PrimitiveKind::point, reset_with(2, {1, 2, 0, 3, 4, 0})));
  CHECK(mirror.count(kLayer, PrimitiveKind::point) == 2);
  // Growth in any order; a place named twice keeps the later value.
  mirror.apply(frame_of(PrimitiveKind::point, change(4, {3, 2, 0, 3}, {7, 8, 0, 5, 6, 0, 1, 1, 1, 9, 9, 9})));
  CHECK(points_of(mirror) == std::vector<double>{1, 1, 1, 3, 4, 0, 5, 6, 0, 9, 9, 9});
  mirror.apply(frame_of(PrimitiveKind::point, change(1, {}, {})));
  CHECK(points_of(mirror) == std::vector<double>{1, 1, 1});
  mirror.apply(frame_of(PrimitiveKind::point, reset_with(0, {})));
  CHECK(points_of(mirror).empty());
  CHECK(mirror.count(kLayer + 5, PrimitiveKind::disk) == 0);
}

TEST_CASE("spare entries of a patch are not read") {
  FramePatch frame = frame_of(PrimitiveKind::point, reset_with(1, {1, 2, 3}));
  frame.layer_count = 0;
  LayerMirror mirror;
  mirror.apply(frame);
  CHECK(mirror.count(kLayer, PrimitiveKind::point) == 0);
}

TEST_CASE("a patch that breaks its promises is refused") {
  constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  const auto refused = [](PrimitiveKind kind, KindPatch patch) {
    LayerMirror mirror;
    CHECK_THROWS_AS(mirror.apply(frame_of(kind, std::move(patch))), AssertionFailure);
  };
  refused(PrimitiveKind::point, reset_with(2, {1, 2, 3}));
  refused(PrimitiveKind::point, reset_with(1, {1, kNan, 3}));
  refused(PrimitiveKind::point, reset_with(1, {1, 2, kInfinity}));
  refused(PrimitiveKind::disk, reset_with(1, {1, 2, -1, 0}));
  refused(PrimitiveKind::ray, reset_with(1, {1, 2, 0, 0, 0}));
  refused(PrimitiveKind::line, reset_with(1, {1, 2, 0, 0, 0}));
  refused(PrimitiveKind::point, change(1, {1}, {1, 2, 3}));
  refused(PrimitiveKind::point, change(2, {0}, {1, 2, 3}));
  refused(PrimitiveKind::point, change(2, {0, 0}, {1, 2, 3, 1, 2, 3}));
  refused(PrimitiveKind::point, change(1, {0}, {1, 2}));
  KindPatch unsaid;
  unsaid.count = 3;
  refused(PrimitiveKind::point, unsaid);
}

TEST_CASE("the digest is that of the instances, however they came") {
  const auto digest_of = [](const std::vector<double>& points) {
    LayerMirror mirror;
    mirror.apply(frame_of(PrimitiveKind::point, reset_with(static_cast<std::uint32_t>(points.size() / 3), points)));
    return mirror.digest(kLayer);
  };
  LayerMirror mirror;
  CHECK(mirror.digest(kLayer) == LayerDigest{});
  const auto follow = [&](KindPatch patch) {
    mirror.apply(frame_of(PrimitiveKind::point, std::move(patch)));
    CHECK(mirror.digest(kLayer) == digest_of(points_of(mirror)));
  };
  follow(reset_with(2, {1, 2, 0, 3, 4, 0}));
  follow(change(4, {3, 2, 0, 3}, {7, 8, 0, 5, 6, 0, 1, 1, 1, 9, 9, 9}));
  CHECK(mirror.digest(kLayer) == digest_of({9, 9, 9, 5, 6, 0, 3, 4, 0, 1, 1, 1}));
  follow(change(4, {1, 1}, {2, 2, 2, 3, 3, 3}));
  follow(change(2, {0, 3}, {4, 4, 4, 5, 5, 5}));
  follow(change(1, {}, {}));
  follow(reset_with(0, {}));
  CHECK(mirror.digest(kLayer) == LayerDigest{});
}
