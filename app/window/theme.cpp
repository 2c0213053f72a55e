// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/window/theme.h"

#include <algorithm>

namespace mes {
namespace {

ImVec4 color(ImU32 packed) {
  return ImGui::ColorConvertU32ToFloat4(packed);
}

}  // namespace

void apply_theme(ImGuiStyle& style, float scale) {
  style = ImGuiStyle();
  ImGui::StyleColorsLight(&style);
  style.WindowPadding = {10, 8};
  style.FramePadding = {8, 4};
  style.ItemSpacing = {8, 6};
  style.ItemInnerSpacing = {6, 4};
  style.CellPadding = {6, 2};
  style.ScrollbarSize = 11;
  style.GrabMinSize = 10;
  style.WindowRounding = 7;
  style.ChildRounding = 5;
  style.FrameRounding = 5;
  style.PopupRounding = 6;
  style.GrabRounding = 5;
  style.ScrollbarRounding = 6;
  style.WindowBorderSize = 1;
  style.PopupBorderSize = 1;
  style.FrameBorderSize = 0;
  style.WindowTitleAlign = {0.0F, 0.5F};
  style.DisabledAlpha = 0.45F;
  style.ScaleAllSizes(scale);
  style.WindowBorderSize = std::max(1.0F, style.WindowBorderSize);
  style.PopupBorderSize = std::max(1.0F, style.PopupBorderSize);

  auto& colors = style.Colors;
  colors[ImGuiCol_Text] = color(theme::kText);
  colors[ImGuiCol_TextDisabled] = color(theme::kTextQuiet);
  colors[ImGuiCol_WindowBg] = color(theme::kPanel);
  colors[ImGuiCol_PopupBg] = color(IM_COL32(0xFF, 0xFF, 0xFF, 0xFF));
  colors[ImGuiCol_MenuBarBg] = color(theme::kPanel);
  colors[ImGuiCol_Border] = color(theme::kBorder);
  colors[ImGuiCol_Separator] = color(theme::kBorder);
  colors[ImGuiCol_FrameBg] = color(IM_COL32(0xE9, 0xEC, 0xEF, 0xFF));
  colors[ImGuiCol_FrameBgHovered] = color(IM_COL32(0xE0, 0xE5, 0xEA, 0xFF));
  colors[ImGuiCol_FrameBgActive] = color(IM_COL32(0xD5, 0xE4, 0xEF, 0xFF));
  colors[ImGuiCol_TitleBg] = colors[ImGuiCol_TitleBgActive] = color(theme::kPanel);
  colors[ImGuiCol_Button] = color(IM_COL32(0xE6, 0xEA, 0xEE, 0xFF));
  colors[ImGuiCol_ButtonHovered] = color(IM_COL32(0xD9, 0xE7, 0xF1, 0xFF));
  colors[ImGuiCol_ButtonActive] = color(IM_COL32(0xBF, 0xD9, 0xEB, 0xFF));
  colors[ImGuiCol_Header] = color(theme::kAccentSoft);
  colors[ImGuiCol_HeaderHovered] = color(IM_COL32(0x00, 0x72, 0xB2, 0x1A));
  colors[ImGuiCol_HeaderActive] = color(IM_COL32(0x00, 0x72, 0xB2, 0x38));
  colors[ImGuiCol_CheckMark] = color(theme::kAccent);
  // Pale, because the number is written over it.
  colors[ImGuiCol_SliderGrab] = color(IM_COL32(0x9C, 0xC8, 0xE4, 0xFF));
  colors[ImGuiCol_SliderGrabActive] = color(IM_COL32(0x7C, 0xB6, 0xDA, 0xFF));
  colors[ImGuiCol_PlotHistogram] = color(theme::kAccent);
  colors[ImGuiCol_TextSelectedBg] = color(IM_COL32(0x00, 0x72, 0xB2, 0x40));
  colors[ImGuiCol_ScrollbarBg] = color(IM_COL32(0, 0, 0, 0));
  colors[ImGuiCol_ScrollbarGrab] = color(IM_COL32(0xC6, 0xCC, 0xD3, 0xFF));
  colors[ImGuiCol_ScrollbarGrabHovered] = color(IM_COL32(0xAC, 0xB4, 0xBD, 0xFF));
  colors[ImGuiCol_ScrollbarGrabActive] = color(IM_COL32(0x8E, 0x98, 0xA3, 0xFF));
  colors[ImGuiCol_TableHeaderBg] = color(IM_COL32(0xEE, 0xF0, 0xF3, 0xFF));
  colors[ImGuiCol_TableBorderLight] = colors[ImGuiCol_TableBorderStrong] = color(theme::kBorder);
  colors[ImGuiCol_TableRowBgAlt] = color(IM_COL32(0, 0, 0, 0x06));
  colors[ImGuiCol_DragDropTarget] = color(theme::kAccent);
  colors[ImGuiCol_ModalWindowDimBg] = color(IM_COL32(0x20, 0x28, 0x30, 0x50));
}

ImU32 to_imgui(Rgb rgb, double opacity) {
  return IM_COL32(rgb.r, rgb.g, rgb.b, static_cast<int>(std::clamp(opacity, 0.0, 1.0) * 255.0 + 0.5));
}

}  // namespace mes
