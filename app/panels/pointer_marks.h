// SPDX-License-Identifier: GPL-3.0-or-later
// What the tool in use shows over the drawing: the sample under the pointer, a box, a ball being drawn, a measurement.
#pragma once

#include <optional>

#include "app/canvas/canvas.h"
#include "app/model/update_hold.h"
#include "app/panels/pane_part.h"
#include "app/ui/gui.h"
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

  /// Behind all panels.
  void draw() const;
  /// The places that the tool measures between, lines, the circle, and the numbers.
  void draw_measurement() const;
  /// The frame around what is selected, with its handles.
  void draw_frame() const;
  /// Dots where samples were put whose structures are behind, crosses where others were taken away.
  void draw_waiting(const UpdateHold& hold) const;
};

}  // namespace mes
