// SPDX-License-Identifier: GPL-3.0-or-later
// The list of bundles: a click or a digit shows the layers saved under a name.
#pragma once

#include <functional>
#include <optional>
#include <string>

#include "app/actions/action_bindings.h"
#include "app/actions/messages.h"
#include "app/store/looks/window_bundles.h"
#include "app/ui/dialogs/name_field.h"
#include "app/ui/widgets/widgets.h"

namespace mes {

class BundlesPanel {
 public:
  struct Uses {
    const Gui& gui;
    const ActionBindings& actions;
    WindowBundles& bundles;
    Messages& messages;
    std::function<void(std::size_t)> choose;      ///< shows a bundle
    std::function<void(std::size_t)> export_one;  ///< asks for a file
  };
  explicit BundlesPanel(Uses uses) : uses_(std::move(uses)) {}

  void draw();
  /// Asks for a name for the present layers at the next drawing.
  void ask_name() { asks_name_ = true; }

 private:
  void draw_head();
  void draw_save_popup();
  void draw_menu();
  void draw_rows(float height);
  void draw_row(std::size_t index);
  void draw_context_menu(std::size_t index);
  void draw_rename_popup();
  void draw_undo_line() const;

  void tell(const Expected<void>& done) const;

  Uses uses_;
  bool asks_name_ = false;
  std::string name_;
  NameField field_;
  std::optional<std::size_t> asks_rename_;
  std::size_t renamed_ = 0;
  std::optional<std::size_t> shown_current_;  // scrolled to when it changes
};

}  // namespace mes
