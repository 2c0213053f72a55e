// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/draw/layer_descriptor.h"

#include <algorithm>

namespace mes {

std::string_view title_of(LayerGroup group) {
  switch (group) {
    case LayerGroup::samples: return "Samples";
    case LayerGroup::delaunay_voronoi: return "Delaunay & Voronoi";
    case LayerGroup::crust_axis: return "Crust & axis";
    case LayerGroup::scale_axis: return "Scale axis";
    case LayerGroup::poles: return "Poles & power crust";
    case LayerGroup::union_a: return "Inner balls";
    case LayerGroup::union_p: return "Polar balls";
    case LayerGroup::union_b: return "Own balls";
    case LayerGroup::diagnostics: return "Diagnostics";
    case LayerGroup::experiments: return "Experiments";
  }
  return {};
}

LayerIndex find_layer(std::span<const LayerDescriptor> layers, LayerData data) {
  const auto found = std::ranges::find_if(
      layers, [data](const LayerDescriptor& layer) { return layer.data == data && !layer.is_removed; });
  return found == layers.end() ? kNoLayer : static_cast<LayerIndex>(found - layers.begin());
}

LayerIndex find_layer(std::span<const LayerDescriptor> layers, std::string_view id) {
  const auto found = std::ranges::find(layers, id, &LayerDescriptor::id);
  if (found == layers.end() || found->is_removed) return kNoLayer;
  return static_cast<LayerIndex>(found - layers.begin());
}

}  // namespace mes
