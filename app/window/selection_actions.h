// SPDX-License-Identifier: GPL-3.0-or-later
// What the actions of the table do with what is selected.
#pragma once

#include <functional>
#include <string>

#include "app/actions/action_bindings.h"
#include "app/editing/selection_desk.h"
#include "app/model/messages.h"
#include "app/model/settings.h"

namespace mes {

/// What the actions work with; all of it outlives them.
struct SelectionUses {
  Editor& editor;
  SelectionDesk& desk;
  Messages& messages;
  const Settings& settings;
  std::function<std::string()> clipboard;  ///< its text
  std::function<void(const std::string&)> to_clipboard;
  std::function<double()> units_per_px;  ///< of the view, in logical pixels
  std::function<Box2()> view;            ///< what is seen
};
void bind_selection(ActionBindings& actions, SelectionUses uses);

}  // namespace mes
