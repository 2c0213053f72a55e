// SPDX-License-Identifier: GPL-3.0-or-later
// Draws the highlighted elements of annotations.
//
// Smallest use:
//     HighlightPen pen(drawing, plane);
//     for (const HighlightedShape& shape : highlighted_shapes(annotation, document)) pen.draw(shape);
//
// Cost: microseconds per element. Threads: any, with a drawing of its own.
#pragma once

#include <vector>

#include "app/picture/annotations/plane_drawing.h"
#include "core/document/annotation.h"
#include "core/document/document.h"
#include "core/draw/provenance.h"

namespace mes {

/// Width of the lines of highlights, in logical pixels.
inline constexpr double kHighlightLine = 2.5;

/// The highlight colour of this role, on the canvas and in annotations.
Rgb highlight_color(ProvenanceRole role);

/// An element at its present position, in units of the document.
struct HighlightedShape {
  ProvenanceShape shape;
  ProvenanceRole role = ProvenanceRole::itself;
};
/// The shapes of a highlight, without the circle of three collinear samples; empty for other annotations.
std::vector<HighlightedShape> highlighted_shapes(const Annotation& annotation, const Document& document);

/// Draws shapes. Points of an element itself are disks, those of an origin rings, those of a product squares. Disks
/// and triangles are drawn as outlines, so that their contents stay visible.
class HighlightPen {
 public:
  /// Both arguments must outlive it.
  HighlightPen(PaperDrawing& drawing, const SeenPlane& plane) : drawing_(drawing), plane_(drawing, plane) {}
  void draw(const HighlightedShape& shape);

 private:
  void point(Vec2 at, ProvenanceRole role, Rgb color);

  PaperDrawing& drawing_;
  PlaneDrawing plane_;
};

/// The distance of a point on the drawing from the lines and points of a shape, in logical pixels.
double highlight_distance(const ProvenanceShape& shape, Vec2 px, const SeenPlane& plane);

}  // namespace mes
