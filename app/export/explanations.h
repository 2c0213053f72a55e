// SPDX-License-Identifier: GPL-3.0-or-later
// Annotations, scale marks and legend of a picture, laid out: the same in pixels and on a page.
//
// Cost: O(primitives of the layers), to find where a legend hides least. Threads: any.
#pragma once

#include <span>

#include "app/export/figure.h"
#include "app/picture/annotations/annotation_drawing.h"
#include "app/picture/paper/legend_place.h"
#include "app/picture/paper/scale_drawing.h"

namespace mes {

struct Explanations {
  AnnotationDrawing annotated;
  ScaleMarks marks;  ///< with the position of the scale bar
  SeenPlane plane;   ///< of the marks
  PlacedLegend legend;
};

/// `plane` is the part of the plane in the whole picture, at whose upper edge a title has `title_height`.
Explanations explain(const FigureRequest& request, const FigureSource& source, const SeenPlane& plane,
                     double title_height, std::span<const LegendEntry> entries, const LegendStrip& strip,
                     const PaperFonts& fonts);

}  // namespace mes
