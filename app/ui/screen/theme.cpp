// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/ui/screen/theme.h"

#include <algorithm>

namespace mes {
namespace {

constexpr ImU32 rgb(unsigned hex, unsigned alpha = 0xFF) {
  return IM_COL32(hex >> 16U & 0xFFU, hex >> 8U & 0xFFU, hex & 0xFFU, alpha);
}

constexpr ThemeColors kLight{.is_dark = false,
                             .text = rgb(0x22262B),
                             .text_quiet = rgb(0x555C65),
                             .text_faint = rgb(0x60666E),
                             .panel = rgb(0xF7F8F9),
                             .raised = rgb(0xFFFFFF),
                             .border = rgb(0xDADEE3),
                             .accent = rgb(0x00659E),
                             .accent_soft = rgb(0x00659E, 0x22),
                             .accent_faint = rgb(0x00659E, 0x14),
                             .field = rgb(0xE9ECEF),
                             .field_hovered = rgb(0xE0E5EA),
                             .field_active = rgb(0xD5E4EF),
                             .button = rgb(0xE6EAEE),
                             .button_hovered = rgb(0xD9E7F1),
                             .button_active = rgb(0xBFD9EB),
                             .grab = rgb(0x2F7CAF),
                             .grab_active = rgb(0x1F6FA5),
                             .scrollbar = rgb(0x7B848E),
                             .scrollbar_hovered = rgb(0x6B747E),
                             .scrollbar_active = rgb(0x5A636D),
                             .dim = rgb(0x202830, 0x50),
                             .warning = rgb(0xA34300),
                             .warning_soft = rgb(0xFDF1E7),
                             .warning_border = rgb(0xE9B48C),
                             .recording = rgb(0xD0212B),
                             .good = rgb(0x009E73),
                             .doubtful = rgb(0xB57A00),
                             .wrong = rgb(0xD55E00)};

constexpr ThemeColors kDark{.is_dark = true,
                            .text = rgb(0xE6E9EC),
                            .text_quiet = rgb(0xB4BCC5),
                            .text_faint = rgb(0xA6AEB8),
                            .panel = rgb(0x24282D),
                            .raised = rgb(0x2B3036),
                            .border = rgb(0x3F464E),
                            .accent = rgb(0x74C2F2),
                            .accent_soft = rgb(0x74C2F2, 0x28),
                            .accent_faint = rgb(0x74C2F2, 0x18),
                            .field = rgb(0x383F47),
                            .field_hovered = rgb(0x414952),
                            .field_active = rgb(0x375064),
                            .button = rgb(0x3B424A),
                            .button_hovered = rgb(0x3A4B59),
                            .button_active = rgb(0x40637D),
                            .grab = rgb(0x6AAEDA),
                            .grab_active = rgb(0x86C5EC),
                            .scrollbar = rgb(0x8C96A1),
                            .scrollbar_hovered = rgb(0x9EA8B2),
                            .scrollbar_active = rgb(0xB4BCC5),
                            .dim = rgb(0x000000, 0x80),
                            .warning = rgb(0xFFA565),
                            .warning_soft = rgb(0x3D2E22),
                            .warning_border = rgb(0x7A5333),
                            .recording = rgb(0xFF5A5F),
                            .good = rgb(0x1FB88C),
                            .doubtful = rgb(0xF0B429),
                            .wrong = rgb(0xF07A2B)};

ImVec4 color(ImU32 packed) {
  return ImGui::ColorConvertU32ToFloat4(packed);
}

}  // namespace

ThemeColors theme_colors(Theme theme, bool for_projector) {
  ThemeColors out = theme == Theme::dark ? kDark : kLight;
  if (!for_projector) return out;
  out.text = out.is_dark ? rgb(0xFFFFFF) : rgb(0x000000);
  out.text_quiet = out.is_dark ? rgb(0xD0D6DC) : rgb(0x33383E);
  out.text_faint = out.is_dark ? rgb(0x8E97A1) : rgb(0x545A62);
  out.panel = out.raised = out.is_dark ? rgb(0x000000) : rgb(0xFFFFFF);
  out.border = out.is_dark ? rgb(0x8E97A1) : rgb(0x7C858F);
  out.accent = out.is_dark ? rgb(0x7CCBFF) : rgb(0x00568A);
  out.warning = out.is_dark ? rgb(0xFFB27A) : rgb(0x8F3A00);
  return out;
}

void apply_theme(ImGuiStyle& style, const ThemeColors& theme, float scale) {
  style = ImGuiStyle();
  if (theme.is_dark)
    ImGui::StyleColorsDark(&style);
  else
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
  style.DisabledAlpha = 0.7F;
  style.ScaleAllSizes(scale);
  style.WindowBorderSize = std::max(1.0F, style.WindowBorderSize);
  style.PopupBorderSize = std::max(1.0F, style.PopupBorderSize);

  auto& colors = style.Colors;
  colors[ImGuiCol_Text] = color(theme.text);
  colors[ImGuiCol_TextDisabled] = color(theme.text_quiet);
  colors[ImGuiCol_WindowBg] = color(theme.panel);
  colors[ImGuiCol_PopupBg] = color(theme.raised);
  colors[ImGuiCol_MenuBarBg] = color(theme.panel);
  colors[ImGuiCol_Border] = color(theme.border);
  colors[ImGuiCol_Separator] = color(theme.border);
  colors[ImGuiCol_FrameBg] = color(theme.field);
  colors[ImGuiCol_FrameBgHovered] = color(theme.field_hovered);
  colors[ImGuiCol_FrameBgActive] = color(theme.field_active);
  colors[ImGuiCol_TitleBg] = colors[ImGuiCol_TitleBgActive] = color(theme.panel);
  colors[ImGuiCol_Button] = color(theme.button);
  colors[ImGuiCol_ButtonHovered] = color(theme.button_hovered);
  colors[ImGuiCol_ButtonActive] = color(theme.button_active);
  colors[ImGuiCol_Header] = color(theme.accent_soft);
  colors[ImGuiCol_HeaderHovered] = color(theme.accent_faint);
  colors[ImGuiCol_HeaderActive] = color(theme.accent_soft);
  colors[ImGuiCol_CheckMark] = color(theme.accent);
  colors[ImGuiCol_SliderGrab] = color(theme.grab);
  colors[ImGuiCol_SliderGrabActive] = color(theme.grab_active);
  colors[ImGuiCol_PlotLinesHovered] = color(theme.warning);  // for refused numbers; no lines are plotted
  colors[ImGuiCol_PlotHistogram] = color(theme.accent);
  colors[ImGuiCol_TextSelectedBg] = color(theme.accent_soft);
  colors[ImGuiCol_ScrollbarBg] = {0, 0, 0, 0};
  colors[ImGuiCol_ScrollbarGrab] = color(theme.scrollbar);
  colors[ImGuiCol_ScrollbarGrabHovered] = color(theme.scrollbar_hovered);
  colors[ImGuiCol_ScrollbarGrabActive] = color(theme.scrollbar_active);
  colors[ImGuiCol_TableHeaderBg] = color(theme.field);
  colors[ImGuiCol_TableBorderLight] = colors[ImGuiCol_TableBorderStrong] = color(theme.border);
  // Differs from the row under the pointer, and from a chosen one.
  colors[ImGuiCol_TableRowBgAlt] = color(theme.text);
  colors[ImGuiCol_TableRowBgAlt].w = 0.035F;
  colors[ImGuiCol_DragDropTarget] = color(theme.accent);
  colors[ImGuiCol_NavHighlight] = color(theme.accent);
  colors[ImGuiCol_ModalWindowDimBg] = color(theme.dim);
}

ImU32 to_imgui(Rgb rgb, double opacity) {
  return IM_COL32(rgb.r, rgb.g, rgb.b, static_cast<int>(std::clamp(opacity, 0.0, 1.0) * 255.0 + 0.5));
}

Rgb to_rgb(ImU32 color) {
  const auto channel = [color](unsigned shift) { return static_cast<std::uint8_t>(color >> shift & 0xFFU); };
  return {channel(IM_COL32_R_SHIFT), channel(IM_COL32_G_SHIFT), channel(IM_COL32_B_SHIFT)};
}

}  // namespace mes
