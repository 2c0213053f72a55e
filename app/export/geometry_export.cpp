// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/export/geometry_export.h"

#include <fmt/core.h>
#include <algorithm>
#include <utility>

#include "core/base/counted.h"
#include "core/graph/registry.h"

namespace mes {

std::vector<LayerIndex> layers_for(const Registry& registry, const LayerTextFormat& format,
                                   std::vector<LayerIndex> layers) {
  if (format.needs_curve)
    for (const LayerData data : {LayerData::curve, LayerData::curve_normals})
      if (const LayerIndex layer = find_layer(registry.layers(), data);
          layer != kNoLayer && std::ranges::find(layers, layer) == layers.end())
        layers.push_back(layer);
  return layers;
}

Expected<LayerText> compute_layer_text(const Registry& registry, const SampleData& data,
                                       const LayerTextFormat& format, ComputationRequest request) {
  std::vector<LayerIndex> layers;
  for (const VariantLayer layer : request.layers) layers.push_back(layer.layer);
  if (auto good = check_layers(registry.layers(), format, layers); !good) return std::unexpected(good.error());
  LayerMirror mirror;
  request.layers = main_layers(layers_for(registry, format, layers));
  request.on_patch = [&mirror](const FramePatch& patch) { mirror.apply(patch); };
  const auto result = run_computation(registry, data, request);
  if (!result) return std::unexpected(result.error());
  return format.write({.registry = registry, .layers = layers, .mirror = mirror, .document = result->document});
}

std::string remark_about(const LayerText& text, const LayerTextFormat& format) {
  std::string out;
  if (text.left_out != 0)
    out = fmt::format("{} left out: {} holds finite shapes only",
                      counted(text.left_out, "ray or line is", "rays and lines are"), format.name);
  if (text.without_area != 0)
    out +=
        fmt::format("{}{} left out, because {} or {} free ends", out.empty() ? "" : "; ",
                    counted(text.without_area, "line is", "lines are"),
                    text.without_area == 1 ? "it branches" : "they branch", text.without_area == 1 ? "has" : "have");
  if (text.off_earth != 0)
    out += fmt::format("{}{} left out that {} beyond the poles or around the Earth", out.empty() ? "" : "; ",
                       counted(text.off_earth, "shape is", "shapes are"), text.off_earth == 1 ? "reaches" : "reach");
  return out;
}

}  // namespace mes
