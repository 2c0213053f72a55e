// SPDX-License-Identifier: GPL-3.0-or-later
// Selects the layers that a legend explains, whatever the source of their colour maps.
#pragma once

#include <algorithm>
#include <span>
#include <string>
#include <vector>

#include "app/picture/paper/legend.h"
#include "core/draw/variant.h"
#include "render/scene.h"

namespace mes {

/// `shown_map` returns the map of a view; `has` tells whether a layer draws anything of a kind. A layer that draws
/// nothing has no entry.
template <class ShownMapOf, class Has>
std::vector<LegendEntry> entries_of(std::span<const LayerDescriptor> descriptors,
                                    std::span<const render::LayerView> views, LegendScope scope,
                                    const ShownMapOf& shown_map, const Has& has) {
  std::vector<LegendEntry> out;
  if (scope == LegendScope::none) return out;
  for (auto view = views.rbegin(); view != views.rend(); ++view) {
    const LayerDescriptor& layer = descriptors[view->layer.layer];
    const auto kind = std::ranges::find_if(layer.kinds, [&](PrimitiveKind each) { return has(view->layer, each); });
    if (kind == layer.kinds.end()) continue;
    const render::ShownMap shown = shown_map(*view);
    if (shown.map != nullptr) {
      out.push_back({std::string(layer.name), std::string(layer.scalar), shown.map, shown.range, {}});
      continue;
    }
    if (scope == LegendScope::all_layers)
      out.push_back(
          {std::string(layer.name), {}, nullptr, {}, {*kind, view->style, layer.points_as != PointsAs::dots}});
  }
  return out;
}

}  // namespace mes
