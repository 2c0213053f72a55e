// SPDX-License-Identifier: GPL-3.0-or-later
#include <catch2/catch.hpp>
#include <cmath>

#include "app/picture/paper/canvas_look.h"
#include "tests/support/builtin_layers.h"

using namespace mes;

namespace {

// WCAG 2.2, contrast ratio.
double contrast(Rgb a, Rgb b) {
  const auto luminance = [](Rgb color) {
    const auto linear = [](int channel) {
      const double value = channel / 255.0;
      return value <= 0.04045 ? value / 12.92 : std::pow((value + 0.055) / 1.055, 2.4);
    };
    return 0.2126 * linear(color.r) + 0.7152 * linear(color.g) + 0.0722 * linear(color.b);
  };
  const double x = luminance(a) + 0.05;
  const double y = luminance(b) + 0.05;
  return x > y ? x / y : y / x;
}

Rgb color_drawn(Rgb color, const std::optional<Rgb>& background) {
  LayerStyle style;
  style.color = color;
  return drawn_on(style, background).color;
}

}  // namespace

TEST_CASE("every layer is seen on the dark canvases as it comes") {
  for (const LayerDescriptor& layer : layer_descriptors()) {
    CAPTURE(layer.id);
    CHECK(contrast(color_drawn(layer.style.color, kDarkCanvas), kDarkCanvas) > 3.0);
    CHECK(contrast(color_drawn(layer.style.color, kBlackCanvas), kBlackCanvas) > 3.0);
  }
}

TEST_CASE("nothing changes on a light canvas, or on none") {
  for (const Rgb color : {palette::black, palette::blue, palette::yellow, Rgb{255, 255, 255}})
    for (const std::optional<Rgb>& background :
         {std::optional(kWhiteCanvas), std::optional(kLightGreyCanvas), std::optional<Rgb>()})
      CHECK(color_drawn(color, background) == color);
}

TEST_CASE("only black and what is close to it is drawn light, and all else of the style stays") {
  for (const Rgb color : {palette::blue, palette::vermilion, palette::grey, Rgb{0, 0, 0x41}})
    CHECK(color_drawn(color, kDarkCanvas) == color);
  LayerStyle style;
  style.color = {0x40, 0x40, 0x40};
  style.opacity = 0.3;
  style.line_width_px = 7.0;
  LayerStyle expected = style;
  const LayerStyle out = drawn_on(style, kDarkCanvas);
  expected.color = out.color;
  CHECK(out == expected);
  CHECK(contrast(out.color, kDarkCanvas) > 12.0);
}

TEST_CASE("marks are seen on every canvas") {
  for (const Rgb canvas : {kWhiteCanvas, kLightGreyCanvas, kDarkCanvas, kBlackCanvas})
    CHECK(contrast(mark_color(canvas), canvas) > 4.0);
}

TEST_CASE("the canvas goes with the theme unless it has a colour of its own") {
  Settings settings;
  CHECK(canvas_background(settings) == kWhiteCanvas);
  settings.for_projector = true;
  CHECK(canvas_background(settings) == kWhiteCanvas);
  settings.theme = Theme::dark;
  CHECK(canvas_background(settings) == kBlackCanvas);
  settings.for_projector = false;
  CHECK(canvas_background(settings) == kDarkCanvas);
  settings.canvas_background = Rgb{7, 8, 9};
  CHECK(canvas_background(settings) == Rgb{7, 8, 9});
}
