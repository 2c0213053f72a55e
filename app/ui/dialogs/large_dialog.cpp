// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/ui/dialogs/large_dialog.h"

#include <algorithm>

namespace mes {

void large_dialog(const Gui& gui, const char* id, bool is_open, ImVec2 size,
                  const std::function<void(ImVec2)>& draw) {
  // Position and size would apply to whichever window comes next.
  if (!is_open && !ImGui::IsPopupOpen(id)) return;
  const float unit = gui.unit();
  const float margin = 24 * unit;
  const ImVec2 screen = ImGui::GetIO().DisplaySize;
  const ImVec2 here(std::min(size.x * unit, screen.x - margin), std::min(size.y * unit, screen.y - margin));
  ImGui::SetNextWindowPos({0.5F * (screen.x - here.x), 0.5F * (screen.y - here.y)});
  ImGui::SetNextWindowSize(here);
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {18 * unit, 14 * unit});
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {6 * unit, 6 * unit});
  if (Gui::begin_dialog(id, is_open, ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove)) {
    draw(here);
    ImGui::EndPopup();
  }
  ImGui::PopStyleVar(2);
}

}  // namespace mes
