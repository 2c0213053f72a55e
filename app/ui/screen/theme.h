// SPDX-License-Identifier: GPL-3.0-or-later
// The look of the panels: light or dark, quiet, legible from the last row of a lecture room.
#pragma once

#include "app/settings/settings.h"
#include "core/base/color.h"
#include "imgui.h"

namespace mes {

/// Every colour of the panels, by its purpose. The canvas has colours of its own (canvas_look.h). By the contrast ratio
/// of WCAG 2.2, text has at least 4.5 to 1 to what it is drawn on, and icons 3 to 1.
struct ThemeColors {
  bool is_dark = false;
  ImU32 text = 0;
  ImU32 text_quiet = 0;
  ImU32 text_faint = 0;  ///< for items that are off or unavailable
  ImU32 panel = 0;
  ImU32 raised = 0;  ///< popups, lists and pages
  ImU32 border = 0;
  ImU32 accent = 0;
  ImU32 accent_soft = 0;
  ImU32 accent_faint = 0;  ///< under the pointer
  ImU32 field = 0;
  ImU32 field_hovered = 0;
  ImU32 field_active = 0;
  ImU32 button = 0;
  ImU32 button_hovered = 0;
  ImU32 button_active = 0;
  ImU32 grab = 0;  ///< grip of sliders, behind the number
  ImU32 grab_active = 0;
  ImU32 scrollbar = 0;
  ImU32 scrollbar_hovered = 0;
  ImU32 scrollbar_active = 0;
  ImU32 dim = 0;  ///< over everything behind a dialog
  ImU32 warning = 0;
  ImU32 warning_soft = 0;
  ImU32 warning_border = 0;
  ImU32 recording = 0;
  ImU32 good = 0;
  ImU32 doubtful = 0;
  ImU32 wrong = 0;
};

/// The colours of a theme; for a projector with the strongest contrast.
ThemeColors theme_colors(Theme theme, bool for_projector);

/// Sets the colours and sizes of Dear ImGui's style, at `scale` units per logical pixel.
void apply_theme(ImGuiStyle& style, const ThemeColors& colors, float scale);

ImU32 to_imgui(Rgb color, double opacity = 1.0);
/// The colour as it is when opaque.
Rgb to_rgb(ImU32 color);

}  // namespace mes
