// SPDX-License-Identifier: GPL-3.0-or-later
// Annotations on the canvas, with a frame around the text of a pointed or chosen one.
#pragma once

#include <optional>

#include "app/editing/tools/annotation_editor.h"
#include "app/panels/on_canvas/marks/pane_part.h"
#include "app/picture/annotations/annotation_drawing.h"
#include "app/ui/screen/gui.h"

namespace mes {

struct CanvasAnnotations {
  const Gui& gui;
  double content_scale = 1.0;  ///< framebuffer pixels per logical pixel
  const Document& document;    ///< the document of the pane
  const AnnotationEditor& annotations;
  Rgb background;
  PanePart pane;

  /// The present layout, in logical pixels from the upper left corner of a window in which the pane has the position
  /// of the main pane.
  AnnotationDrawing layout() const;
  void draw(const AnnotationDrawing& drawn) const;
  /// `pointed_at`: the annotation that the tool would take.
  void draw_frames(const AnnotationDrawing& drawn, std::optional<std::size_t> pointed_at) const;
};

}  // namespace mes
