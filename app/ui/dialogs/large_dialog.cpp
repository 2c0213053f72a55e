// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/ui/dialogs/large_dialog.h"

#include <algorithm>

namespace mes {
namespace {

// Logical pixels.
constexpr float kBetweenColumns = 14.0F;
constexpr float kLeastPreview = 130.0F;
constexpr float kLowList = 110.0F;  // height of a list above the settings
constexpr float kLowPreview = 220.0F;

// Draws what scrolls, then the buttons below it.
void above_foot(const Gui& gui, const DialogFoot& foot, const std::function<void()>& draw) {
  ButtonRows buttons(gui, foot.labels, ImGui::GetContentRegionAvail().x);
  ImGui::BeginChild("choices", {0, -buttons.height()}, false,
                    ImGuiWindowFlags_HorizontalScrollbar | ImGuiWindowFlags_NavFlattened);
  draw();
  ImGui::EndChild();
  foot.draw(buttons);
}

}  // namespace

void large_dialog(const Gui& gui, const char* id, bool is_open, ImVec2 size, DialogKeys keys,
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
  if (Gui::begin_dialog(id, is_open, ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove, keys)) {
    draw(here);
    ImGui::EndPopup();
  }
  ImGui::PopStyleVar(2);
}

void dialog_columns(const Gui& gui, std::span<const DialogColumn> columns, const DialogFoot& foot) {
  const float unit = gui.unit();
  const float gap = kBetweenColumns * unit;
  const DialogColumn& settings = columns[columns.size() - 2];
  float least = kLeastPreview * unit;
  for (const DialogColumn& column : columns.first(columns.size() - 1)) least += column.width * unit + gap;
  if (least > ImGui::GetContentRegionAvail().x) {
    above_foot(gui, foot, [&] {
      for (const DialogColumn& column : columns) {
        // The settings are as high as their contents.
        const bool is_settings = &column == &settings;
        if (!is_settings)
          ImGui::BeginChild(column.id, {0, (&column == &columns.back() ? kLowPreview : kLowList) * unit}, false,
                            ImGuiWindowFlags_NavFlattened);
        column.draw();
        if (!is_settings) ImGui::EndChild();
        ImGui::Dummy({1, 4 * unit});
      }
    });
    return;
  }
  for (const DialogColumn& column : columns) {
    ImGui::BeginChild(column.id, {column.width * unit, 0}, false, ImGuiWindowFlags_NavFlattened);
    if (&column == &settings)
      above_foot(gui, foot, column.draw);
    else
      column.draw();
    ImGui::EndChild();
    if (&column != &columns.back()) ImGui::SameLine(0, gap);
  }
}

}  // namespace mes
