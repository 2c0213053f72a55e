// SPDX-License-Identifier: GPL-3.0-or-later
// Annotations laid out over a part of the plane.
//
// Smallest use:
//     const auto drawn = layout_annotations(place(document), seen_plane(camera, scale), measure, background);
//     paint(image, fonts, drawn.drawing, {0.0, 0.0}, scale);
//
// Cost: microseconds an annotation. Threads: any.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/picture/highlight_drawing.h"
#include "app/picture/paper_drawing.h"
#include "app/picture/scale_drawing.h"
#include "core/base/box2.h"
#include "core/document/document.h"

namespace mes {

/// Annotations with the places of their anchors at one moment, as plain data.
struct PlacedAnnotations {
  std::shared_ptr<const Annotations> annotations = std::make_shared<const Annotations>();
  std::vector<std::vector<Vec2>> places{};                   ///< of each, as many as it has anchors
  std::vector<std::vector<HighlightedShape>> highlighted{};  ///< of each; empty unless it is a highlight
  bool is_empty() const { return annotations->empty(); }
};
PlacedAnnotations place(const Document& document);

/// What a dimension measures, in four digits; empty for what is not a dimension, and where it measures nothing.
std::string measured_value(AnnotationKind kind, const std::vector<Vec2>& places);

/// Width of their lines, in logical pixels.
inline constexpr double kAnnotationLine = 1.25;

/// Lengths are in logical pixels, from the upper left corner of the part of the plane, y down.
struct AnnotationDrawing {
  PaperDrawing highlights;  ///< below all others
  PaperDrawing drawing;
  std::vector<Box2> words;                ///< around the words of each annotation; empty where it has none
  std::vector<std::vector<Vec2>> places;  ///< of the anchors of each
  std::vector<std::string> complaints{};  ///< about words that are not understood, one line each
  SeenPlane plane{};
  std::vector<std::vector<HighlightedShape>> highlighted{};  ///< of each annotation
};

/// What is far outside of the part of the plane is left out.
AnnotationDrawing layout_annotations(const PlacedAnnotations& placed, const SeenPlane& plane,
                                     const MeasureText& measure, const std::optional<Rgb>& background);

/// The topmost annotation within `reach` of a place on the drawing: by its words, its anchors, or the line between
/// two of them; a highlight by its words and the lines and points of its elements.
std::optional<std::size_t> annotation_at(const AnnotationDrawing& drawn, Vec2 px, double reach);

}  // namespace mes
