// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/panels/toolbar.h"

#include "app/panels/icons.h"
#include "app/panels/record_popup.h"

namespace mes {
namespace {

void action_button(const PanelContext& context, ActionId id, Icon icon, float size) {
  const bool enabled = context.actions.is_enabled(id);
  ButtonLook look = ButtonLook::plain;
  if (context.actions.is_checked(id))
    look = descriptor_of(id).group == ActionGroup::tools ? ButtonLook::chosen : ButtonLook::on;
  if (icon_button(descriptor_of(id).public_id.data(), icon, size, look, enabled)) context.actions.run(id);
  tooltip(context.gui, tooltip_of(id));
}

}  // namespace

float draw_toolbar(const PanelContext& context, ImVec2 at) {
  const float unit = context.gui.unit();
  const float size = 34 * unit;
  ImGui::SetNextWindowPos(at);
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {5 * unit, 5 * unit});
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {0, 2 * unit});
  ImGui::Begin("##toolbar", nullptr,
               ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_AlwaysAutoResize |
                   ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoNav | ImGuiWindowFlags_NoFocusOnAppearing);
  action_button(context, ActionId::tool_select, Icon::select, size);
  action_button(context, ActionId::tool_insert, Icon::insert, size);
  action_button(context, ActionId::tool_spray, Icon::spray, size);
  action_button(context, ActionId::tool_ball, Icon::ball, size);
  const auto gap = [&] {
    ImGui::Dummy({0, 2 * unit});
    ImGui::Separator();
    ImGui::Dummy({0, 2 * unit});
  };
  gap();
  action_button(context, ActionId::undo, Icon::undo, size);
  action_button(context, ActionId::redo, Icon::redo, size);
  gap();
  action_button(context, ActionId::fit, Icon::fit, size);
  action_button(context, ActionId::toggle_evolution, Icon::evolution, size);
  action_button(context, ActionId::toggle_layers, Icon::layers, size);
  action_button(context, ActionId::toggle_statistics, Icon::statistics, size);
  action_button(context, ActionId::toggle_parameters, Icon::parameters, size);
  action_button(context, ActionId::help, Icon::help, size);
  gap();
  action_button(context, ActionId::snapshot, Icon::snapshot, size);
  action_button(context, ActionId::record, Icon::record, size);
  draw_record_popup(context, size);
  const float width = ImGui::GetWindowWidth();
  ImGui::End();
  ImGui::PopStyleVar(2);

  if (context.canvas.tool_id() == ToolId::spray) {
    ImGui::SetNextWindowPos({at.x + width + 6 * unit, at.y + 2 * (size + 2 * unit)});
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {8 * unit, 6 * unit});
    ImGui::Begin("##spray", nullptr,
                 ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_AlwaysAutoResize |
                     ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoNav | ImGuiWindowFlags_NoFocusOnAppearing);
    ImGui::AlignTextToFramePadding();
    ImGui::TextUnformatted("Spacing");
    ImGui::SameLine();
    auto spacing = static_cast<float>(context.settings.spray_spacing_px);
    ImGui::SetNextItemWidth(150 * unit);
    if (ImGui::SliderFloat("##spacing", &spacing, 2.0F, 100.0F, "%.0f px",
                           ImGuiSliderFlags_Logarithmic | ImGuiSliderFlags_AlwaysClamp))
      context.settings.spray_spacing_px = static_cast<double>(spacing);
    tooltip(context.gui, "Distance of neighbouring samples of a stroke, in pixels of the screen");
    ImGui::End();
    ImGui::PopStyleVar();
  }
  return width;
}

}  // namespace mes
