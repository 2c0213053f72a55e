// SPDX-License-Identifier: GPL-3.0-or-later
// The colour map in the style of a layer.
#pragma once

#include <functional>
#include <map>
#include <optional>
#include <utility>

#include "app/layers/layer_stack.h"
#include "app/picture/picture.h"
#include "app/ui/screen/gui.h"
#include "render/instances/colormap.h"

namespace mes {

/// Draws a bar in the colours of the map; categories are side by side.
void draw_color_map(ImDrawList& list, const render::ColorMap& map, ImVec2 at, ImVec2 size, double opacity = 1.0);

class ColorMapControls {
 public:
  ColorMapControls(const Gui& gui, const LayerStack& layers, const Picture& picture)
      : gui_(gui), layers_(layers), picture_(picture) {}

  /// Sets the function that selects the elements with values in a range.
  void set_select(std::function<void(LayerIndex, double low, double high)> select) { select_ = std::move(select); }
  /// Draws the choice of map and range, and changes the style accordingly; draws nothing for a layer without scalar.
  void draw(LayerIndex layer, LayerStyle& style);

 private:
  void draw_choice(LayerStyle& style) const;
  void draw_range(LayerIndex layer, LayerStyle& style);
  void draw_selection(LayerIndex layer);

  const Gui& gui_;
  const LayerStack& layers_;
  const Picture& picture_;
  std::optional<render::ScalarRange> copied_;
  std::function<void(LayerIndex, double, double)> select_;
  std::map<LayerIndex, render::ScalarRange> wanted_;  // typed values to be selected
};

}  // namespace mes
