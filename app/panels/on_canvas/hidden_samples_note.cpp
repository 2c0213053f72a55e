// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/panels/on_canvas/hidden_samples_note.h"

#include <fmt/core.h>

#include "app/editing/selection.h"
#include "app/layers/empty_view.h"
#include "app/ui/icons.h"
#include "app/ui/widgets.h"

namespace mes {

void HiddenSamplesNote::draw(ImVec2 top) const {
  const std::size_t count = hidden.count();
  if (count == 0) return;
  const float unit = gui.unit();
  ImGui::SetNextWindowPos(top, ImGuiCond_Always, {0.5F, 0.0F});
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {10 * unit, 6 * unit});
  ImGui::Begin("##hidden-samples", nullptr,
               ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_AlwaysAutoResize |
                   ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoFocusOnAppearing | ImGuiWindowFlags_NoNav);
  ImGui::AlignTextToFramePadding();
  ImGui::TextUnformatted(fmt::format("{} added; the layer Points is hidden", counted(count, 0)).c_str());
  ImGui::SameLine(0, 10 * unit);
  const std::string label = label_of(ShowInstead::samples);
  const bool is_wanted = ImGui::Button(label.c_str());
  ImGui::SameLine(0, 6 * unit);
  if (icon_button("close", Icon::close, ImGui::GetFrameHeight())) hidden.dismiss();
  tooltip(gui, "Close until samples have been shown");
  ImGui::End();
  ImGui::PopStyleVar();
  if (is_wanted) editor.change_layers(label, [&] { show_instead(ShowInstead::samples, layers); });
}

}  // namespace mes
