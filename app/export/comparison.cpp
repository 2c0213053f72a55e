// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/export/comparison.h"

#include <algorithm>
#include <limits>
#include <optional>
#include <utility>

#include "app/layers/ball_families.h"
#include "app/picture/paper/pane_sheet.h"
#include "core/base/assert.h"
#include "core/draw/instance_difference.h"
#include "core/draw/variant.h"
#include "core/graph/registry.h"

namespace mes {
namespace {

constexpr Rgb kOnlyHere{0xE0, 0x1E, 0x8C};

/// The layer of another pane that corresponds to this one: the same, or else that of another family of balls.
std::optional<VariantLayer> counterpart(LayerIndex layer, const Pane& pane) {
  const auto descriptors = pane.shown.descriptors;
  const auto same = std::ranges::find(pane.shown.layers, layer, &VariantLayer::layer);
  if (same != pane.shown.layers.end()) return *same;
  const std::string_view shown = descriptors[layer].of_any_family;
  const auto alike = std::ranges::find_if(pane.shown.layers, [&](VariantLayer other) {
    return !shown.empty() && descriptors[other.layer].of_any_family == shown;
  });
  return alike != pane.shown.layers.end() ? std::optional(*alike) : std::nullopt;
}

/// Finds the instances of a layer of a pane that some other pane with the layer lacks, by kind.
class Differences {
 public:
  Differences(const LayerMirror& mirror, double tolerance) : mirror_(mirror), tolerance_(tolerance) {}

  /// Returns false if there are none.
  bool find(VariantLayer layer, std::span<const VariantLayer> others, LayerPatch& out) const {
    bool has_any = false;
    for (const PrimitiveKind kind : kAllPrimitiveKinds) {
      KindPatch& patch = out[kind];
      patch.reset = true;
      const std::span<const double> instances = mirror_.instances(layer, kind);
      const std::size_t stride = stride_of(kind);
      for (const std::uint32_t i : missing_somewhere(kind, instances, others)) {
        const auto values = instances.subspan(i * stride, stride);
        patch.data.insert(patch.data.end(), values.begin(), values.end() - 1);
        patch.data.push_back(0.0);
        ++patch.count;
        has_any = true;
      }
    }
    return has_any;
  }

 private:
  std::vector<std::uint32_t> missing_somewhere(PrimitiveKind kind, std::span<const double> instances,
                                               std::span<const VariantLayer> others) const {
    std::vector<std::uint32_t> out;
    for (const VariantLayer other : others) {
      const auto missing = without_counterpart(kind, instances, mirror_.instances(other, kind), tolerance_);
      out.insert(out.end(), missing.begin(), missing.end());
    }
    std::ranges::sort(out);
    const auto [first, last] = std::ranges::unique(out);
    out.erase(first, last);
    return out;
  }

