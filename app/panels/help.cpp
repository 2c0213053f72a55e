// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/panels/help.h"

#include <algorithm>
#include <initializer_list>
#include <string>

#include "app/panels/icons.h"
#include "app/window/theme.h"

namespace mes {
namespace {

void key_cap(const PanelContext& context, std::string_view text) {
  const float unit = context.gui.unit();
  const ImVec2 size = ImGui::CalcTextSize(text.data(), text.data() + text.size());
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const ImVec2 end(at.x + size.x + 10 * unit, at.y + size.y + 4 * unit);
  ImDrawList& list = *ImGui::GetWindowDrawList();
  list.AddRectFilled(at, end, context.gui.colors().field, 4 * unit);
  list.AddRect(at, end, context.gui.colors().border, 4 * unit);
  list.AddText({at.x + 5 * unit, at.y + 2 * unit}, context.gui.colors().text, text.data(), text.data() + text.size());
  ImGui::Dummy({end.x - at.x, end.y - at.y});
}

void heading(const PanelContext& context, std::string_view text) {
  ImGui::Dummy({0, 3 * context.gui.unit()});
  ImGui::PushFont(context.gui.bold());
  ImGui::TextUnformatted(text.data(), text.data() + text.size());
  ImGui::PopFont();
}

void row(const PanelContext& context, std::span<const std::string_view> keys, std::string_view text, float text_at) {
  const float unit = context.gui.unit();
  const ImVec2 start = ImGui::GetCursorScreenPos();
  for (std::size_t i = 0; i < keys.size(); ++i) {
    if (i > 0) ImGui::SameLine(0, 4 * unit);
    key_cap(context, keys[i]);
  }
  const ImVec2 after = ImGui::GetCursorScreenPos();
  ImGui::GetWindowDrawList()->AddText({start.x + text_at, start.y + 2 * unit}, context.gui.colors().text, text.data(),
                                      text.data() + text.size());
  ImGui::SetCursorScreenPos(after);
}

void group(const PanelContext& context, ActionGroup which, float text_at) {
  heading(context, title_of(which));
  for (const ActionDescriptor& action : action_descriptors())
    if (action.group == which && !action.keys.empty()) row(context, action.keys, action.name, text_at);
}

}  // namespace

void draw_help(const PanelContext& context, bool* open) {
  const float unit = context.gui.unit();
  const ImVec2 screen = ImGui::GetIO().DisplaySize;
  const ImVec2 size(std::min(1000 * unit, screen.x - 24 * unit), std::min(600 * unit, screen.y - 24 * unit));
  ImGui::SetNextWindowPos({0.5F * (screen.x - size.x), 0.5F * (screen.y - size.y)});
  ImGui::SetNextWindowSize(size);
  ImGui::PushStyleColor(ImGuiCol_WindowBg, context.gui.colors().raised);
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {22 * unit, 16 * unit});
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {8 * unit, 4 * unit});
  if (Gui::begin_dialog("##help", *open, ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove)) {
    ImGui::PushFont(context.gui.bold());
    ImGui::TextUnformatted("Keys and gestures");
    ImGui::PopFont();
    ImGui::SameLine(size.x - 48 * unit);
    if (icon_button("close", Icon::close, 24 * unit)) *open = false;
    ImGui::BeginChild("page");
    const int columns = size.x > 820 * unit ? 3 : 2;
    if (ImGui::BeginTable("columns", columns, ImGuiTableFlags_SizingStretchSame)) {
      ImGui::TableNextColumn();
      group(context, ActionGroup::file, 118 * unit);
      group(context, ActionGroup::tools, 118 * unit);
      group(context, ActionGroup::view, 118 * unit);
      ImGui::TableNextColumn();
      group(context, ActionGroup::edit, 168 * unit);
      group(context, ActionGroup::compute, 168 * unit);
      group(context, ActionGroup::help, 168 * unit);
      ImGui::TableNextColumn();
      heading(context, "With the mouse");
      for (const GestureDescriptor& gesture : gesture_descriptors()) {
        key_cap(context, gesture.input);
        ImGui::PushStyleColor(ImGuiCol_Text, context.gui.colors().text_quiet);
        ImGui::TextWrapped("%.*s", static_cast<int>(gesture.meaning.size()), gesture.meaning.data());
        ImGui::PopStyleColor();
        ImGui::Dummy({0, 2 * unit});
      }
      ImGui::EndTable();
    }
    ImGui::EndChild();
    const bool beside = ImGui::IsMouseClicked(ImGuiMouseButton_Left) &&
                        !ImGui::IsWindowHovered(ImGuiHoveredFlags_RootAndChildWindows);
    if (beside) *open = false;
    ImGui::EndPopup();
  }
  ImGui::PopStyleVar(2);
  ImGui::PopStyleColor();
}

}  // namespace mes
