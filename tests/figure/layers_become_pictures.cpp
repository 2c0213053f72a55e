// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <cstdlib>

#include "layers_of_a_test.h"
#include "render/figure/raster.h"
#include "render/figure/writers.h"

using namespace mes;
using namespace mes::figure;
using test::Layers;

namespace {

Rgb color_at(const render::Image& image, int x, int y) {
  const std::uint8_t* const at = &image.rgba[image.offset(x, y)];
  return {at[0], at[1], at[2]};
}

int alpha_at(const render::Image& image, int x, int y) {
  return image.rgba[image.offset(x, y) + 3];
}

/// Grey levels, over all channels.
double mean_difference(const render::Image& a, const render::Image& b) {
  REQUIRE(a.width == b.width);
  REQUIRE(a.height == b.height);
  double sum = 0.0;
  for (std::size_t i = 0; i < a.rgba.size(); ++i) sum += std::abs(int{a.rgba[i]} - int{b.rgba[i]});
  return sum / static_cast<double>(a.rgba.size());
}

Layers two_layers() {
  Layers layers;
  layers.add(0, PrimitiveKind::disk, {50, 50, 20, 0, 60, 55, 20, 0});
  layers.show(0).opacity = 0.5;
  layers.add(2, PrimitiveKind::segment, {10, 10, 190, 90, 0});
  layers.show(2).line_width_px = 2.0;
  return layers;
}

}  // namespace

TEST_CASE("a picture of a figure has its colours, its opacities, and nothing where nothing is") {
  Layers layers;
  layers.add(0, PrimitiveKind::disk, {50, 50, 20, 0});
  LayerStyle& style = layers.show(0);
  style.color = {200, 100, 50};
  style.opacity = 0.5;
  const auto picture = picture_of(layers.figure(), 2.0);
  REQUIRE(picture);
  CHECK(picture->width == 400);
  CHECK(picture->height == 200);
  CHECK(alpha_at(*picture, 100, 100) == 128);
  const Rgb inside = color_at(*picture, 100, 100);
  CHECK(std::abs(inside.r - 200) <= 1);
  CHECK(std::abs(inside.g - 100) <= 1);
  CHECK(std::abs(inside.b - 50) <= 1);
  CHECK(alpha_at(*picture, 100, 100 - 38) == 128);
  CHECK(alpha_at(*picture, 100, 100 - 42) == 0);
}

TEST_CASE("text keeps to the width that its layout measured, and dots are painted above boxes") {
  Figure figure;
  figure.width = 200.0;
  figure.height = 100.0;
  constexpr double kWidth = 40.0;
  figure.legend.texts.push_back({{10.0, 50.0}, 20.0, kWidth, false, {0, 0, 0}, "MMMMMMMMMM"});
  figure.legend.boxes.push_back({{100.0, 20.0}, 40.0, 40.0, {0, 0, 255}});
  Run red{.color = {255, 0, 0}, .opacity = 1.0, .is_filled = true, .dashes = {}, .shapes = {}};
  red.shapes.push_back({.kind = ShapeKind::disk, .p = {Vec2{120.0, 40.0}}, .radius = 10.0, .sweep = 0.0});
  figure.legend.runs.push_back(red);
  const auto picture = picture_of(figure, 1.0);
  REQUIRE(picture);
  int last = 0;
  for (int y = 0; y < 100; ++y)
    for (int x = 0; x < 95; ++x)
      if (alpha_at(*picture, x, y) > 0) last = std::max(last, x);
  CHECK(last > 10 + static_cast<int>(kWidth) - 6);
  CHECK(last <= 10 + static_cast<int>(kWidth));
  CHECK(color_at(*picture, 120, 40) == Rgb{255, 0, 0});
  CHECK(color_at(*picture, 105, 25) == Rgb{0, 0, 255});
}

