// SPDX-License-Identifier: GPL-3.0-or-later
// The part of a layer's style that is about its colour map.
#pragma once

#include <optional>

#include "app/panels/panel_context.h"
#include "render/colormap.h"

namespace mes {

/// A bar in the colours of the map; categories side by side.
void draw_color_map(ImDrawList& list, const render::ColorMap& map, ImVec2 at, ImVec2 size, double opacity = 1.0);

class ColorMapControls {
 public:
  /// Draws choice of the map and range, and changes the style by them; nothing for a layer without scalar.
  void draw(const PanelContext& context, LayerIndex layer, LayerStyle& style);

 private:
  void draw_choice(const PanelContext& context, LayerStyle& style) const;
  void draw_range(const PanelContext& context, LayerIndex layer, LayerStyle& style);

  std::optional<render::ScalarRange> copied_;
};

}  // namespace mes
