// SPDX-License-Identifier: GPL-3.0-or-later
// "Export a figure": the settings, with a preview of the figure beside them.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "app/export/latest_figure.h"
#include "app/ui/dialogs/dialog.h"
#include "app/ui/widgets/button_rows.h"

namespace mes {

/// Threads: the window's.
class FigureDialog final : public Dialog {
 public:
  /// All members must outlive the dialog.
  struct Uses {
    LatestFigure& latest;
    FigureSettings& settings;
    std::function<void()> ask_file;          ///< asks for the file of the figure
    std::function<ImTextureID()> texture{};  ///< texture of the preview; null while there is none
    std::function<void()> closed;            ///< called when cancelled or done
  };
  void set_uses(Uses uses) { uses_.emplace(std::move(uses)); }

  void open();
  void close();
  /// Hides the dialog while another one lies over it.
  void set_covered(bool is_covered) { is_covered_ = is_covered; }

  bool is_open() const override { return is_open_; }
  void cancel() override { close(); }
  void draw(const Gui& gui) override;
  /// Enter exports, unless a number is being typed.
  void press(const KeyChord& chord) override;

 private:
  void draw_settings(const Gui& gui) const;
  void draw_size(const Gui& gui) const;
  void draw_panes(const Gui& gui) const;
  void draw_sizes(const Gui& gui) const;
  void draw_look(const Gui& gui) const;
  void draw_layers(const Gui& gui);
  void draw_facts(const Gui& gui);
  void draw_buttons(const Gui& gui, ButtonRows& buttons);
  void draw_preview(const Gui& gui) const;

  std::optional<Uses> uses_;
  bool is_open_ = false;
  bool is_covered_ = false;
  bool is_accepted_ = false;
  bool is_at_real_size_ = false;
  std::vector<std::string> rasterized_;  // ids of layers; for this figure only
};

}  // namespace mes
