// SPDX-License-Identifier: GPL-3.0-or-later
// What every panel is made of: its frame, and the explanation of what lies under the pointer.
#pragma once

#include <span>
#include <string>

#include "app/ui/gui.h"

namespace mes {

/// A rectangle of the window, in screen coordinates.
struct PanelArea {
  ImVec2 at;
  ImVec2 size;
};

/// A fixed panel without title; pair with ImGui::End().
bool begin_panel(const char* name, const PanelArea& area, ImGuiWindowFlags extra = 0);

/// Opens as ImGui::BeginPopup does, but stays within the window: a popup that grows is moved, and one that is larger
/// gets a scrollbar.
bool begin_popup(const Gui& gui, const char* id);
/// The same for the popup of a right click on the last item.
bool begin_context_popup(const Gui& gui, const char* id);
/// To be called first in a popup that has its place from elsewhere.
void keep_in_window(const Gui& gui);

/// A place without a look of its own that can be clicked and dragged. What has no room counts as one pixel: the library
/// ends the program at an empty one, and a window may be smaller than it asked to be.
bool hit_area(const char* id, ImVec2 size);

/// The line between two panels, `area` wide or high, which can be dragged.
struct SplitterMove {
  bool is_dragged = false;
  ImVec2 to{};            ///< where the pointer is
  bool is_reset = false;  ///< by a double click
};
SplitterMove splitter(const Gui& gui, const char* id, const PanelArea& area);

/// A place over the canvas by which what is drawn there can be dragged. A double click resets it, and so does `back` in
/// the menu of the right button.
SplitterMove drag_handle(const Gui& gui, const char* id, const PanelArea& area, const std::string& explanation,
                         const char* back);

/// The text, or as much of its beginning as fits into the width with "...".
std::string elided(const std::string& text, float width);

/// A button that stands out where Enter presses it. Returns true when it was clicked.
bool default_button(const Gui& gui, const char* label, ImVec2 size, bool is_default);

/// A line of any number of points: the library numbers the corners of one line with 16 bits, so long ones are drawn in
/// parts.
void polyline(ImDrawList& list, std::span<const ImVec2> points, ImU32 color, bool is_closed, float thickness);

/// Explains the last item when the pointer rests on it, also when it is disabled.
void tooltip(const Gui& gui, const std::string& text);

}  // namespace mes
