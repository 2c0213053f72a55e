// SPDX-License-Identifier: GPL-3.0-or-later
// The bundles: one click or digit shows the layers as they were saved under a name.
#pragma once

#include <optional>
#include <string>

#include "app/panels/panel_context.h"
#include "app/ui/name_field.h"

namespace mes {

class BundlesPanel {
 public:
  /// What it would like to have, of at most `most`.
  float height(const PanelContext& context, float most) const;
  void draw(const PanelContext& context, const PanelArea& area);
  /// Asks for a name to save the layers under, when drawn next.
  void ask_name() { asks_name_ = true; }

 private:
  void draw_head(const PanelContext& context);
  void draw_save_popup(const PanelContext& context);
  void draw_menu(const PanelContext& context);
  void draw_rows(const PanelContext& context, float height);
  void draw_row(const PanelContext& context, std::size_t index);
  void draw_context_menu(const PanelContext& context, std::size_t index);
  void draw_rename_popup(const PanelContext& context);
  void draw_undo_line(const PanelContext& context) const;

  bool asks_name_ = false;
  std::string name_;
  NameField field_;
  std::optional<std::size_t> asks_rename_;
  std::size_t renamed_ = 0;
  std::optional<std::size_t> shown_current_;  // scrolled to when it changes
};

}  // namespace mes
