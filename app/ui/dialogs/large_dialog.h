// SPDX-License-Identifier: GPL-3.0-or-later
// The frame of dialogs with a preview.
#pragma once

#include <functional>

#include "app/ui/screen/gui.h"

namespace mes {

/// Draws a dialog in the middle of the window, of `size` in logical pixels, or as large as possible. While it is
/// open, calls `draw` with its size in screen coordinates. Call it in each frame, open or not.
void large_dialog(const Gui& gui, const char* id, bool is_open, ImVec2 size, const std::function<void(ImVec2)>& draw);

}  // namespace mes
