// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/instances/colormap.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/base/assert.h"
#include "core/base/rng.h"
#include "render/device/convert.h"

namespace mes::render {
namespace {

// Shaders compute in single precision, which cannot represent halves beyond this number.
constexpr double kMostCategories = 0x1p22;

MapColor from_hue(double hue, double saturation, double value) {
  const auto channel = [&](double turn) {
    const double at = std::fmod(hue + turn, 1.0) * 6.0;
    const double ramp = std::clamp(std::abs(at - 3.0) - 1.0, 0.0, 1.0);
    return static_cast<float>(value * (1.0 - saturation * (1.0 - ramp)));
  };
  return {channel(0.0), channel(2.0 / 3.0), channel(1.0 / 3.0)};
}

}  // namespace

Rgb ColorMap::at(double t) const {
  MES_ASSERT(colors.size() >= 2);
  const double place = std::clamp(t, 0.0, 1.0) * static_cast<double>(colors.size() - 1);
  const auto first = std::min(static_cast<std::size_t>(place), colors.size() - 2);
  const auto part = static_cast<float>(place - static_cast<double>(first));
  return to_rgb(colors[first] + part * (colors[first + 1] - colors[first]));
}

std::optional<Rgb> ColorMap::color_of(double scalar, const ScalarRange& range) const {
  if (std::isnan(scalar)) return std::nullopt;
  if (!is_categorical) return at(place_in(scalar, range));
  if (!(std::abs(scalar) < kMostCategories)) return to_rgb(scalar > 0.0 ? colors.back() : colors.front());
  const auto size = static_cast<double>(colors.size());
  const double number = std::floor(scalar + 0.5);
  const auto index = static_cast<std::size_t>(number - size * std::floor(number / size));
  return to_rgb(colors[std::min(index, colors.size() - 1)]);
}

double place_in(double value, const ScalarRange& range) {
  if (std::isinf(value)) return value > 0.0 ? 1.0 : 0.0;
  if (range.is_empty()) return 0.5;
  if (!(value > range.low)) return value < range.low || range.low < range.high ? 0.0 : 0.5;
  if (!(value < range.high)) return 1.0;
  // Differences of halves do not overflow.
  return (0.5 * value - 0.5 * range.low) / (0.5 * range.high - 0.5 * range.low);
}

ColorMap grey_map() {
  return {"grey", {{0.1F, 0.1F, 0.1F}, {0.85F, 0.85F, 0.85F}}, false};
}

ColorMap categorical_map(std::uint64_t seed, std::size_t count) {
  // The first eight of seed 0 are the program's palette, which people without colour vision can distinguish.
  constexpr std::array<Rgb, 8> kFirst{palette::blue,   palette::orange, palette::green,  palette::vermilion,
                                      palette::purple, palette::sky,    palette::yellow, palette::grey};
  ColorMap out{"categories", {}, true};
  Rng random(seed);
  const double start = random.uniform();
  while (out.colors.size() < std::max<std::size_t>(count, 2)) {
    const std::size_t i = out.colors.size();
    if (seed == 0 && i < kFirst.size()) {
      out.colors.push_back(to_vec3(kFirst[i]));
      continue;
    }
    // Steps of the golden ratio keep any number of hues distinct.
    constexpr double kGolden = 0.6180339887498949;
    const double hue = std::fmod(start + kGolden * static_cast<double>(i), 1.0);
    out.colors.push_back(from_hue(hue, random.uniform(0.55, 0.9), random.uniform(0.55, 0.95)));
  }
  return out;
}

std::vector<ColorMap> builtin_color_maps() {
  return {grey_map(), categorical_map()};
}

}  // namespace mes::render
