// SPDX-License-Identifier: GPL-3.0-or-later
// Scale bar and axes for the part of the canvas between the panels.
#pragma once

#include <string>

#include "app/panels/on_canvas/pane_part.h"
#include "app/picture/picture.h"
#include "app/picture/scale_drawing.h"
#include "app/ui/gui.h"

namespace mes {

struct CanvasMarks {
  const Gui& gui;
  const Picture& picture;
  PanePart pane;
  std::string unit;  ///< of lengths, as `unit_of_lengths` gives it

  /// Draws in the pane that lies where the main one is, from `low` to `high` in screen coordinates, each unit of
  /// which is `pixel_ratio` pixels wide. Returns the positions of the marks relative to `low`.
  MarksPlace draw(const ScaleMarks& marks, ImVec2 low, ImVec2 high, double pixel_ratio) const;
};

}  // namespace mes
