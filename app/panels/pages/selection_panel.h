// SPDX-License-Identifier: GPL-3.0-or-later
// The selection in numbers: editable coordinates and radius, steps, turns, alignment, exact degeneracy.
#pragma once

#include <functional>
#include <string>

#include "app/actions/action_bindings.h"
#include "app/actions/messages.h"
#include "app/actions/refusal.h"
#include "app/canvas/canvas.h"
#include "app/editing/selection_commands.h"
#include "app/ui/screen/gui.h"

namespace mes {

/// Every field takes an expression (core/formula/formula.h). An error message stays until the panel is used again;
/// another message reports points that were moved outside the view. Threads: the window's.
class SelectionPanel {
 public:
  SelectionPanel(const Gui& gui, const ActionBindings& actions, SelectionCommands& commands, const Canvas& canvas,
                 Messages& messages)
      : gui_(gui), actions_(actions), commands_(commands), canvas_(canvas), messages_(messages), refusal_(messages) {}

  void draw();

 private:
  /// Draws a field with a number, and calls `use` when the user enters another one.
  void number(const char* label, double value, float width, const char* explanation,
              const std::function<Expected<void>(double)>& use);
  /// Draws a field and a button; the button, or Enter in the field, calls `use`.
  void wish(const char* label, const char* hint, std::string& text, const char* button, const char* explanation,
            const std::function<Expected<void>(double)>& use);
  void draw_place();
  void draw_motion();
  void draw_arrangement();
  void draw_formulas();
  void action_button(ActionId id, const char* label);
  /// Reports an error; returns whether the operation succeeded.
  bool report(const Expected<void>& done);
  /// Call it right after Enter has left the field: keeps the keyboard there if the operation failed.
  void enter(const std::string& typed, const Expected<void>& done);

  const Gui& gui_;
  const ActionBindings& actions_;
  SelectionCommands& commands_;
  const Canvas& canvas_;
  Messages& messages_;
  Refusal refusal_;
  std::string step_x_;
  std::string step_y_;
  std::string degrees_;
  std::string factor_;
  SelectionCommands::EachFormula each_;
};

}  // namespace mes
