// SPDX-License-Identifier: GPL-3.0-or-later
// Annotations: text, arrows, leader lines, dimension lines and highlighted elements that explain a drawing.
//
// Annotations are part of the document: edits of them can be undone and are stored in sessions, like those of samples.
// Nothing is computed from them, except centre lines between two ends.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/base/color.h"
#include "core/base/geometry/vec2.h"
#include "core/draw/primitives.h"
#include "core/draw/provenance_role.h"

namespace mes {

/// A position that an annotation refers to; it moves with the samples or balls that it follows.
struct Anchor {
  Vec2 at{};  ///< the position, if it follows nothing
  /// Indices of samples, counted from the first one of the document. None: the position is fixed. One: that sample.
  /// Three: the centre of their circle, as for a vertex of the Voronoi diagram. When a sample is removed, the anchors
  /// that follow it become fixed.
  std::vector<std::uint32_t> samples{};
  /// Indices of balls, likewise; empty if the anchor follows samples. One: its centre. Two: the crossing of their
  /// circles to the left of the vector from the first centre to the second (or the midpoint of the complex crossings);
  /// with `along`, the point of equal power on the line of centres, shifted along it. Three: the point of equal power.
  /// Four: a point on the perpendicular bisector between the crossing of the first two balls and that of the last two.
  std::vector<std::uint32_t> balls{};
  double along = 0.0;  ///< times the vector between centres (two balls), or left normal to that of crossings (four)
  double scale = 1.0;  ///< factor for the radii of the balls

  /// True if it follows nothing.
  bool is_fixed() const { return samples.empty() && balls.empty(); }
  friend bool operator==(const Anchor&, const Anchor&) = default;
};

enum class AnnotationKind : std::uint8_t {
  text,      ///< words at a position
  leader,    ///< words next to an element, with a line to it
  arrow,     ///< an arrow that ends at the second position
  distance,  ///< between two positions
  angle,     ///< angle at the second position, between the first and the third
  radius,    ///< radius of the circle through three positions
  /// Elements of the drawing that stay highlighted, as provenance shows them: an element with its origins and its
  /// products. The words stand beside the first element.
  highlight,
  /// The ends of a centre line: the layers of centre lines show the line between the free ends of the axis nearest to
  /// two positions.
  center_line,
};
inline constexpr std::size_t kAnnotationKinds = 8;

/// One shape of a highlight. Its positions are anchors of the annotation; each element uses the next ones:
///   point             its position
///   circle, disk      the centre
///   segment           its ends
///   triangle          its corners
///   arc               the centre and its ends, counter-clockwise
///   parabola          one end, the control point, the other end
///   line              two points; it is their perpendicular bisector
///   ray               its start, and two points: it leads to the left of the vector between them
struct HighlightedElement {
  PrimitiveKind kind = PrimitiveKind::point;
  ProvenanceRole role = ProvenanceRole::itself;
  /// Radius of a circle or a disk, as a multiple. If the centre follows three samples, of the radius of their circle;
  /// if it follows one ball, of its scaled radius; if it follows four balls, of the distance to the first crossing.
  double radius = 0.0;
  friend bool operator==(const HighlightedElement&, const HighlightedElement&) = default;
};

/// Number of anchors of an element.
constexpr std::size_t anchor_count(PrimitiveKind kind) {
  switch (kind) {
    case PrimitiveKind::point:
    case PrimitiveKind::circle:
    case PrimitiveKind::disk: return 1;
    case PrimitiveKind::segment:
    case PrimitiveKind::line: return 2;
    case PrimitiveKind::triangle:
    case PrimitiveKind::arc:
    case PrimitiveKind::parabola:
    case PrimitiveKind::ray: return 3;
  }
  return 0;
}

/// Number of anchors of an annotation of this kind; for a highlight, its elements determine the number.
constexpr std::size_t anchor_count(AnnotationKind kind) {
  switch (kind) {
    case AnnotationKind::text:
    case AnnotationKind::leader: return 1;
    case AnnotationKind::arrow:
    case AnnotationKind::distance:
    case AnnotationKind::center_line: return 2;
    case AnnotationKind::angle:
    case AnnotationKind::radius: return 3;
    case AnnotationKind::highlight: return 0;
  }
  return 0;
}
/// Public name, kebab case.
std::string_view id_of(AnnotationKind kind);
std::optional<AnnotationKind> annotation_kind_of(std::string_view id);

inline constexpr double kUsualLetters = 15.0;
inline constexpr double kLeastLetters = 6.0;
inline constexpr double kMostLetters = 120.0;
/// Limit for shifts along each axis, in logical pixels.
inline constexpr double kMostShift = 10'000.0;
inline constexpr std::size_t kMostAnnotationBytes = 4000;
inline constexpr std::size_t kMostAnnotations = 1000;
/// Limit for the elements of one highlight.
inline constexpr std::size_t kMostHighlighted = 4000;
/// Limits for the scales of balls, and for `along`.
inline constexpr double kMostScale = 1e9;
inline constexpr double kMostAlong = 1e12;

struct Annotation {
  AnnotationKind kind = AnnotationKind::text;
  std::string text{};              ///< in a small subset of LaTeX; a dimension without text shows its measured value
  std::vector<Anchor> anchors{};   ///< `anchor_count` of the annotation
  Vec2 shift{};                    ///< offset of the words from their usual position, in logical pixels, y down
  double letters = kUsualLetters;  ///< size of the letters, logical pixels
  /// Unset: dark on a light canvas, light on a dark one. Unset for a highlight: its words do that, and its elements
  /// have the colours of their roles.
  std::optional<Rgb> color{};
  std::vector<HighlightedElement> elements{};  ///< only for a highlight
  friend bool operator==(const Annotation&, const Annotation&) = default;
};

using Annotations = std::vector<Annotation>;

/// Number of anchors of the annotation.
std::size_t anchor_count(const Annotation& annotation);

/// Removes elements with a lost anchor from a highlight. Returns true if no element is left. Does nothing for other
/// kinds.
bool lose_elements(Annotation& annotation, const std::function<bool(const Anchor&)>& is_gone);

/// Numbers of samples and balls ever numbered, alive or not.
struct NumberedThings {
  std::size_t samples = 0;
  std::size_t balls = 0;
};
/// Returns why no document can hold the annotation; empty if it can.
std::string fault_of(const Annotation& annotation, const NumberedThings& things);
/// The same for a list of annotations.
std::string fault_of(const Annotations& annotations, const NumberedThings& things);
/// Number of elements that the annotations highlight.
std::size_t highlighted_elements(const Annotations& annotations);

/// The positions of the ends of centre lines, as they were set; `data_of` sets those that follow something.
std::vector<std::pair<Vec2, Vec2>> center_line_ends(const Annotations& annotations);

/// True if they differ at most in positions and shifts.
bool same_but_for_places(const Annotations& a, const Annotations& b);

}  // namespace mes
