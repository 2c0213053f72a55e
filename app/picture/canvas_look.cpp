// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/picture/canvas_look.h"

#include <algorithm>
#include <cmath>

namespace mes {
namespace {

constexpr std::uint8_t kBrightestInk = 0x40;
constexpr Rgb kLightInk{0xF2, 0xF4, 0xF6};

double linear(std::uint8_t channel) {
  const double value = channel / 255.0;
  return value <= 0.04045 ? value / 12.92 : std::pow((value + 0.055) / 1.055, 2.4);
}

double luminance(Rgb color) {
  return 0.2126 * linear(color.r) + 0.7152 * linear(color.g) + 0.0722 * linear(color.b);
}

}  // namespace

Rgb canvas_background(const Settings& settings) {
  if (settings.canvas_background) return *settings.canvas_background;
  if (settings.theme == Theme::light) return kWhiteCanvas;
  return settings.for_projector ? kBlackCanvas : kDarkCanvas;
}

bool is_dark(Rgb background) {
  const double shade = luminance(background) + 0.05;
  return (1.0 + 0.05) / shade > shade / 0.05;
}

LayerStyle drawn_on(LayerStyle style, const std::optional<Rgb>& background) {
  const bool is_ink = std::max({style.color.r, style.color.g, style.color.b}) <= kBrightestInk;
  if (background && is_ink && is_dark(*background)) style.color = kLightInk;
  return style;
}

Rgb mark_color(Rgb background) {
  return is_dark(background) ? Rgb{0x6C, 0xC4, 0xFF} : palette::blue;
}

}  // namespace mes
