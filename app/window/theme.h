// SPDX-License-Identifier: GPL-3.0-or-later
// How the panels look: light, quiet, legible from the last row of a lecture room.
#pragma once

#include "core/base/color.h"
#include "imgui.h"

namespace mes {

namespace theme {
inline constexpr ImU32 kText = IM_COL32(0x22, 0x26, 0x2B, 0xFF);
inline constexpr ImU32 kTextQuiet = IM_COL32(0x6B, 0x73, 0x7D, 0xFF);
inline constexpr ImU32 kPanel = IM_COL32(0xF7, 0xF8, 0xF9, 0xFF);
inline constexpr ImU32 kBorder = IM_COL32(0xDA, 0xDE, 0xE3, 0xFF);
inline constexpr ImU32 kAccent = IM_COL32(0x00, 0x72, 0xB2, 0xFF);
inline constexpr ImU32 kAccentSoft = IM_COL32(0x00, 0x72, 0xB2, 0x22);
inline constexpr ImU32 kWarning = IM_COL32(0xB4, 0x4A, 0x00, 0xFF);
inline constexpr ImU32 kRecording = IM_COL32(0xD0, 0x21, 0x2B, 0xFF);
inline constexpr ImU32 kWarningSoft = IM_COL32(0xFD, 0xF1, 0xE7, 0xFF);
}  // namespace theme

/// Colours and measures of Dear ImGui's style for `scale` units per logical pixel.
void apply_theme(ImGuiStyle& style, float scale);

ImU32 to_imgui(Rgb color, double opacity = 1.0);

}  // namespace mes
