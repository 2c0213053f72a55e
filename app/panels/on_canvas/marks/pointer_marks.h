// SPDX-License-Identifier: GPL-3.0-or-later
// Marks of the current tool over the drawing: the sample under the pointer, a box, a ball being drawn, a measurement.
#pragma once

#include <optional>

#include "app/canvas/canvas.h"
#include "app/editing/update_hold.h"
#include "app/panels/on_canvas/marks/pane_part.h"
#include "app/ui/screen/gui.h"
#include "core/base/color.h"
#include "core/document/document.h"

namespace mes {

struct PointerMarks {
  const Gui& gui;
  const Canvas& canvas;
  const Document& document;
  Rgb color;
  std::optional<Rgb> background;
  PanePart pane;

  /// Draws behind all panels.
  void draw() const;
  /// Draws the points, lines, circle and numbers of a measurement.
  void draw_measurement() const;
  /// Draws the frame around the selection, with its handles.
  void draw_frame() const;
  /// Draws dots at inserted samples that the structures lack so far, and crosses at removed ones.
  void draw_waiting(const UpdateHold& hold) const;
};

}  // namespace mes
