// SPDX-License-Identifier: GPL-3.0-or-later
// The list of layers: what is drawn, in which order, in which style.
#pragma once

#include <array>
#include <optional>
#include <string>

#include "app/panels/color_map_controls.h"
#include "app/panels/panel_context.h"

namespace mes {

class LayersPanel {
 public:
  void draw(const PanelContext& context, const PanelArea& area);

 private:
  void draw_head(const PanelContext& context);
  void draw_row(const PanelContext& context, LayerIndex layer);
  void draw_swatch(const PanelContext& context, LayerIndex layer, ImVec2 at, ImVec2 size) const;
  void draw_style_popup(const PanelContext& context, LayerIndex layer);
  void paste_style(const PanelContext& context, LayerIndex layer) const;
  void draw_context_menu(const PanelContext& context, LayerIndex layer);
  bool is_listed(const PanelContext& context, LayerIndex layer) const;

  std::string search_;
  bool only_visible_ = false;
  bool by_order_ = false;
  std::optional<LayerStyle> copied_;
  ColorMapControls color_maps_;
};

}  // namespace mes
