// SPDX-License-Identifier: GPL-3.0-or-later
// The frame of dialogs with a preview.
#pragma once

#include <functional>

#include "app/ui/gui.h"

namespace mes {

/// A dialog in the middle of the window, `size` large in logical pixels, or as large as there is room for. While it is
/// open, `draw` is called with its size in screen coordinates. To be called in each frame, open or not.
void large_dialog(const Gui& gui, const char* id, bool is_open, ImVec2 size, const std::function<void(ImVec2)>& draw);

}  // namespace mes
