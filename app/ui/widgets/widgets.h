// SPDX-License-Identifier: GPL-3.0-or-later
// The common parts of all panels: their frames, and explanations of the item under the pointer.
#pragma once

#include <algorithm>
#include <cstddef>
#include <optional>
#include <span>
#include <string>

#include "app/actions/action_bindings.h"
#include "app/ui/screen/gui.h"

namespace mes {

/// A rectangle of the window, in screen coordinates.
struct PanelArea {
  ImVec2 at;
  ImVec2 size;
};

/// Begins a fixed panel without title; pair it with ImGui::End().
bool begin_panel(const char* name, const PanelArea& area, ImGuiWindowFlags extra = 0);

/// Opens as ImGui::BeginPopup does, but stays within the window: a popup that grows is moved, and one that is larger
/// gets scrollbars.
bool begin_popup(const Gui& gui, const char* id);
/// The same for the popup of a right click on the last item.
bool begin_context_popup(const Gui& gui, const char* id);
/// Call it first in a popup whose position is set elsewhere.
void keep_in_window(const Gui& gui);

/// An invisible area that can be clicked and dragged. It is at least one pixel large: Dear ImGui ends the program at
/// an empty one, and a window may be smaller than it asked to be.
bool hit_area(const char* id, ImVec2 size);

/// The line between two panels, as long as `area` is wide or high, which can be dragged.
struct SplitterMove {
  bool is_dragged = false;
  ImVec2 to{};            ///< position of the pointer
  bool is_reset = false;  ///< true after a double click
};
SplitterMove splitter(const Gui& gui, const char* id, const PanelArea& area);

/// An area over the canvas by which a drawing there can be dragged. A double click resets the drawing, and so does
/// `back` in the menu of the right button.
SplitterMove drag_handle(const Gui& gui, const char* id, const PanelArea& area, const std::string& explanation,
                         const char* back);

/// The title of a dialog: a bold line.
void heading(const Gui& gui, const std::string& text);

/// As ImGui::Checkbox, with an edge that can be seen while it is not checked.
bool checkbox(const char* label, bool* value);
/// A radio button of the same look. Returns true when it is clicked.
bool radio_button(const char* label, bool is_chosen);

/// The text, or as much of its beginning as fits into the width, with "...".
std::string elided(const std::string& text, float width);

/// Draws a button, which stands out if Enter presses it. Returns true when it is clicked.
bool default_button(const Gui& gui, const char* label, ImVec2 size, bool is_default);

/// A line of any number of points: Dear ImGui numbers the corners of one line with 16 bits, so long lines are drawn
/// in parts.
void polyline(ImDrawList& list, std::span<const ImVec2> points, ImU32 color, bool is_closed, float thickness);

/// The boxes that a tooltip is placed by, in screen coordinates.
struct TooltipRoom {
  PanelArea item;   ///< the explained control
  PanelArea panel;  ///< the panel, popup or dialog that it is in
  bool is_dialog = false;
  ImVec2 size;    ///< of the tooltip
  ImVec2 screen;  ///< size of the window
  float gap = 0.0F;
};
/// The upper left corner of the tooltip. It stands beside its panel, towards the middle of the window, or above or
/// below a wide panel. In a dialog, and where the panel leaves no room, it stands beside the control. It stays within
/// the window and does not cover the control; the result is empty if that is impossible.
std::optional<ImVec2> tooltip_place(const TooltipRoom& room);

/// The row so many rows after another one of `count`, the first or the last if there are fewer.
inline std::size_t row_beside(std::ptrdiff_t row, std::ptrdiff_t steps, std::size_t count) {
  return static_cast<std::size_t>(std::clamp<std::ptrdiff_t>(row + steps, 0, static_cast<std::ptrdiff_t>(count) - 1));
}

/// Explains the last item when the pointer rests on it, even if it is disabled.
void tooltip(const Gui& gui, const std::string& text);
/// The same for an item of a panel that lies in `panels` together with others, which should not be covered either.
void tooltip(const Gui& gui, const std::string& text, const PanelArea& panels);

/// True if Esc ended the writing in the field that was drawn last. Dear ImGui restores the initial text then; the text
/// that the field had before it was drawn is what was typed.
bool is_left_by_escape();
/// True if arrow keys have marked the item that was drawn last.
bool is_marked_by_key();
/// True in the frame in which Enter presses the default button of a popup: it left no field and presses no marked item.
bool is_default_pressed();

/// A row of a menu that runs an action of the table: its name or `label`, its key, and its tooltip with the reason if
/// it is not possible now.
void action_item(const Gui& gui, const ActionBindings& actions, ActionId id, const std::string& label = {});

}  // namespace mes
