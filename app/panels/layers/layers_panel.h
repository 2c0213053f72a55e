// SPDX-License-Identifier: GPL-3.0-or-later
// The list of layers: their visibility, drawing order and style.
#pragma once

#include <functional>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "app/actions/action_bindings.h"
#include "app/layers/layer_list.h"
#include "app/panels/layers/color_map_controls.h"
#include "app/panels/layers/image_controls.h"
#include "app/store/layer_text.h"
#include "app/ui/widgets.h"

namespace mes {

class LayersPanel {
 public:
  LayersPanel(const Gui& gui, const ActionBindings& actions, LayerStack& layers, const Picture& picture,
              ImageControls image)
      : gui_(gui),
        actions_(actions),
        layers_(layers),
        picture_(picture),
        image_(image),
        color_maps_(gui, layers, picture) {}

  void draw();
  /// Sets the function that selects the sources of a layer's elements with values in a range.
  void set_select(std::function<void(LayerIndex, double, double)> select) {
    color_maps_.set_select(std::move(select));
  }
  /// Sets the function that asks for a file for the geometry of a layer.
  void set_export(std::function<void(LayerIndex, const LayerTextFormat&)> ask) { ask_export_ = std::move(ask); }

 private:
  void draw_head();
  void draw_search();
  void draw_families() const;
  void draw_section(std::size_t index);
  /// Returns false if the rows of the section are folded.
  bool draw_heading(std::size_t index);
  void toggle_group(const LayerSection& section);
  void draw_row(LayerIndex layer, const LayerSection& section);
  void draw_drop_target(LayerIndex layer, ImVec2 at, ImVec2 end);
  void draw_row_text(LayerIndex layer, const LayerSection& section, ImVec2 at, ImVec2 end) const;
  void draw_swatch(LayerIndex layer, ImVec2 at, ImVec2 size) const;
  void draw_style_popup(LayerIndex layer);
  void draw_context_menu(LayerIndex layer);
  void draw_export_menu(LayerIndex layer) const;
  void draw_filter_note();
  void follow();
  bool is_without_content(LayerIndex layer) const;
  std::string explanation(LayerIndex layer) const;

  const Gui& gui_;
  const ActionBindings& actions_;
  LayerStack& layers_;
  const Picture& picture_;
  ImageControls image_;
  ColorMapControls color_maps_;
  LayerListOptions options_;
  LayerListing listing_;
  LayerListOptions listed_options_;
  // While the pointer is on the rows, a click on one of them does not move the others.
  bool is_pointer_on_rows_ = false;
  std::uint64_t clicked_at_ = 0;                          // revision of the layers after the last click on a row
  std::set<std::string> folded_;                          // headings of folded sections
  std::map<LayerGroup, std::vector<LayerIndex>> hidden_;  // layers hidden by the eye of their group
  struct CopiedStyle {
    LayerIndex layer;
    LayerStyle style;
  };
  std::optional<CopiedStyle> copied_;
  std::function<void(LayerIndex, const LayerTextFormat&)> ask_export_;
};

}  // namespace mes
