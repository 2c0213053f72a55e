// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/ui/widgets.h"

#include <algorithm>
#include <cmath>

#include "app/ui/note.h"
#include "imgui_internal.h"

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

namespace {

constexpr float kEdge = 6.0F;  // distance between a popup and the edge of the window, in logical pixels

void limit_size(const Gui& gui) {
  const ImVec2 screen = ImGui::GetIO().DisplaySize;
  const float edges = 2 * kEdge * gui.unit();
  ImGui::SetNextWindowSizeConstraints({0, 0}, {std::max(1.0F, screen.x - edges), std::max(1.0F, screen.y - edges)});
}

}  // namespace

namespace {

constexpr float kTooltipWidth = 340.0F;  // width of the text, in logical pixels

// Places the tooltip beside the panel or popup of the last item, towards the middle of the window; above or below a
// wide one. If there is no room, Dear ImGui places it at the pointer.
void place_tooltip(const Gui& gui, const std::string& text) {
  const float unit = gui.unit();
  const float gap = 6 * unit;
  const ImVec2 screen = ImGui::GetIO().DisplaySize;
  const ImVec2 item_low = ImGui::GetItemRectMin();
  const ImVec2 item_high = ImGui::GetItemRectMax();
  const ImRect panel = ImGui::GetCurrentContext()->CurrentWindow->RootWindow->OuterRectClipped;
  const ImVec2 size = note_size(text, kTooltipWidth * unit);
  // Without this, Dear ImGui would draw the text in the size of the previous one for a frame.
  ImGui::SetNextWindowSize(size);
  ImVec2 at;
  if (panel.GetWidth() > 0.6F * screen.x) {
    const bool is_low = panel.GetCenter().y > 0.5F * screen.y;
    at = {std::min(item_low.x, screen.x - gap - size.x), is_low ? panel.Min.y - gap - size.y : panel.Max.y + gap};
    if (at.y < 0.0F || at.y + size.y > screen.y) return;
  } else {
    const bool fits_left = panel.Min.x - gap - size.x >= 0.0F;
    const bool fits_right = panel.Max.x + gap + size.x <= screen.x;
    if (!fits_left && !fits_right) return;
    const bool prefers_left = panel.GetCenter().x > 0.5F * screen.x;
    const bool is_left = fits_left && (prefers_left || !fits_right);
    at.x = is_left ? panel.Min.x - gap - size.x : panel.Max.x + gap;
    const float middle = 0.5F * (item_low.y + item_high.y);
    at.y = std::clamp(middle - 0.5F * size.y, gap, std::max(gap, screen.y - gap - size.y));
  }
  ImGui::SetNextWindowPos(at);
}

}  // namespace

void keep_in_window(const Gui& gui) {
  const ImVec2 screen = ImGui::GetIO().DisplaySize;
  const float edge = kEdge * gui.unit();
  const ImVec2 at = ImGui::GetWindowPos();
  const ImVec2 size = ImGui::GetWindowSize();
  const auto kept = [edge](float place, float length, float end) {
    return std::max(edge, std::min(place, end - edge - length));
  };
  const ImVec2 better(kept(at.x, size.x, screen.x), kept(at.y, size.y, screen.y));
  if (better.x != at.x || better.y != at.y) ImGui::SetWindowPos(better);
}

bool begin_popup(const Gui& gui, const char* id) {
  limit_size(gui);
  if (!ImGui::BeginPopup(id)) return false;
  keep_in_window(gui);
  return true;
}

bool begin_context_popup(const Gui& gui, const char* id) {
  limit_size(gui);
  if (!ImGui::BeginPopupContextItem(id)) return false;
  keep_in_window(gui);
  return true;
}

bool default_button(const Gui& gui, const char* label, ImVec2 size, bool is_default) {
  if (!is_default) return ImGui::Button(label, size);
  ImGui::PushStyleColor(ImGuiCol_Button, gui.colors().accent_soft);
  ImGui::PushStyleColor(ImGuiCol_Border, gui.colors().accent);
  ImGui::PushStyleVar(ImGuiStyleVar_FrameBorderSize, std::max(1.0F, 1.5F * gui.unit()));
  const bool is_clicked = ImGui::Button(label, size);
  ImGui::PopStyleVar();
  ImGui::PopStyleColor(2);
  return is_clicked;
}

bool hit_area(const char* id, ImVec2 size) {
  return ImGui::InvisibleButton(id, {std::max(1.0F, size.x), std::max(1.0F, size.y)});
}

