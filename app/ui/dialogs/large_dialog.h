// SPDX-License-Identifier: GPL-3.0-or-later
// The frame of dialogs with a preview, and their columns.
#pragma once

#include <functional>
#include <span>

#include "app/ui/screen/gui.h"
#include "app/ui/widgets/button_rows.h"

namespace mes {

/// Draws a dialog in the middle of the window, of `size` in logical pixels, or as large as possible. While it is
/// open, calls `draw` with its size in screen coordinates. Call it in each frame, open or not.
void large_dialog(const Gui& gui, const char* id, bool is_open, ImVec2 size, DialogKeys keys,
                  const std::function<void(ImVec2)>& draw);

/// A column of a large dialog.
struct DialogColumn {
  const char* id;
  float width;  ///< in logical pixels; 0: the rest of the dialog
  std::function<void()> draw;
};

/// The buttons of a large dialog.
struct DialogFoot {
  std::span<const char* const> labels;
  std::function<void(ButtonRows&)> draw;
};

/// Draws the columns beside each other: the last one is the preview, the one before it holds the settings and the
/// buttons, and any others are lists. In a window too narrow for that they stand one below the other, and are scrolled
/// together. The buttons are always in view.
void dialog_columns(const Gui& gui, std::span<const DialogColumn> columns, const DialogFoot& foot);

}  // namespace mes
