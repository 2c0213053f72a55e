// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/export/shown_layers.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "app/editing/curves/sample_spacing.h"
#include "app/picture/paper/canvas_look.h"
#include "app/picture/paper/paper_drawing.h"
#include "core/draw/primitive_values.h"
#include "core/draw/variant.h"
#include "render/figure/figure.h"

namespace mes {
namespace {

Box2 box_of(const LayerMirror& mirror, VariantLayer layer) {
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
        case PrimitiveKind::parabola: box.add(bounding_box_of(parabola_of(v))); break;
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

std::vector<render::LayerView> views_of(const ShownLayers& shown, double spacing_px) {
  std::vector<render::LayerView> views;
  for (const VariantLayer layer : shown.layers) {
    const LayerStyle& own = shown.styles[layer.layer];
    LayerStyle style = thinned(own, shown.descriptors[layer.layer], spacing_px);
    style.line_width_px = std::max(style.line_width_px, std::min(shown.least_line_px, own.line_width_px));
    style.point_size_px = std::max(style.point_size_px, std::min(shown.least_line_px, own.point_size_px));
    views.push_back({layer, drawn_on(style, shown.background)});
  }
  return views;
}

Box2 fit_box(std::span<const LayerDescriptor> descriptors, const Box2& samples, const LayerMirror& mirror,
             std::span<const VariantLayer> layers) {
  Box2 box = samples;
  for (const VariantLayer layer : layers)
    if (descriptors[layer.layer].in_fit_box) box.add(box_of(mirror, layer));
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

double scale_for_letters(double points) {
  return points / (figure::kPointsPerPixel * figure::kEmOfSize * kSmallTextSize);
}

LayerConfiguration configuration_of(const ShownLayers& shown) {
  LayerConfiguration out;
  for (const auto [variant, layer] : shown.layers)
    out.layers.push_back({std::string(shown.descriptors[layer].id), true, shown.styles[layer]});
  return out;
}

}  // namespace mes
