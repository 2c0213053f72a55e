// SPDX-License-Identifier: GPL-3.0-or-later
// Binds the actions of the table that work on the selection.
#pragma once

#include <functional>
#include <string>

#include "app/actions/action_bindings.h"
#include "app/actions/messages.h"
#include "app/editing/selection_commands.h"
#include "app/settings/settings.h"

namespace mes {

/// The objects that the actions work with; they all outlive the actions.
struct SelectionUses {
  Editor& editor;
  SelectionCommands& commands;
  Messages& messages;
  const Settings& settings;
  std::function<std::string()> clipboard;  ///< returns its text
  std::function<void(const std::string&)> to_clipboard;
  std::function<double()> units_per_px;             ///< scale of the view, per logical pixel
  std::function<Box2()> view;                       ///< the visible area
  std::function<void(std::string text)> open_text;  ///< as a document of its own
};
void bind_selection(ActionBindings& actions, SelectionUses uses);

}  // namespace mes
