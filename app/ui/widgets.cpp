// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/ui/widgets.h"

namespace mes {

bool begin_panel(const char* name, const PanelArea& area, ImGuiWindowFlags extra) {
  ImGui::SetNextWindowPos(area.at);
  ImGui::SetNextWindowSize(area.size);
  ImGui::PushStyleVar(ImGuiStyleVar_WindowRounding, 0.0F);
  const bool open = ImGui::Begin(name, nullptr,
                                 ImGuiWindowFlags_NoTitleBar | ImGuiWindowFlags_NoResize | ImGuiWindowFlags_NoMove |
                                     ImGuiWindowFlags_NoCollapse | ImGuiWindowFlags_NoBringToFrontOnFocus |
                                     ImGuiWindowFlags_NoNavFocus | ImGuiWindowFlags_NoSavedSettings | extra);
  ImGui::PopStyleVar();
  return open;
}

void tooltip(const Gui& gui, const std::string& text) {
  if (text.empty() || !gui.is_resting() || !ImGui::IsItemHovered(ImGuiHoveredFlags_AllowWhenDisabled)) return;
  ImGui::BeginTooltip();
  ImGui::PushTextWrapPos(340.0F * gui.unit());
  ImGui::TextUnformatted(text.c_str());
  ImGui::PopTextWrapPos();
  ImGui::EndTooltip();
}

}  // namespace mes
