// SPDX-License-Identifier: GPL-3.0-or-later
// Texts of several lines.
#pragma once

#include <string>
#include <string_view>

#include "imgui.h"

namespace mes {

/// The text with line breaks, so that no line is wider than `width`, in screen coordinates. It breaks lines at spaces
/// only, and within a word that is wider than a line. Dear ImGui would also break numbers, after their point.
std::string broken_lines(std::string_view text, float width);

/// Draws the text in lines of at most this width. A width of 0 is the room to the edge of the window.
void paragraph(std::string_view text, float width = 0.0F);
/// The same in the colour of remarks.
void quiet_paragraph(std::string_view text, float width = 0.0F);
/// The size of a window that contains only this paragraph.
ImVec2 paragraph_window_size(std::string_view text, float width);

}  // namespace mes
