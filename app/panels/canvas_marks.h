// SPDX-License-Identifier: GPL-3.0-or-later
// Scale bar and axes of what the canvas shows between the panels.
#pragma once

#include "app/panels/pane_part.h"
#include "app/picture/picture.h"
#include "app/picture/scale_drawing.h"
#include "app/ui/gui.h"

namespace mes {

struct CanvasMarks {
  const Gui& gui;
  const Picture& picture;
  PanePart pane;

  /// In the pane that lies where the main one does from `low` to `high`, in screen coordinates, each `pixel_ratio` pixels
  /// wide. Where they are, from `low`.
  MarksPlace draw(const ScaleMarks& marks, ImVec2 low, ImVec2 high, double pixel_ratio) const;
};

}  // namespace mes
