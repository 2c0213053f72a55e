// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

#include "app/editing/curves/sample_spacing.h"
#include "app/editing/editor.h"
#include "app/layers/layer_stack.h"
#include "core/base/rng.h"
#include "core/document/commands.h"
#include "tests/support/builtin_layers.h"

using namespace mes;

namespace {

const LayerDescriptor& descriptor_of(std::string_view id) {
  return layer_descriptors()[find_layer(id)];
}

}  // namespace

TEST_CASE("below two pixels points and lines become finer, down to a fifth, and never thicker") {
  const LayerDescriptor& points = descriptor_of("points");
  LayerStyle style{.point_size_px = 8.0, .line_width_px = 4.0};
  CHECK(thinned(style, points, 2.0) == style);
  CHECK(thinned(style, points, 0.0) == style);  // not known
  CHECK(thinned(style, points, 1.0).point_size_px == 4.0);
  CHECK(thinned(style, points, 1.0).line_width_px == 2.0);
  CHECK(thinned(style, points, 1e-9).point_size_px == Approx(0.2 * 8.0));
  style.point_size_px = 0.5;
  style.line_width_px = 0.1;
  CHECK(thinned(style, points, 0.01) == style);
}

TEST_CASE("a style can refuse, and layers that are not made of samples stay as they are") {
  LayerStyle style{.point_size_px = 8.0, .line_width_px = 4.0};
  CHECK(thinned(style, descriptor_of("b-inner-circles"), 0.1) == style);
  CHECK(thinned(style, descriptor_of("image"), 0.1) == style);
  CHECK_FALSE(thinned(style, descriptor_of("curve"), 0.1) == style);
  style.thin_when_dense = false;
  CHECK(thinned(style, descriptor_of("curve"), 0.1) == style);
}

TEST_CASE("the refusal is a step of undo as every change of a style") {
  LayerStack layers(layer_descriptors());
  Editor editor({}, &layers);
  const LayerIndex curve = find_layer("curve");
  LayerStyle style = layers.style(curve);
  REQUIRE(style.thin_when_dense);
  style.thin_when_dense = false;
  editor.change_layers("Style of Curve", [&] { layers.set_style(curve, style); });
  REQUIRE(editor.can_undo());
  editor.undo();
  CHECK(layers.style(curve).thin_when_dense);
  editor.redo();
  CHECK_FALSE(layers.style(curve).thin_when_dense);
}

TEST_CASE("dots of samples that have their default size are kept apart") {
  const LayerDescriptor& points = descriptor_of("points");
  LayerStyle style = points.style;
  const auto drawn = [&](double spacing_px) { return thinned(style, points, spacing_px).point_size_px; };
  CHECK(drawn(style.point_size_px / 0.7) == Approx(style.point_size_px));
  CHECK(drawn(4.0) == Approx(2.8));
  CHECK(drawn(2.1) == 1.5);
  CHECK(drawn(1e-9) == 1.0);
  double before = 0.0;
  for (double spacing = 0.01; spacing < 20.0; spacing *= 1.1) {
    CHECK(drawn(spacing) >= before);
    CHECK(drawn(spacing) <= style.point_size_px);
    before = drawn(spacing);
  }
  style.point_size_px += 0.5;
  CHECK(drawn(4.0) == style.point_size_px);
  // Other dots remain larger; marks of single places, and layers with more than dots, stay as they are.
  const LayerDescriptor& v_points = descriptor_of("a-v-points");
  CHECK(thinned(v_points.style, v_points, 4.0).point_size_px == Approx(2.8));
  CHECK(thinned(v_points.style, v_points, 2.1).point_size_px == 2.5);
  for (const char* id : {"theorem-check", "axis-nodes", "curve-defects"}) {
    const LayerDescriptor& others = descriptor_of(id);
    CHECK(thinned(others.style, others, 4.0) == others.style);
  }
}

namespace {

Document document_of(std::vector<Vec2> places) {
  Document out;
  out.apply(*replace_all(out, {.positions = std::move(places)}));
  return out;
}

/// The distance of each place to the nearest other one, increasing, by its definition.
std::vector<double> nearest_of_all(const std::vector<Vec2>& places) {
  std::vector<double> out;
  for (const Vec2 p : places) {
    double nearest = std::numeric_limits<double>::infinity();
    for (const Vec2 q : places)
      if (p != q) nearest = std::min(nearest, distance(p, q));
    out.push_back(nearest);
  }
  std::ranges::sort(out);
  return out;
}

}  // namespace