  const LayerMirror& mirror_;
  double tolerance_;
};

/// The style that marks a layer's differences between panes.
LayerStyle marked(LayerStyle style) {
  constexpr double kWider = 1.75;
  constexpr double kLeastLine = 2.0;
  constexpr double kAreas = 0.45;
  style.color = kOnlyHere;
  style.opacity = kAreas;
  style.flat = true;
  style.color_map.clear();
  style.line_width_px = std::max(kLeastLine, kWider * style.line_width_px);
  style.point_size_px *= kWider;
  return style;
}

bool has_areas(const LayerDescriptor& layer) {
  return std::ranges::any_of(
      layer.kinds, [](PrimitiveKind kind) { return kind == PrimitiveKind::disk || kind == PrimitiveKind::triangle; });
}

render::ScalarRange range_of(const LayerMirror& mirror, VariantLayer layer) {
  render::ScalarRange out;
  for (const PrimitiveKind kind : kAllPrimitiveKinds) {
    const std::span<const double> instances = mirror.instances(layer, kind);
    for (std::size_t at = stride_of(kind); at <= instances.size(); at += stride_of(kind)) out.add(instances[at - 1]);
  }
  return out;
}

}  // namespace

std::vector<PaneRequest> pane_requests(
    const PanesOfWindow& panes, const std::shared_ptr<const SampleData>& data,
    const std::function<std::shared_ptr<const SampleData>(std::size_t pane)>& own_data) {
  const auto& [shown, layers, settings, words] = panes;
  ShownLayers main{.descriptors = layers.descriptors(), .layers = main_layers(layers.visible_layers())};
  for (LayerIndex layer = 0; layer < layers.size(); ++layer) main.styles.push_back(layers.style(layer));
  std::vector<PaneRequest> out{{words.front(), main, settings, data}};
  for (std::size_t i = 0; i < shown.panes.size() && i + 1 < words.size(); ++i) {
    const VariantIndex variant = shown.variant[i];
    PaneRequest pane{words[i + 1], main, variant == kMainVariant ? settings : shown.variants[variant - 1].settings,
                     data};
    if (auto own = own_data(i)) pane.data = std::move(own);
    pane.shown.layers.clear();
    for (const auto& [layer, style] : shown.panes[i]) {
      pane.shown.layers.emplace_back(layer.layer);
      pane.shown.styles[layer.layer] = style;
    }
    out.push_back(std::move(pane));
  }
  return out;
}

Comparison compare(const Registry& registry, std::vector<PaneRequest> requests) {
  MES_ASSERT(!requests.empty() && requests.size() <= kMostPanes);
  Comparison out;
  out.data = requests.front().data;
  out.settings = requests.front().settings;
  const auto variant_of = [&out](const PaneRequest& request) -> VariantIndex {
    if (request.data == out.data && request.settings == out.settings) return kMainVariant;
    const auto own = request.data == out.data ? nullptr : request.data;
    const auto found = std::ranges::find_if(out.variants, [&](const WorkbenchVariant& variant) {
      return variant.settings == request.settings && variant.data == own;
    });
    const auto index = static_cast<VariantIndex>(found - out.variants.begin()) + 1;
    if (found == out.variants.end()) out.variants.push_back({request.settings, own});
    return index;
  };
  for (PaneRequest& request : requests) {
    const std::size_t place = out.panes.size();
    Pane pane{.label = pane_label(place, request.words),
              .letter = pane_letter(place),
              .shown = std::move(request.shown),
              .variant = variant_of(request),
              .data = request.data};
    const bool has_document = pane.variant != kMainVariant && out.variants[pane.variant - 1].data;
    for (VariantLayer& layer : pane.shown.layers) layer = registry.layer_in(pane.variant, has_document, layer.layer);
    out.demand.insert(out.demand.end(), pane.shown.layers.begin(), pane.shown.layers.end());
    out.panes.push_back(std::move(pane));
  }
  std::ranges::sort(out.demand);
  const auto [first, last] = std::ranges::unique(out.demand);
  out.demand.erase(first, last);
  return out;
}

Comparison comparison_of(const ShownPanes& shown, const LayerStack& layers) {
  Comparison out;
  out.variants.resize(shown.variants.size());
  Pane main{.label = {},
            .letter = pane_letter(0),
            .shown = {.descriptors = layers.descriptors(), .layers = main_layers(layers.visible_layers())},
            .data = nullptr};
  for (LayerIndex layer = 0; layer < layers.size(); ++layer) main.shown.styles.push_back(layers.style(layer));
  out.panes.push_back(main);
  for (std::size_t i = 0; i < shown.panes.size(); ++i) {
    Pane pane = main;
    pane.letter = pane_letter(i + 1);
    pane.variant = shown.variant[i];
    pane.shown.layers.clear();
    for (const auto& [layer, style] : shown.panes[i]) {
      pane.shown.layers.push_back(layer);
      pane.shown.styles[layer.layer] = style;
    }
    out.panes.push_back(std::move(pane));
  }
  return out;
}

void share_color_ranges(Comparison& comparison, const LayerMirror& mirror) {
  const auto follows = [](const LayerStyle& style) { return !style.color_map.empty() && !style.range_locked; };
  std::vector<render::ScalarRange> ranges(comparison.panes.front().shown.descriptors.size());
  for (const Pane& pane : comparison.panes)
    for (const VariantLayer layer : pane.shown.layers)
      if (follows(pane.shown.styles[layer.layer])) ranges[layer.layer].add(range_of(mirror, layer));
  for (Pane& pane : comparison.panes) {
    for (const auto [variant, layer] : pane.shown.layers) {
      LayerStyle& style = pane.shown.styles[layer];
      if (!follows(style) || ranges[layer].is_empty()) continue;
      style.range_locked = true;
      style.range_low = ranges[layer].low;
      style.range_high = ranges[layer].high;
    }
  }
}

FramePatch mark_differences(Comparison& comparison, const LayerMirror& mirror, double extent) {
  // Coordinates that were rounded in different ways may differ in some of their last bits.
  constexpr double kRounding = 0x1p-30;
  // The marks of a pane are a variant of their own, numbered after all computed ones.
  VariantIndex marks = kMostPanes;
  FramePatch out;
  out.frame = mirror.frame();
  out.document_revision = mirror.document_revision();
  const Differences differences(mirror, std::max(kRounding * extent, std::numeric_limits<double>::min()));
  for (Pane& pane : comparison.panes) {
    for (const VariantLayer layer : pane.shown.layers) {
      std::vector<VariantLayer> others;
      for (const Pane& other : comparison.panes)
        if (const auto theirs = counterpart(layer.layer, other); theirs && *theirs != layer)
          others.push_back(*theirs);
      if (others.empty()) continue;
      LayerPatch patch;
      patch.layer = {marks, layer.layer};
      if (!differences.find(layer, others, patch)) continue;
      LayerStyle style = marked(pane.shown.styles[layer.layer]);
      if (!has_areas(pane.shown.descriptors[layer.layer])) style.opacity = 1.0;
      pane.marks.push_back({patch.layer, style});
      out.layers.push_back(std::move(patch));
    }
    ++marks;
  }
  out.layer_count = out.layers.size();
  return out;
}

}  // namespace mes
