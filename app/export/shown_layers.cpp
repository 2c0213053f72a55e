// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/export/shown_layers.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "app/picture/canvas_look.h"
#include "core/draw/layer_descriptor.h"
#include "core/draw/primitive_values.h"
#include "core/draw/variant.h"

namespace mes {
namespace {

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

}  // namespace

std::vector<render::LayerView> views_of(const ShownLayers& shown, double units_per_pixel,
                                        const std::vector<Vec2>& samples) {
  constexpr double kShareOfSpacing = 0.7;
  constexpr double kSmallestDot = 1.5;
  std::vector<render::LayerView> views;
  for (const LayerIndex layer : shown.layers) {
    const LayerDescriptor& descriptor = layer_descriptors()[plain_layer(layer)];
    LayerStyle style = shown.styles[plain_layer(layer)];
    const bool is_chosen = style.point_size_px != descriptor.style.point_size_px;
    if (!is_chosen && style.thin_when_dense && descriptor.id == "points" && samples.size() > 1) {
      const double spacing_px = typical_spacing(samples) / units_per_pixel / shown.scale;
      const double limit = std::max(kSmallestDot, kShareOfSpacing * spacing_px);
      style.point_size_px = std::min(style.point_size_px, limit);
    }
    views.push_back({layer, drawn_on(style, shown.background)});
  }
  return views;
}

Box2 fit_box(const Box2& samples, const LayerMirror& mirror, std::span<const LayerIndex> layers) {
  Box2 box = samples;
  for (const LayerIndex layer : layers)
    if (layer_descriptors()[plain_layer(layer)].in_fit_box) box.add(box_of(mirror, layer));
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

LayerConfiguration configuration_of(const ShownLayers& shown) {
  LayerConfiguration out;
  for (const LayerIndex layer : shown.layers)
    out.layers.push_back({std::string(layer_descriptors()[layer].id), true, shown.styles[layer]});
  return out;
}

}  // namespace mes