SplitterMove splitter(const Gui& gui, const char* id, const PanelArea& area) {
  const bool is_upright = area.size.y > area.size.x;
  const float reach = 3 * gui.unit();
  const ImVec2 low(area.at.x - (is_upright ? reach : 0.0F), area.at.y - (is_upright ? 0.0F : reach));
  const ImVec2 size(is_upright ? 2 * reach : area.size.x, is_upright ? area.size.y : 2 * reach);
  ImGui::SetNextWindowPos(low);
  ImGui::SetNextWindowSize(size);
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {0, 0});
  ImGui::PushStyleVar(ImGuiStyleVar_WindowMinSize, {1, 1});
  ImGui::PushStyleVar(ImGuiStyleVar_WindowBorderSize, 0.0F);
  ImGui::Begin(id, nullptr,
               ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoBackground |
                   ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoNav | ImGuiWindowFlags_NoFocusOnAppearing);
  hit_area("line", size);
  const bool is_active = ImGui::IsItemActive();
  if (is_active || ImGui::IsItemHovered()) {
    ImGui::SetMouseCursor(is_upright ? ImGuiMouseCursor_ResizeEW : ImGuiMouseCursor_ResizeNS);
    const float line = std::max(1.0F, 2 * gui.unit());
    const ImVec2 from(low.x + (is_upright ? reach - 0.5F * line : 0.0F),
                      low.y + (is_upright ? 0.0F : reach - 0.5F * line));
    ImGui::GetWindowDrawList()->AddRectFilled(
        from, {is_upright ? from.x + line : low.x + size.x, is_upright ? low.y + size.y : from.y + line},
        gui.colors().accent);
  }
  const bool is_reset = ImGui::IsItemHovered() && ImGui::IsMouseDoubleClicked(ImGuiMouseButton_Left);
  const bool is_dragged = is_active && !is_reset && ImGui::IsMouseDragging(ImGuiMouseButton_Left, 1.0F);
  ImGui::End();
  ImGui::PopStyleVar(3);
  return {is_dragged, ImGui::GetIO().MousePos, is_reset};
}

SplitterMove drag_handle(const Gui& gui, const char* id, const PanelArea& area, const std::string& explanation,
                         const char* back) {
  ImGui::SetNextWindowPos(area.at);
  ImGui::SetNextWindowSize(area.size);
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {0, 0});
  ImGui::PushStyleVar(ImGuiStyleVar_WindowBorderSize, 0.0F);
  ImGui::Begin(id, nullptr,
               ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoBackground |
                   ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoNav | ImGuiWindowFlags_NoFocusOnAppearing |
                   ImGuiWindowFlags_NoBringToFrontOnFocus);
  hit_area("handle", area.size);
  const bool is_active = ImGui::IsItemActive();
  bool is_reset = ImGui::IsItemHovered() && ImGui::IsMouseDoubleClicked(ImGuiMouseButton_Left);
  if (is_active || ImGui::IsItemHovered()) ImGui::SetMouseCursor(ImGuiMouseCursor_ResizeAll);
  // Tooltip and menu have a border and a margin. During a drag the tooltip would be in the way.
  ImGui::PopStyleVar(2);
  if (!is_active) tooltip(gui, explanation);
  if (begin_context_popup(gui, "menu")) {
    if (ImGui::MenuItem(back)) is_reset = true;
    ImGui::EndPopup();
  }
  ImGui::End();
  return {is_active && !is_reset, ImGui::GetIO().MousePos, is_reset};
}

std::string elided(const std::string& text, float width) {
  static constexpr const char* kDots = "\u2026";
  if (ImGui::CalcTextSize(text.c_str()).x <= width) return text;
  const float room = width - ImGui::CalcTextSize(kDots).x;
  const char* end = nullptr;
  ImGui::GetFont()->CalcTextSizeA(ImGui::GetFontSize(), std::max(0.0F, room), 0.0F, text.c_str(), nullptr, &end);
  std::string out(text.c_str(), end);
  while (out.ends_with(' ')) out.pop_back();
  return out + kDots;
}

void polyline(ImDrawList& list, std::span<const ImVec2> points, ImU32 color, bool is_closed, float thickness) {
  constexpr std::size_t kMost = 8000;
  if (points.size() <= kMost) {
    list.AddPolyline(points.data(), static_cast<int>(points.size()), color,
                     is_closed ? ImDrawFlags_Closed : ImDrawFlags_None, thickness);
    return;
  }
  for (std::size_t first = 0; first + 1 < points.size(); first += kMost - 1) {
    const std::size_t count = std::min(kMost, points.size() - first);
    list.AddPolyline(points.data() + first, static_cast<int>(count), color, ImDrawFlags_None, thickness);
  }
  if (is_closed) list.AddLine(points.back(), points.front(), color, thickness);
}

void tooltip(const Gui& gui, const std::string& text) {
  if (text.empty() || !gui.is_resting() || !ImGui::IsItemHovered(ImGuiHoveredFlags_AllowWhenDisabled)) return;
  place_tooltip(gui, text);
  ImGui::BeginTooltip();
  note(text, kTooltipWidth * gui.unit());
  ImGui::EndTooltip();
}

void action_item(const Gui& gui, const ActionBindings& actions, ActionId id, const std::string& label) {
  const ActionDescriptor& action = descriptor_of(id);
  const std::string name = label.empty() ? action.name : label;
  if (ImGui::MenuItem(name.c_str(), actions.keymap().key_of(id).c_str(), actions.is_checked(id),
                      actions.is_enabled(id)))
    actions.run(id);
  const std::string why = actions.missing(id);
  tooltip(gui, action.tooltip + (why.empty() ? "" : "\nNot possible now: " + why));
}

}  // namespace mes
