// SPDX-License-Identifier: GPL-3.0-or-later
// Highlighted elements of annotations, as they are drawn.
//
// Smallest use:
//     HighlightPen pen(drawing, plane);
//     for (const HighlightedShape& shape : highlighted_shapes(annotation, document)) pen.draw(shape);
//
// Cost: microseconds an element. Threads: any, with a drawing of its own.
#pragma once

#include <vector>

#include "app/picture/plane_drawing.h"
#include "core/document/annotation.h"
#include "core/document/document.h"
#include "core/draw/provenance.h"

namespace mes {

/// Width of their lines, in logical pixels.
inline constexpr double kHighlightLine = 2.5;

/// The colour of what is highlighted for this role, on the canvas and where it is kept.
Rgb highlight_color(ProvenanceRole role);

/// An element where its places are, in units of the document.
struct HighlightedShape {
  ProvenanceShape shape;
  ProvenanceRole role = ProvenanceRole::itself;
};
/// Those of a highlight; the circle of three samples in line is left out. Nothing of other annotations.
std::vector<HighlightedShape> highlighted_shapes(const Annotation& annotation, const Document& document);

/// Puts shapes into a drawing. Places of an element itself are disks, of an origin rings, of a product squares; disks and
/// triangles are outlines, so that what lies in them is seen.
class HighlightPen {
 public:
  /// Both outlive it.
  HighlightPen(PaperDrawing& drawing, const SeenPlane& plane) : drawing_(drawing), plane_(drawing, plane) {}
  void draw(const HighlightedShape& shape);

 private:
  void point(Vec2 at, ProvenanceRole role, Rgb color);

  PaperDrawing& drawing_;
  PlaneDrawing plane_;
};

/// How far a place on the drawing is from the lines and points of a shape, in logical pixels.
double highlight_distance(const ProvenanceShape& shape, Vec2 px, const SeenPlane& plane);

}  // namespace mes
