// SPDX-License-Identifier: GPL-3.0-or-later
// Chips in the status bar: one per parameter that is not at its default; a click resets it.
#pragma once

#include "app/actions/messages.h"
#include "app/insight/computation_control.h"
#include "app/layers/changed_parameters.h"
#include "app/ui/screen/gui.h"

namespace mes {

/// Guarantees: a changed parameter is always visible, if only in "+3", whose popup lists all of them.
///
/// Smallest use:
///     const ChangedChips chips(gui, computation, messages);
///     const float width = chips.width_in(room);
///     ... ImGui::SetCursorPosX(end - width); chips.draw(width);
///
/// Threads: the window's; lives for a frame.
class ChangedChips {
 public:
  ChangedChips(const Gui& gui, ComputationControl& computation, Messages& messages);

  bool is_empty() const { return changed_.empty(); }
  /// Width of all chips, with the gap after them.
  float full_width() const;
  /// Width of the chips that fit into the room, and of the button for the others; at least the width of that button.
  float width_in(float room) const;
  /// Draws the chips of `width_in`, from the cursor on.
  void draw(float room) const;

 private:
  std::size_t shown_in(float room) const;
  float row_width(std::size_t shown) const;
  std::string rest_text(std::size_t shown) const;
  float text_width(const std::string& text) const;
  bool draw_chip(const char* id, const std::string& text, bool has_cross) const;
  void draw_rest(std::size_t shown) const;
  void reset(const Parameter& parameter) const;

  const Gui& gui_;
  ComputationControl& computation_;
  Messages& messages_;
  std::vector<ChangedParameter> changed_;
  std::vector<float> widths_;
};

}  // namespace mes
