// SPDX-License-Identifier: GPL-3.0-or-later
#include <catch2/catch.hpp>

#include "app/model/editor.h"
#include "app/model/layer_stack.h"
#include "app/model/sample_spacing.h"

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

TEST_CASE("the spacing is that of neighbours elsewhere, wherever and however many") {
  for (const double scale : {1e-9, 1.0, 1e12}) {
    Editor editor({});
    SampleData data;
    for (int i = 0; i < 900; ++i) data.positions.push_back({scale * (i % 30 + 1000.0), scale * (i / 30)});
    REQUIRE(editor.load(data));
    CHECK(typical_spacing(editor.document(), editor.index()) == Approx(scale));
  }
  Editor one({});
  SampleData data;
  data.positions = {{1, 1}};
  REQUIRE(one.load(data));
  CHECK(typical_spacing(one.document(), one.index()) == 0.0);
}
