// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/panels/bars/toolbar.h"

#include <array>

#include "app/ui/widgets/button_columns.h"
#include "app/ui/widgets/icons.h"
#include "app/ui/widgets/slider.h"
#include "app/ui/widgets/widgets.h"

namespace mes {
namespace {

constexpr float kToolbarPadding = 5.0F;

void action_button(const Toolbar& toolbar, ActionId id, Icon icon, float size) {
  const bool enabled = toolbar.actions.is_enabled(id);
  ButtonLook look = ButtonLook::plain;
  if (toolbar.actions.is_checked(id))
    look = descriptor_of(id).group == ActionGroup::tools ? ButtonLook::chosen : ButtonLook::on;
  if (icon_button(descriptor_of(id).public_id.data(), icon, size, look, enabled)) toolbar.actions.run(id);
  tooltip(toolbar.gui, toolbar.actions.tooltip_of(id));
}

struct Button {
  ActionId action;
  Icon icon;
  bool begins_group = false;
};
constexpr std::array<Button, 14> kButtons{{{ActionId::tool_select, Icon::select},
                                           {ActionId::tool_insert, Icon::insert},
                                           {ActionId::tool_spray, Icon::spray},
                                           {ActionId::tool_brush, Icon::brush},
                                           {ActionId::tool_ball, Icon::ball},
                                           {ActionId::tool_measure, Icon::measure},
                                           {ActionId::tool_annotate, Icon::annotate},
                                           {ActionId::undo, Icon::undo, true},
                                           {ActionId::redo, Icon::redo},
                                           {ActionId::fit, Icon::fit, true},
                                           {ActionId::toggle_evolution, Icon::evolution},
                                           {ActionId::help, Icon::help},
                                           {ActionId::snapshot, Icon::snapshot, true},
                                           {ActionId::record, Icon::record}}};

}  // namespace

void Toolbar::draw_spray() const {
  ImGui::AlignTextToFramePadding();
  ImGui::TextUnformatted("Spacing");
  ImGui::SameLine();
  slider(gui, "##spacing", settings.spray_spacing_px, 2.0, 100.0,
         {.format = "%.0f px", .is_logarithmic = true, .width = 210 * gui.unit()});
  tooltip(gui, "Distance between neighbouring samples of a stroke, in screen pixels");
}

void Toolbar::draw_brush() const {
  for (const ActionId mode : {ActionId::brush_erase, ActionId::brush_thin, ActionId::brush_refine}) {
    if (choice_button(descriptor_of(mode).name.c_str(), actions.is_checked(mode))) actions.run(mode);
    tooltip(gui, actions.tooltip_of(mode));
    ImGui::SameLine();
  }
  slider(gui, "##radius", settings.brush.radius_px, 4.0, 200.0,
         {.format = "%.0f px", .is_logarithmic = true, .width = 180 * gui.unit()});
  tooltip(gui, "Radius of the brush, in screen pixels");
}

float Toolbar::draw(ImVec2 at, float room) const {
  const float unit = gui.unit();
  const float inside = room - 2 * kToolbarPadding * unit;
  // One more button for the settings of recordings.
  const float size = column_button_size(kButtons.size() + 1, 3, inside / unit) * unit;
  ImGui::SetNextWindowPos(at);
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {kToolbarPadding * unit, kToolbarPadding * unit});
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {0, 0});
  ImGui::Begin("##toolbar", nullptr,
               ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_AlwaysAutoResize |
                   ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoNav | ImGuiWindowFlags_NoFocusOnAppearing);
  ButtonColumns columns(ImGui::GetCursorPos(), size, unit, inside);
  for (const Button& button : kButtons) {
    columns.next(button.begins_group);
    action_button(*this, button.action, button.icon, size);
  }
  columns.next(false);
  record.draw(size);
  const float width = columns.width() + 2 * kToolbarPadding * unit;
  ImGui::End();
  ImGui::PopStyleVar(2);

  const bool is_spray = canvas.tool_id() == ToolId::spray;
  if (is_spray || canvas.tool_id() == ToolId::brush) {
    ImGui::SetNextWindowPos({at.x + width + 6 * unit, at.y + (is_spray ? 2.0F : 3.0F) * (size + kButtonGap * unit)});
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {8 * unit, 6 * unit});
    ImGui::Begin("##tool", nullptr,
                 ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_AlwaysAutoResize |
                     ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoNav | ImGuiWindowFlags_NoFocusOnAppearing);
    if (is_spray)
      draw_spray();
    else
      draw_brush();
    ImGui::End();
    ImGui::PopStyleVar();
  }
  return width;
}

}  // namespace mes
