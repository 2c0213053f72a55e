// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/panels/on_canvas/problem_note.h"

#include <algorithm>
#include <string>

#include "app/ui/icons.h"
#include "app/ui/theme.h"
#include "app/ui/widgets.h"

namespace mes {

void ProblemNote::draw(ImVec2 at, float width) const {
  const std::string problem = messages.problem();
  if (problem.empty()) return;
  const float unit = gui.unit();
  const float wanted = std::min(width, ImGui::CalcTextSize(problem.c_str()).x + 76 * unit);
  ImGui::SetNextWindowPos({at.x + 0.5F * (width - wanted), at.y});
  ImGui::SetNextWindowSize({wanted, 0});
  ImGui::PushStyleColor(ImGuiCol_WindowBg, gui.colors().warning_soft);
  ImGui::PushStyleColor(ImGuiCol_Border, gui.colors().warning_border);
  ImGui::Begin("##problem", nullptr,
               ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_AlwaysAutoResize |
                   ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoFocusOnAppearing);
  const float size = ImGui::GetTextLineHeight();
  const float start = ImGui::GetCursorPosY();
  ImGui::PushStyleColor(ImGuiCol_Text, gui.colors().warning);
  ImGui::PushTextWrapPos(wanted - 34 * unit);
  ImGui::TextUnformatted(problem.c_str());
  ImGui::PopTextWrapPos();
  ImGui::PopStyleColor();
  ImGui::SameLine(wanted - 30 * unit);
  ImGui::SetCursorPosY(start);
  if (icon_button("close", Icon::close, 1.2F * size)) messages.clear_problem();
  tooltip(gui, "Close");
  ImGui::End();
  ImGui::PopStyleColor(2);
}

}  // namespace mes
