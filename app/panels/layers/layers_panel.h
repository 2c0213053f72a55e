// SPDX-License-Identifier: GPL-3.0-or-later
// The list of layers: their visibility, drawing order and style.
#pragma once

#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "app/actions/action_bindings.h"
#include "app/layers/layer_counts.h"
#include "app/layers/layer_list.h"
#include "app/panels/layers/color_map_controls.h"
#include "app/panels/layers/image_controls.h"
#include "app/store/texts/layer_text.h"
#include "app/ui/widgets/widgets.h"

namespace mes {

/// Threads: the window's.
class LayersPanel {
 public:
  /// `favorites`: ids of layers; `unfolded`: titles of the sections whose rows are listed.
  LayersPanel(const Gui& gui, const ActionBindings& actions, LayerStack& layers, const Picture& picture,
              ImageControls image, std::vector<std::string>& favorites, std::vector<std::string>& unfolded)
      : gui_(gui),
        actions_(actions),
        layers_(layers),
        picture_(picture),
        image_(image),
        favorites_(favorites),
        unfolded_(unfolded),
        color_maps_(gui, layers, picture) {}

  void draw();
  /// At the next drawing, scrolls to the layer's row and marks it until the next click on the list. A search ends, and
  /// the section of the row is unfolded.
  void reveal(LayerIndex layer) { reveal_ = layer; }
  /// Sets the function that selects the sources of a layer's elements with values in a range.
  void set_select(std::function<void(LayerIndex, double, double)> select) {
    color_maps_.set_select(std::move(select));
  }
  /// Sets the function that asks for a file for the geometry of a layer.
  void set_export(std::function<void(LayerIndex, const LayerTextFormat&)> ask) { ask_export_ = std::move(ask); }

  /// Sets the function that makes the counts follow the state from which layers are computed, and returns true if the
  /// picture shows that state.
  void set_follow_counts(std::function<bool(LayerCounts&)> follow) { follow_counts_ = std::move(follow); }

 private:
  void draw_head();
  void draw_search();
  void draw_families() const;
  bool is_filtered() const { return options_.only_shown || !options_.search.empty(); }
  bool is_folded(const LayerSection& section) const;
  void set_folded(const LayerSection& section, bool is_folded);
  void draw_section(std::size_t index);
  /// Returns false if the rows of the section are folded.
  bool draw_heading(std::size_t index);
  void toggle_group(const LayerSection& section);
  void draw_row(LayerIndex layer, const LayerSection& section);
  void draw_drop_target(LayerIndex layer, ImVec2 at, ImVec2 end);
  /// Remembers the counts of the shown layers.
  void note_counts();
  /// The number of elements drawn; of a hidden layer, as it was when the same state was shown. Nothing if it is unknown.
  std::optional<std::size_t> count_of(LayerIndex layer) const;
  void draw_star(LayerIndex layer, ImVec2 at, float size, bool is_row_hovered);
  void draw_row_text(LayerIndex layer, const LayerSection& section, ImVec2 at, ImVec2 end) const;
  void draw_swatch(LayerIndex layer, ImVec2 at, ImVec2 size) const;
  void draw_style_popup(LayerIndex layer);
  void draw_context_menu(LayerIndex layer);
  void draw_export_menu(LayerIndex layer) const;
  void draw_filter_note();
  void follow();
  void find_revealed();
  bool is_without_content(LayerIndex layer) const;
  std::string explanation(LayerIndex layer) const;

  const Gui& gui_;
  const ActionBindings& actions_;
  LayerStack& layers_;
  const Picture& picture_;
  ImageControls image_;
  std::vector<std::string>& favorites_;
  std::vector<std::string>& unfolded_;
  ColorMapControls color_maps_;
  LayerListOptions options_;
  LayerListing listing_;
  LayerListOptions listed_options_;
  // While the pointer is on the rows, a click on one of them does not move the others.
  bool is_pointer_on_rows_ = false;
  std::uint64_t clicked_at_ = 0;                           // revision of the layers after the last click on a row
  std::map<std::string, std::vector<LayerIndex>> hidden_;  // by title: layers hidden by the eye of their section
  std::optional<LayerIndex> reveal_;
  struct Revealed {
    std::string section;
    LayerIndex layer = kNoLayer;
  };
  std::optional<Revealed> revealed_;
  bool scrolls_ = false;  // to the revealed row
  struct CopiedStyle {
    LayerIndex layer;
    LayerStyle style;
  };
  std::optional<CopiedStyle> copied_;
  std::function<void(LayerIndex, const LayerTextFormat&)> ask_export_;
  std::function<bool(LayerCounts&)> follow_counts_;
  LayerCounts counts_;
};

}  // namespace mes
