// SPDX-License-Identifier: GPL-3.0-or-later
// Lays out annotations over a part of the plane.
//
// Smallest use:
//     const auto drawn = layout_annotations(place(document), seen_plane(camera, scale), measure, background);
//     paint(image, fonts, drawn.drawing, {0.0, 0.0}, scale);
//
// Cost: microseconds per annotation. Threads: any.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/picture/annotations/highlight_drawing.h"
#include "app/picture/paper/paper_drawing.h"
#include "app/picture/paper/scale_drawing.h"
#include "core/base/geometry/box2.h"
#include "core/document/document.h"

namespace mes {

/// Annotations with the present positions of their anchors, as plain data.
struct PlacedAnnotations {
  std::shared_ptr<const Annotations> annotations = std::make_shared<const Annotations>();
  std::vector<std::vector<Vec2>> places{};                   ///< for each annotation, one per anchor
  std::vector<std::vector<HighlightedShape>> highlighted{};  ///< for each annotation; empty unless it is a highlight
  bool is_empty() const { return annotations->empty(); }
};
PlacedAnnotations place(const Document& document);

/// The measurement of a dimension, in four digits; empty for other kinds, and if there is nothing to measure.
std::string measured_value(AnnotationKind kind, const std::vector<Vec2>& places);

/// Width of the lines of annotations, in logical pixels.
inline constexpr double kAnnotationLine = 1.25;

/// Lengths are in logical pixels, from the upper left corner of the part of the plane, y down.
struct AnnotationDrawing {
  PaperDrawing highlights;  ///< below all others
  PaperDrawing drawing;
  std::vector<Box2> words;                ///< box of the text of each annotation; empty if it has none
  std::vector<std::vector<Vec2>> places;  ///< positions of the anchors of each annotation
  std::vector<AnnotationKind> kinds{};    ///< of each annotation
  std::vector<std::string> complaints{};  ///< about text that is not understood, one line each
  SeenPlane plane{};
  std::vector<std::vector<HighlightedShape>> highlighted{};  ///< for each annotation
};

/// Leaves out everything far outside the part of the plane.
AnnotationDrawing layout_annotations(const PlacedAnnotations& placed, const SeenPlane& plane,
                                     const MeasureText& measure, const std::optional<Rgb>& background);

/// The topmost annotation within `reach` of a point on the drawing: picked by its text, its anchors, or the line
/// between two of them, which the ends of a centre line lack; a highlight by its text and the lines and points of its
/// elements.
std::optional<std::size_t> annotation_at(const AnnotationDrawing& drawn, Vec2 px, double reach);

}  // namespace mes
