// SPDX-License-Identifier: GPL-3.0-or-later
// What every panel is made of: its frame, and the explanation of what lies under the pointer.
#pragma once

#include <string>

#include "app/ui/gui.h"

namespace mes {

/// A rectangle of the window, in screen coordinates.
struct PanelArea {
  ImVec2 at;
  ImVec2 size;
};

/// A fixed panel without title; pair with ImGui::End().
bool begin_panel(const char* name, const PanelArea& area, ImGuiWindowFlags extra = 0);

/// Explains the last item when the pointer rests on it, also when it is disabled.
void tooltip(const Gui& gui, const std::string& text);

}  // namespace mes
