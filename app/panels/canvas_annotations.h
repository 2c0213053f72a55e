// SPDX-License-Identifier: GPL-3.0-or-later
// Annotations on the canvas, with a frame around the words of those that are pointed at or chosen.
#pragma once

#include <optional>

#include "app/editing/annotation_desk.h"
#include "app/panels/pane_part.h"
#include "app/picture/annotation_drawing.h"
#include "app/ui/gui.h"

namespace mes {

struct CanvasAnnotations {
  const Gui& gui;
  double content_scale = 1.0;  ///< framebuffer pixels per logical pixel
  const Document& document;    ///< that the pane shows
  const AnnotationDesk& desk;
  Rgb background;
  PanePart pane;

  /// As they are now, in logical pixels from the upper left corner of the window with the pane in the place of the main
  /// one.
  AnnotationDrawing layout() const;
  void draw(const AnnotationDrawing& drawn) const;
  /// `pointed_at`: the tool would take it.
  void draw_frames(const AnnotationDrawing& drawn, std::optional<std::size_t> pointed_at) const;
};

}  // namespace mes
