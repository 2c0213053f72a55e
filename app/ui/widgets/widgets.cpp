// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/ui/widgets/widgets.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "app/ui/widgets/paragraph.h"
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

const ImGuiWindow& root_window() {
  return *ImGui::GetCurrentContext()->CurrentWindow->RootWindow;
}

void place_tooltip(const Gui& gui, const std::string& text, const PanelArea& panel) {
  const ImVec2 low = ImGui::GetItemRectMin();
  const ImVec2 high = ImGui::GetItemRectMax();
  const ImVec2 size = paragraph_window_size(text, kTooltipWidth * gui.unit());
  // Without this, Dear ImGui would draw the text in the size of the previous one for a frame.
  ImGui::SetNextWindowSize(size);
  const auto at = tooltip_place({.item = {low, {high.x - low.x, high.y - low.y}},
                                 .panel = panel,
                                 .is_dialog = (root_window().Flags & ImGuiWindowFlags_Modal) != 0,
                                 .size = size,
                                 .screen = ImGui::GetIO().DisplaySize,
                                 .gap = 6 * gui.unit()});
  if (at) ImGui::SetNextWindowPos(*at);
}

}  // namespace

std::optional<ImVec2> tooltip_place(const TooltipRoom& room) {
  const auto& [item, panel, is_dialog, size, screen, gap] = room;
  const auto kept = [](float at, float length, float end) {
    return std::clamp(at, 0.0F, std::max(0.0F, end - length));
  };
  const float level = kept(item.at.y + 0.5F * (item.size.y - size.y), size.y, screen.y);
  const auto left_of = [&](const PanelArea& area) { return ImVec2(area.at.x - gap - size.x, level); };
  const auto right_of = [&](const PanelArea& area) { return ImVec2(area.at.x + area.size.x + gap, level); };
  const float start = kept(item.at.x, size.x, screen.x);
  const auto above = [&](const PanelArea& area) { return ImVec2(start, area.at.y - gap - size.y); };
  const auto below = [&](const PanelArea& area) { return ImVec2(start, area.at.y + area.size.y + gap); };
  std::vector<ImVec2> places;
  constexpr float kWide = 0.6F;
  if (!is_dialog && panel.size.x > kWide * screen.x) {
    const bool is_low = panel.at.y + 0.5F * panel.size.y > 0.5F * screen.y;
    places = {is_low ? above(panel) : below(panel)};
  } else if (!is_dialog) {
    const bool is_right = panel.at.x + 0.5F * panel.size.x > 0.5F * screen.x;
    places = {is_right ? left_of(panel) : right_of(panel), is_right ? right_of(panel) : left_of(panel)};
  }
  places.insert(places.end(), {right_of(item), left_of(item), below(item), above(item)});
  const auto fits = std::ranges::find_if(places, [&](ImVec2 at) {
    return at.x >= 0.0F && at.y >= 0.0F && at.x + size.x <= screen.x && at.y + size.y <= screen.y;
  });
  return fits == places.end() ? std::nullopt : std::optional(*fits);
}

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
  if (!ImGui::BeginPopup(id, ImGuiWindowFlags_HorizontalScrollbar)) return false;
  keep_in_window(gui);
  return true;
}

bool begin_context_popup(const Gui& gui, const char* id) {
  ImGui::OpenPopupOnItemClick(id);
  return begin_popup(gui, id);
}

namespace {
/// Draws a rim around a box or a circle, whose ground hardly differs from that of the panel.
template <class Draw>
bool with_rim(Draw draw) {
  constexpr float kEdgeOfLetters = 1.0F / 16.0F;
  ImGui::PushStyleColor(ImGuiCol_Border, ImGui::GetStyleColorVec4(ImGuiCol_TextDisabled));
  ImGui::PushStyleVar(ImGuiStyleVar_FrameBorderSize, std::max(1.0F, kEdgeOfLetters * ImGui::GetFontSize()));
  const bool is_changed = draw();
  ImGui::PopStyleVar();
  ImGui::PopStyleColor();
  return is_changed;
}
}  // namespace

void heading(const Gui& gui, const std::string& text) {
  ImGui::PushFont(gui.bold());
  paragraph(text);
  ImGui::PopFont();
}

bool checkbox(const char* label, bool* value) {
  return with_rim([&] { return ImGui::Checkbox(label, value); });
}

bool radio_button(const char* label, bool is_chosen) {
  return with_rim([&] { return ImGui::RadioButton(label, is_chosen); });
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

bool is_marked_by_key() {
  return ImGui::IsItemFocused() && !ImGui::GetCurrentContext()->NavDisableHighlight;
}

bool is_default_pressed() {
  const ImGuiContext& context = *ImGui::GetCurrentContext();
  const auto is_pressed = [](ImGuiKey key) { return ImGui::IsKeyPressed(ImGui::GetKeyIndex(key), false); };
  return context.ActiveId == 0 && context.ActiveIdPreviousFrame == 0 && context.NavDisableHighlight &&
         (is_pressed(ImGuiKey_Enter) || is_pressed(ImGuiKey_KeyPadEnter));
}

bool is_left_by_escape() {
  return ImGui::IsItemDeactivated() && ImGui::IsKeyPressed(ImGui::GetKeyIndex(ImGuiKey_Escape));
}

void tooltip(const Gui& gui, const std::string& text) {
  const ImRect panel = root_window().OuterRectClipped;
  tooltip(gui, text, {panel.Min, panel.GetSize()});
}

void tooltip(const Gui& gui, const std::string& text, const PanelArea& panels) {
  if (text.empty() || !gui.is_resting() || !ImGui::IsItemHovered(ImGuiHoveredFlags_AllowWhenDisabled)) return;
  place_tooltip(gui, text, panels);
  ImGui::BeginTooltip();
  paragraph(text, kTooltipWidth * gui.unit());
  ImGui::EndTooltip();
}

void action_item(const Gui& gui, const ActionBindings& actions, ActionId id, const std::string& label) {
  const ActionDescriptor& action = descriptor_of(id);
  // A menu wider than the window would lose its keys.
  constexpr float kMostOfWindow = 0.56F;
  const std::string name = elided(label.empty() ? action.name : label, kMostOfWindow * ImGui::GetIO().DisplaySize.x);
  if (ImGui::MenuItem(name.c_str(), actions.keymap().key_of(id).c_str(), actions.is_checked(id),
                      actions.is_enabled(id)))
    actions.run(id);
  const std::string why = actions.missing(id);
  tooltip(gui, action.tooltip + (why.empty() ? "" : "\nNot possible now: " + why));
}

}  // namespace mes
