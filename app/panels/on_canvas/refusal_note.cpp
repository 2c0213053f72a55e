// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/panels/on_canvas/refusal_note.h"

#include "app/ui/widgets/paragraph.h"

namespace mes {

void RefusalNote::draw(ImVec2 at, float width) const {
  if (!messages.is_refusal()) return;
  const float unit = gui.unit();
  ImGui::SetNextWindowPos({at.x + 0.5F * width, at.y}, ImGuiCond_Always, {0.5F, 1.0F});
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {10 * unit, 6 * unit});
  ImGui::Begin("##refusal", nullptr,
               ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoInputs | ImGuiWindowFlags_AlwaysAutoResize |
                   ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoFocusOnAppearing | ImGuiWindowFlags_NoNav);
  paragraph(messages.remark(), width - 30 * unit);
  ImGui::End();
  ImGui::PopStyleVar();
}

}  // namespace mes
