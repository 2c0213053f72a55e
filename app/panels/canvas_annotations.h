// SPDX-License-Identifier: GPL-3.0-or-later
// Annotations on the canvas, with a frame around the words of those that are pointed at or chosen.
#pragma once

#include <optional>

#include "app/canvas/canvas.h"
#include "app/model/annotation_desk.h"
#include "app/picture/annotation_drawing.h"
#include "app/ui/gui.h"

namespace mes {

struct CanvasAnnotations {
  const Gui& gui;
  const Canvas& canvas;
  const Document& document;
  const AnnotationDesk& desk;
  Rgb background;
  ImVec2 shift{};  ///< from the main pane to the one that is drawn in, in screen coordinates

  /// As they are now, in logical pixels from the upper left corner of the window.
  AnnotationDrawing layout() const;
  /// `pointed_at`: the tool would take it.
  void draw(const AnnotationDrawing& drawn, std::optional<std::size_t> pointed_at) const;
};

}  // namespace mes
