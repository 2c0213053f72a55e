// SPDX-License-Identifier: GPL-3.0-or-later
// Which layers a legend explains, wherever their colour maps are known from.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "app/picture/legend.h"
#include "core/draw/layer_descriptor.h"
#include "render/scene.h"

namespace mes {

/// `shown_map` gives the map of a view.
template <class ShownMapOf>
std::vector<LegendEntry> entries_of(std::span<const render::LayerView> views, const ShownMapOf& shown_map) {
  std::vector<LegendEntry> out;
  for (auto view = views.rbegin(); view != views.rend(); ++view) {
    const render::ShownMap shown = shown_map(*view);
    const LayerDescriptor& layer = layer_descriptors()[view->layer];
    if (shown.map != nullptr)
      out.push_back({std::string(layer.name), std::string(layer.scalar), shown.map, shown.range});
  }
  return out;
}

}  // namespace mes
