// SPDX-License-Identifier: GPL-3.0-or-later
// What may be known of layers without their structures.
#include "core/draw/layer_descriptor.h"

#include "core/graph/layer.h"

namespace mes {

std::span<const LayerDescriptor> layer_descriptors() {
  static const std::vector<LayerDescriptor> descriptors = [] {
    const StructureSet structures = make_structures();
    std::vector<LayerDescriptor> out;
    for (Layer& layer : make_layers(structures)) out.push_back(layer.descriptor);
    return out;
  }();
  return descriptors;
}

LayerIndex find_layer(std::string_view id) {
  const auto descriptors = layer_descriptors();
  for (LayerIndex index = 0; index < descriptors.size(); ++index)
    if (descriptors[index].id == id) return index;
  return kNoLayer;
}

std::string_view title_of(LayerGroup group) {
  switch (group) {
    case LayerGroup::samples: return "Samples";
    case LayerGroup::delaunay_voronoi: return "Delaunay & Voronoi";
    case LayerGroup::crust_axis: return "Crust & axis";
    case LayerGroup::poles: return "Poles & power crust";
    case LayerGroup::union_a: return "Inner balls";
    case LayerGroup::union_p: return "Polar balls";
    case LayerGroup::union_b: return "Own balls";
    case LayerGroup::diagnostics: return "Diagnostics";
  }
  return {};
}

}  // namespace mes
