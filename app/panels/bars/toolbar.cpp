// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/panels/bars/toolbar.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "app/ui/icons.h"
#include "app/ui/slider.h"
#include "app/ui/widgets.h"

namespace mes {
namespace {

constexpr float kToolbarPadding = 5.0F;
constexpr float kButtonGap = 2.0F;
constexpr float kLine = 4 * kButtonGap;  // height of a line, including its surroundings

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
constexpr std::array<Button, 17> kButtons{{{ActionId::tool_select, Icon::select},
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
                                           {ActionId::toggle_layers, Icon::layers},
                                           {ActionId::toggle_statistics, Icon::statistics},
                                           {ActionId::toggle_parameters, Icon::parameters},
                                           {ActionId::help, Icon::help},
                                           {ActionId::snapshot, Icon::snapshot, true},
                                           {ActionId::record, Icon::record}}};

// Buttons become smaller (sizes in logical pixels) before there are two columns, and again before there are three.
float button_size(float room) {
  constexpr float kLargest = 34.0F;
  constexpr float kSmallInOne = 28.0F;
  constexpr float kSmallest = 24.0F;
  constexpr auto kCount = static_cast<float>(kButtons.size() + 1);
  const float free = room - 2 * kToolbarPadding;
  const float in_one = (free - 3 * kLine) / kCount - kButtonGap;
  if (in_one >= kSmallInOne) return std::min(in_one, kLargest);
  return std::clamp((free - 2 * kLine) / std::ceil(0.5F * kCount) - kButtonGap, kSmallest, kLargest);
}

/// Places buttons below each other, continues in another column if there is no room below, and draws lines between
/// groups.
class Columns {
 public:
  Columns(float size, float unit, float room)
      : origin_(ImGui::GetCursorPos()), size_(size), gap_(kButtonGap * unit), room_(room) {}

  void next(bool begins_group) {
    const float line = begins_group && y_ > 0.0F ? 4 * gap_ : 0.0F;
    if (y_ > 0.0F && y_ + line + size_ > room_) {
      y_ = 0.0F;
      x_ += size_ + gap_;
    } else if (line > 0.0F) {
      const ImVec2 window = ImGui::GetWindowPos();
      const float at = window.y + origin_.y + y_ + 0.5F * (line - gap_);
      const float left = window.x + origin_.x + x_;
      ImGui::GetWindowDrawList()->AddLine({left, at}, {left + size_, at}, ImGui::GetColorU32(ImGuiCol_Separator),
                                          std::max(1.0F, 0.5F * gap_));
      y_ += line;
    }
    ImGui::SetCursorPos({origin_.x + x_, origin_.y + y_});
    y_ += size_ + gap_;
  }
  float width() const { return x_ + size_; }

 private:
  ImVec2 origin_;
  float size_;
  float gap_;
  float room_;
  float x_ = 0.0F;
  float y_ = 0.0F;
};

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
  const float size = button_size(room / unit) * unit;
  ImGui::SetNextWindowPos(at);
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {kToolbarPadding * unit, kToolbarPadding * unit});
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {0, 0});
  ImGui::Begin("##toolbar", nullptr,
               ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_AlwaysAutoResize |
                   ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoNav | ImGuiWindowFlags_NoFocusOnAppearing);
  Columns columns(size, unit, room - 2 * kToolbarPadding * unit);
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