TEST_CASE("a layer becomes a picture of what it showed, and the others stay as they are") {
  const Figure whole = two_layers().figure();
  Figure mixed = whole;
  REQUIRE(rasterize_layers(mixed, std::vector<std::string>{whole.layers[0].id, "unknown"}, 4 * kPointsPerInch));
  REQUIRE(mixed.layers[0].image);
  CHECK(shape_count(mixed.layers[0]) == 0);
  CHECK(shape_count(mixed.layers[1]) == shape_count(whole.layers[1]));
  CHECK_FALSE(mixed.layers[1].image);
  // No larger than the two disks, from 30 to 80 and from 25 to 70 points.
  CHECK(mixed.layers[0].image->corner == Vec2{30, 25});
  CHECK(mixed.layers[0].image->image.width == 200);
  CHECK(mixed.layers[0].image->image.height == 180);
  const auto a = picture_of(whole, 4.0);
  const auto b = picture_of(mixed, 4.0);
  REQUIRE(a);
  REQUIRE(b);
  CHECK(mean_difference(*a, *b) < 0.05);
  const auto svg = svg_of(mixed);
  REQUIRE(svg);
  CHECK(test::count_of(*svg, "<image") == 1);
  // Ipe counts from the lower left corner of the page, which is 100 high.
  const auto ipe = ipe_of(mixed);
  REQUIRE(ipe);
  CHECK(test::count_of(*ipe,
                       "<image rect=\"30 30 80 75\" width=\"200\" height=\"180\" "
                       "ColorSpace=\"DeviceRGBAlpha\"") == 1);
  CHECK(test::count_of(*ipe, "</image>") == 1);
}

TEST_CASE("a layer cut by the edge of the page is a picture of what lies on it; one beyond it stays empty") {
  Layers layers;
  layers.add(0, PrimitiveKind::disk, {0, 50, 20, 0});
  layers.show(0);
  Figure figure = layers.figure();
  REQUIRE(rasterize_layers(figure, std::vector<std::string>{figure.layers[0].id}, kPointsPerInch));
  REQUIRE(figure.layers[0].image);
  CHECK(figure.layers[0].image->corner == Vec2{0, 30});
  CHECK(figure.layers[0].image->width == 20.0);
  Figure empty{.width = 10.0, .height = 10.0, .layers = {{.id = "none", .title = "None"}}};
  REQUIRE(rasterize_layers(empty, std::vector<std::string>{"none"}, 300.0));
  CHECK_FALSE(empty.layers[0].image);
}

TEST_CASE("texts of a layer that becomes a picture stay text") {
  Figure figure = two_layers().figure();
  const Text text{.start = {100.0, 20.0}, .size = 10.0, .width = 30.0, .text = "text"};
  figure.layers[0].texts.push_back(text);
  figure.layers.push_back({.id = "notes", .title = "Notes", .texts = {text}});
  REQUIRE(rasterize_layers(figure, std::vector<std::string>{figure.layers[0].id, "notes"}, 4 * kPointsPerInch));
  REQUIRE(figure.layers[0].image);
  CHECK(figure.layers[0].image->image.width == 200);
  CHECK(figure.layers[0].texts.size() == 1);
  CHECK_FALSE(figure.layers.back().image);
  CHECK(figure.layers.back().texts.size() == 1);
}

TEST_CASE("a picture that no memory holds is refused, and the figure stays as it was") {
  Figure figure = two_layers().figure();
  const auto refused = rasterize_layers(figure, std::vector<std::string>{figure.layers[1].id}, 1e6);
  REQUIRE_FALSE(refused);
  CHECK(refused.error().code == ErrorCode::usage);
  CHECK(shape_count(figure) == shape_count(two_layers().figure()));
  CHECK_FALSE(picture_of(figure, 1e9));
}

TEST_CASE("PostScript makes one picture of a layer of many translucent shapes, and leaves other layers as they are") {
  Layers layers;
  std::vector<double> disks;
  for (int i = 0; i < 1500; ++i) disks.insert(disks.end(), {2.0 + 4.0 * (i % 48), 2.0 + 3.0 * (i / 48), 2.5, 0.0});
  layers.add(0, PrimitiveKind::disk, disks);
  layers.show(0).opacity = 0.5;
  layers.add(2, PrimitiveKind::segment, {10, 98, 190, 98, 0});
  layers.show(2).line_width_px = 2.0;
  const Figure figure = layers.figure();
  REQUIRE(shape_count(figure) == 1501);
  const auto eps = eps_of(figure);
  REQUIRE(eps);
  CHECK(test::count_of(*eps, "/ImageType") == 1);
  // The line of the other layer.
  CHECK(test::count_of(*eps, " l S") + test::count_of(*eps, " l\nS") >= 1);
}
