// SPDX-License-Identifier: GPL-3.0-or-later
// Draws rectangles, dots and text above the canvas and below the panels.
#pragma once

#include "app/picture/paper/paper_drawing.h"
#include "app/ui/screen/gui.h"

namespace mes {

/// Measures text in the fonts of the window.
MeasureText measure_on_canvas(const Gui& gui);

/// `corner` is in screen coordinates.
void paint(ImDrawList& list, const Gui& gui, const PaperDrawing& drawing, ImVec2 corner);
/// The same above the canvas and below all panels.
void paint_on_canvas(const Gui& gui, const PaperDrawing& drawing, ImVec2 corner);

}  // namespace mes