TEST_CASE("the spacing is the median of distances to the nearest other place, wherever and however many") {
  for (const double scale : {1e-9, 1.0, 1e12}) {
    std::vector<Vec2> grid;
    for (int i = 0; i < 900; ++i) grid.push_back({scale * (i % 30 + 1000.0), scale * (i / 30)});
    CHECK(typical_spacing(document_of(grid)) == Approx(scale));
  }
  CHECK(typical_spacing(Document()) == 0.0);
  CHECK(typical_spacing(document_of({{1, 1}})) == 0.0);
  CHECK(typical_spacing(document_of({{1, 1}, {1, 1}})) == 0.0);
  CHECK(typical_spacing(document_of({{-0.0, 1}, {0.0, 1}, {3, 5}})) == 5.0);
  Rng rng(5);
  for (const std::size_t count : {2U, 3U, 50U, 200U, 201U, 3000U}) {
    // Noise, a curve, and a cluster with one place far away.
    for (int kind = 0; kind < 3; ++kind) {
      std::vector<Vec2> places;
      while (places.size() < count) {
        const double t = rng.uniform(0.0, 6.28);
        if (kind == 0) places.push_back({rng.uniform(5.0, 6.0), rng.uniform()});
        if (kind == 1) places.push_back({std::cos(t), 0.1 * std::sin(3.0 * t)});
        if (kind == 2) places.push_back({1e-6 * rng.uniform(), places.empty() ? 1e6 : 1e-6 * rng.uniform()});
      }
      INFO(count << " places of kind " << kind);
      const std::vector<double> nearest = nearest_of_all(places);
      const double spacing = typical_spacing(document_of(places));
      if (count <= 200) {
        CHECK(spacing == nearest[count / 2]);
      } else {
        CHECK(std::ranges::binary_search(nearest, spacing));
        CHECK(spacing > nearest[count / 3]);
        CHECK(spacing < nearest[2 * count / 3]);
      }
    }
  }
}

TEST_CASE("the spacing depends on the places in the order of input, however the document came to them") {
  Rng rng(6);
  std::vector<Vec2> places;
  for (int i = 0; i < 1500; ++i) places.push_back({rng.uniform(), rng.uniform()});
  const double spacing = typical_spacing(document_of(places));
  Document edited = document_of({places.begin(), places.begin() + 1000});
  std::vector<SampleId> taken;
  for (std::size_t i = 600; i < 1000; ++i) taken.push_back(edited.id(SampleSlot(i)));
  edited.apply(*remove_samples(edited, taken));
  CHECK(typical_spacing(edited) != spacing);
  // Rows of samples that went are given to those that come, in another order.
  edited.apply(*insert_samples(edited, std::span(places).subspan(600)));
  CHECK(typical_spacing(edited) == spacing);
}

TEST_CASE("the spacing changes as little as the samples move, and where places are there often, too") {
  Rng rng(8);
  std::vector<Vec2> places;
  for (int i = 0; i < 3000; ++i) places.push_back({rng.uniform(), rng.uniform()});
  const double spacing = typical_spacing(document_of(places));
  std::vector<Vec2> moved = places;
  for (Vec2& p : moved) p = p + Vec2{1e-9, 1e-9};
  CHECK(typical_spacing(document_of(moved)) == Approx(spacing).epsilon(1e-5));
  for (Vec2& p : moved) p = p + 0.02 * spacing * Vec2{rng.uniform(-1.0, 1.0), rng.uniform(-1.0, 1.0)};
  CHECK(typical_spacing(document_of(moved)) == Approx(spacing).epsilon(0.06));
  std::vector<Vec2> often = places;
  for (int i = 0; i < 100; ++i) often.insert(often.end(), places.begin(), places.begin() + 300);
  const std::vector<double> nearest = nearest_of_all(places);
  const double of_often = typical_spacing(document_of(often));
  CHECK(of_often > nearest[places.size() / 3]);
  CHECK(of_often < nearest[2 * places.size() / 3]);
}

TEST_CASE(
    "the spacing of a document follows each edit of few samples, and of many those that change much or come to "
    "rest") {
  FollowedSpacing followed;
  Document document = document_of({{0, 0}, {1, 0}, {5, 0}});
  CHECK(followed.of(document) == 1.0);
  document.apply(*move_samples(document, std::vector{std::pair(document.id(SampleSlot(1U)), Vec2{0.25, 0.0})}));
  CHECK(followed.of(document) == typical_spacing(document));
  std::vector<Vec2> many;
  for (int i = 0; i <= static_cast<int>(FollowedSpacing::kAlwaysMeasured); ++i) many.push_back({0.0 + i, 0.0});
  CHECK(followed.of(document_of(many)) == 1.0);
  for (Vec2& p : many) p.x *= 2.0;
  CHECK(followed.of(document_of(many)) == 2.0);
  // Neither their number nor their magnitude tells, but that they are another document's.
  for (std::size_t i = 1; i < many.size() - 1; ++i) many[i].x = 1e-3 * static_cast<double>(i);
  const Document changed = document_of(many);
  CHECK(followed.of(changed, 0) == 2.0);
  CHECK(followed.of(changed, 0) == Approx(1e-3));  // it has come to rest
  FollowedSpacing other;
  CHECK(other.of(document_of(std::vector<Vec2>(many.size(), Vec2{1.0, 1.0})), 0) == 0.0);
  CHECK(other.of(changed, 1) == Approx(1e-3));
}
