// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/picture/paper/canvas_look.h"

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

double contrast(Rgb a, Rgb b) {
  const auto [dark, light] = std::minmax({luminance(a), luminance(b)});
  return (light + 0.05) / (dark + 0.05);
}

}  // namespace

Rgb canvas_background(const Settings& settings) {
  if (settings.canvas_background) return *settings.canvas_background;
  if (settings.theme == Theme::light) return kWhiteCanvas;
  return settings.for_projector ? kBlackCanvas : kDarkCanvas;
}

bool is_dark(Rgb background) {
  return contrast(kWhiteCanvas, background) > contrast(kBlackCanvas, background);
}

bool is_faint(Rgb color, double opacity, Rgb canvas, Rgb surroundings) {
  constexpr double kLeastContrast = 3.0;
  const auto mixed = [opacity](std::uint8_t above, std::uint8_t below) {
    return static_cast<std::uint8_t>(std::lround(below + std::clamp(opacity, 0.0, 1.0) * (above - below)));
  };
  const Rgb seen{mixed(color.r, canvas.r), mixed(color.g, canvas.g), mixed(color.b, canvas.b)};
  return std::min(contrast(seen, canvas), contrast(seen, surroundings)) < kLeastContrast;
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
