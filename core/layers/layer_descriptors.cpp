// SPDX-License-Identifier: GPL-3.0-or-later
// What may be known of layers without their structures.
#include "core/draw/layer_descriptor.h"

#include "core/graph/layer.h"
#include "core/structures/inputs/settings_source.h"

namespace mes {
namespace {

bool follows(const Structure& structure, const Structure& source) {
  return &structure == &source ||
         std::ranges::any_of(structure.inputs(), [&](const Structure* input) { return follows(*input, source); });
}

}  // namespace

std::span<const LayerDescriptor> layer_descriptors() {
  static const std::vector<LayerDescriptor> descriptors = [] {
    const StructureSet structures = make_structures();
    std::vector<LayerDescriptor> out;
    const auto& settings = structures.get<SettingsSource>();
    for (Layer& layer : make_layers(structures)) {
      layer.descriptor.follows_settings = std::ranges::any_of(
          layer.structures, [&](const Structure* structure) { return follows(*structure, settings); });
      out.push_back(std::move(layer.descriptor));
    }
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
    case LayerGroup::scale_axis: return "Scale axis";
    case LayerGroup::poles: return "Poles & power crust";
    case LayerGroup::union_a: return "Inner balls";
    case LayerGroup::union_p: return "Polar balls";
    case LayerGroup::union_b: return "Own balls";
    case LayerGroup::diagnostics: return "Diagnostics";
  }
  return {};
}

}  // namespace mes
