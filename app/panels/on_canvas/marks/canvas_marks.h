// SPDX-License-Identifier: GPL-3.0-or-later
// Scale bar and axes for the part of the canvas between the panels.
#pragma once

#include <cstddef>
#include <functional>
#include <string>

#include "app/panels/on_canvas/marks/pane_part.h"
#include "app/picture/paper/scale_drawing.h"
#include "app/picture/picture.h"
#include "app/ui/screen/gui.h"

namespace mes {

struct CanvasMarks {
  const Gui& gui;
  const Picture& picture;
  PanePart pane;
  std::string unit;  ///< of lengths, as `unit_of_lengths` gives it

  /// Draws in the pane that lies where the main one is, from `low` to `high` in screen coordinates, each unit of
  /// which is `pixel_ratio` pixels wide. A bar without a position stands in the first corner where a box hides nothing
  /// by `hides` (logical pixels from `low`), or else in the lower left one. Returns the positions of the marks
  /// relative to `low`.
  MarksPlace draw(ScaleMarks marks, ImVec2 low, ImVec2 high, double pixel_ratio,
                  const std::function<std::size_t(const Box2&)>& hides = {}) const;
};

}  // namespace mes
