// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/picture.h"

#include <fmt/core.h>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <string_view>

#include "app/cli/layer_summary.h"
#include "app/cli/messages.h"
#include "core/draw/layer_descriptor.h"
#include "core/io/text_numbers.h"

namespace mes::cli {
namespace {

constexpr std::uint64_t kLongestSide = 32768;

Box2 box_of(const LayerMirror& mirror, LayerIndex layer) {
  Box2 box;
  for (const PrimitiveKind kind : kAllPrimitiveKinds) {
    const std::span<const double> instances = mirror.instances(layer, kind);
    for (std::size_t at = 0; at < instances.size(); at += stride_of(kind)) {
      const double* const v = instances.data() + at;
      switch (kind) {
        case PrimitiveKind::disk:
        case PrimitiveKind::circle:
          box.add(Vec2{v[0] - v[2], v[1] - v[2]});
          box.add(Vec2{v[0] + v[2], v[1] + v[2]});
          break;
        case PrimitiveKind::arc: box.add(bounding_box_of(arc_of(v))); break;
        case PrimitiveKind::triangle: box.add(Vec2{v[4], v[5]}); [[fallthrough]];
        case PrimitiveKind::segment: box.add(Vec2{v[2], v[3]}); [[fallthrough]];
        case PrimitiveKind::point: box.add(Vec2{v[0], v[1]}); break;
        case PrimitiveKind::ray:
        case PrimitiveKind::line: break;
      }
    }
  }
  return box;
}

/// Exactly as many numbers with commas between them.
bool read_numbers(std::string_view text, std::span<double> numbers) {
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    const std::size_t comma = text.find(',');
    if ((comma == std::string_view::npos) != (i + 1 == numbers.size())) return false;
    const auto value = parse_number(text.substr(0, comma));
    if (!value) return false;
    numbers[i] = *value;
    text.remove_prefix(comma == std::string_view::npos ? text.size() : comma + 1);
  }
  return true;
}

}  // namespace

Expected<PictureSize> parse_size(const std::string& text) {
  const std::size_t cross = text.find_first_of("xX");
  const auto side = [](std::string_view digits) -> int {
    const auto value = parse_count(digits);
    return value && *value >= 1 && *value <= kLongestSide ? static_cast<int>(*value) : 0;
  };
  if (cross != std::string::npos) {
    const PictureSize size{side(std::string_view(text).substr(0, cross)),
                           side(std::string_view(text).substr(cross + 1))};
    if (size.width != 0 && size.height != 0) return size;
  }
  return usage_error(fmt::format("--size expects WxH, each from 1 to {}, not {}", kLongestSide, in_quotes(text)));
}

Expected<std::optional<Box2>> parse_view(const std::string& text) {
  if (text == "fit") return std::nullopt;
  std::array<double, 4> corner{};
  bool good = read_numbers(text, corner);
  Box2 box;
  if (good) {
    box.add(Vec2{corner[0], corner[1]});
    box.add(Vec2{corner[2], corner[3]});
    good = box.width() > 0.0 && box.height() > 0.0 && std::isfinite(box.width()) && std::isfinite(box.height());
  }
  if (!good) return usage_error("--view expects fit or two corners X0,Y0,X1,Y1, not " + in_quotes(text));
  return box;
}

std::optional<Rgb> parse_rgb(std::string_view text) {
  if (text.starts_with('#')) text.remove_prefix(1);
  if (text.size() != 6) return std::nullopt;
  std::uint32_t value = 0;
  for (const char c : text) {
    constexpr std::string_view kDigits = "0123456789abcdef";
    const std::size_t digit = kDigits.find(c >= 'A' && c <= 'F' ? static_cast<char>(c - 'A' + 'a') : c);
    if (digit == std::string_view::npos) return std::nullopt;
    value = value * 16 + static_cast<std::uint32_t>(digit);
  }
  return Rgb{static_cast<std::uint8_t>(value >> 16U), static_cast<std::uint8_t>(value >> 8U),
             static_cast<std::uint8_t>(value)};
}

Expected<std::optional<Rgb>> parse_background(const std::string& text) {
  if (text == "transparent" || text == "none") return std::nullopt;
  const auto color = parse_rgb(text);
  if (!color) return usage_error("--background expects RRGGBB or transparent, not " + in_quotes(text));
  return color;
}

BackgroundImage parse_image(const std::string& text) {
  const std::size_t colon = text.rfind(':');
  std::array<double, 3> numbers{};
  if (colon == std::string::npos || !read_numbers(std::string_view(text).substr(colon + 1), numbers) ||
      !(numbers[2] > 0.0))
    return {.file = text};
  return {text.substr(0, colon), {numbers[0], numbers[1]}, numbers[2]};
}

Box2 fit_box(const Box2& samples, const LayerMirror& mirror, std::span<const LayerIndex> layers) {
  Box2 box = samples;
  for (const LayerIndex layer : layers)
    if (layer_descriptors()[layer].in_fit_box) box.add(box_of(mirror, layer));
  if (samples.is_empty()) return box;
  constexpr double kReach = 0.1;
  const double reach = kReach * std::max(samples.width(), samples.height());
  if (!(reach > 0.0)) return box;
  const auto within = [reach](double value, double low, double high) {
    return std::clamp(value, low - reach, high + reach);
  };
  box.low = {within(box.low.x, samples.low.x, samples.high.x), within(box.low.y, samples.low.y, samples.high.y)};
  box.high = {within(box.high.x, samples.low.x, samples.high.x), within(box.high.y, samples.low.y, samples.high.y)};
  return box;
}

double typical_spacing(std::vector<Vec2> samples) {
  constexpr std::size_t kProbes = 500;
  std::ranges::sort(samples, lexicographically_less);
  samples.erase(std::unique(samples.begin(), samples.end()), samples.end());
  if (samples.size() < 2) return 0.0;
  std::vector<double> nearest;
  const std::size_t step = std::max<std::size_t>(1, samples.size() / kProbes);
  for (std::size_t i = 0; i < samples.size(); i += step) {
    // Outwards in x on both sides until x alone is farther than the best.
    double best = std::numeric_limits<double>::infinity();
    for (std::size_t k = i; k-- > 0 && samples[i].x - samples[k].x < best;)
      best = std::min(best, distance(samples[i], samples[k]));
    for (std::size_t k = i + 1; k < samples.size() && samples[k].x - samples[i].x < best; ++k)
      best = std::min(best, distance(samples[i], samples[k]));
    nearest.push_back(best);
  }
  const auto middle = nearest.begin() + static_cast<std::ptrdiff_t>(nearest.size() / 2);
  std::ranges::nth_element(nearest, middle);
  return *middle;
}

}  // namespace mes::cli
