// SPDX-License-Identifier: GPL-3.0-or-later
// The list of layers: what is drawn, in which order, in which style.
#pragma once

#include <array>
#include <optional>
#include <string>

#include "app/panels/color_map_controls.h"
#include "app/panels/image_controls.h"
#include "app/ui/widgets.h"

namespace mes {

class LayersPanel {
 public:
  LayersPanel(const Gui& gui, LayerStack& layers, const Picture& picture, ImageControls image)
      : gui_(gui), layers_(layers), picture_(picture), image_(image), color_maps_(gui, layers, picture) {}

  void draw(const PanelArea& area);

 private:
  void draw_head();
  void draw_row(LayerIndex layer);
  void draw_swatch(LayerIndex layer, ImVec2 at, ImVec2 size) const;
  void draw_style_popup(LayerIndex layer);
  void paste_style(LayerIndex layer) const;
  void draw_context_menu(LayerIndex layer);
  bool is_listed(LayerIndex layer) const;
  std::string explanation(LayerIndex layer) const;

  const Gui& gui_;
  LayerStack& layers_;
  const Picture& picture_;
  ImageControls image_;
  ColorMapControls color_maps_;
  std::string search_;
  bool only_visible_ = false;
  bool by_order_ = false;
  std::optional<LayerStyle> copied_;
};

}  // namespace mes
