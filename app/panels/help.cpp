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
  list.AddRectFilled(at, end, IM_COL32(0xF1, 0xF3, 0xF5, 0xFF), 4 * unit);
  list.AddRect(at, end, theme::kBorder, 4 * unit);
  list.AddText({at.x + 5 * unit, at.y + 2 * unit}, theme::kText, text.data(), text.data() + text.size());
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
  const float start = ImGui::GetCursorPosX();
  for (std::size_t i = 0; i < keys.size(); ++i) {
    if (i > 0) ImGui::SameLine(0, 4 * unit);
    key_cap(context, keys[i]);
  }
  if (keys.empty()) ImGui::Dummy({1, ImGui::GetTextLineHeight() + 4 * unit});
  ImGui::SameLine(start + text_at);
  ImGui::SetCursorPosY(ImGui::GetCursorPosY() + 2 * unit);
  ImGui::TextUnformatted(text.data(), text.data() + text.size());
}

void group(const PanelContext& context, ActionGroup which, float text_at) {
  heading(context, title_of(which));
  for (const ActionDescriptor& action : action_descriptors())
    if (action.group == which && !action.keys.empty()) row(context, action.keys, action.name, text_at);
}

}  // namespace

void draw_help(const PanelContext& context, bool* open) {
  if (!*open) return;
  const float unit = context.gui.unit();
  const ImVec2 screen = ImGui::GetIO().DisplaySize;
  const ImVec2 size(std::min(960 * unit, screen.x - 24 * unit), std::min(640 * unit, screen.y - 24 * unit));
  ImGui::SetNextWindowPos({0.5F * (screen.x - size.x), 0.5F * (screen.y - size.y)});
  ImGui::SetNextWindowSize(size);
  ImGui::PushStyleColor(ImGuiCol_WindowBg, IM_COL32_WHITE);
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {22 * unit, 16 * unit});
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {8 * unit, 4 * unit});
  if (!ImGui::IsPopupOpen("##help")) ImGui::OpenPopup("##help");
  if (ImGui::BeginPopupModal(
          "##help", nullptr,
          ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoSavedSettings)) {
    ImGui::PushFont(context.gui.bold());
    ImGui::TextUnformatted("Keys and gestures");
    ImGui::PopFont();
    ImGui::SameLine(size.x - 48 * unit);
    if (icon_button("close", Icon::close, 24 * unit, false, true)) *open = false;
    ImGui::BeginChild("page");
    const int columns = size.x > 820 * unit ? 3 : 2;
    if (ImGui::BeginTable("columns", columns, ImGuiTableFlags_SizingStretchSame)) {
      const float text_at = 118 * unit;
      ImGui::TableNextColumn();
      group(context, ActionGroup::file, text_at);
      group(context, ActionGroup::tools, text_at);
      group(context, ActionGroup::compute, text_at);
      group(context, ActionGroup::help, text_at);
      ImGui::TableNextColumn();
      group(context, ActionGroup::edit, 150 * unit);
      ImGui::TableNextColumn();
      group(context, ActionGroup::view, text_at);
      heading(context, "With the mouse");
      for (const GestureDescriptor& gesture : gesture_descriptors()) {
        key_cap(context, gesture.input);
        ImGui::TextWrapped("%.*s", static_cast<int>(gesture.meaning.size()), gesture.meaning.data());
      }
      ImGui::EndTable();
    }
    ImGui::EndChild();
    const bool beside = ImGui::IsMouseClicked(ImGuiMouseButton_Left) &&
                        !ImGui::IsWindowHovered(ImGuiHoveredFlags_RootAndChildWindows);
    if (beside) *open = false;
    if (!*open) ImGui::CloseCurrentPopup();
    ImGui::EndPopup();
  }
  ImGui::PopStyleVar(2);
  ImGui::PopStyleColor();
}

}  // namespace mes
