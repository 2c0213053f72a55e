// SPDX-License-Identifier: GPL-3.0-or-later
// Annotations: text, arrows, leader lines, dimension lines and highlighted elements that explain a drawing.
//
// They are part of the document: edits of them are undone and written into sessions like those of samples. Nothing is
// computed from them.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/color.h"
#include "core/base/vec2.h"
#include "core/draw/primitives.h"
#include "core/draw/provenance.h"

namespace mes {

/// A place in the plane that an annotation refers to, and that moves with what it is on.
struct Anchor {
  Vec2 at{};  ///< the place itself if it follows nothing
  /// Samples by their number, counted from the first one of the document. None: the place is fixed. One: that sample.
  /// Three: the centre of the circle through them, as of a vertex of the Voronoi diagram. When a sample is removed,
  /// the anchors that follow it become fixed.
  std::vector<std::uint32_t> samples{};
  /// Balls by their number, likewise; none where it follows samples. One: its centre. Two: the crossing of their circles
  /// on the left of the way from the first centre to the second, or the middle of two complex ones; with `along`, the
  /// place of equal power on the line of their centres, shifted. Three: the place of equal power. Four: a place on the
  /// perpendicular bisector of the crossing of the first two and that of the last two.
  std::vector<std::uint32_t> balls{};
  double along = 0.0;  ///< of two balls: times their way; of four: times the way of the crossings, to the left of it
  double scale = 1.0;  ///< what the radii of the balls are multiplied by

  /// It follows nothing.
  bool is_fixed() const { return samples.empty() && balls.empty(); }
  friend bool operator==(const Anchor&, const Anchor&) = default;
};

enum class AnnotationKind : std::uint8_t {
  text,      ///< words at a place
  leader,    ///< words beside an element, with a line to it
  arrow,     ///< from the first place to the second one
  distance,  ///< between two places
  angle,     ///< at the second place, between the first and the third one
  radius,    ///< of the circle through three places
  /// Elements of the drawing that stay highlighted, as provenance shows them: an element with what it comes from and
  /// what it leads to. Words beside the first of them.
  highlight,
};
inline constexpr std::size_t kAnnotationKinds = 7;

/// One shape of a highlight. Its places are anchors of the annotation; each element takes the next ones:
///   point             itself
///   circle, disk      the centre
///   segment           its ends
///   triangle          its corners
///   arc               the centre and its ends, counter-clockwise
///   line              two places, of which it is the perpendicular bisector
///   ray               where it begins, and two places: it leads to the left of the way from one to the other
struct HighlightedElement {
  PrimitiveKind kind = PrimitiveKind::point;
  ProvenanceRole role = ProvenanceRole::itself;
  /// Of a circle or a disk. Where its centre follows three samples, a multiple of the radius of their circle; where it
  /// follows one ball, of the ball's scaled radius; where it follows four balls, of its distance to the first crossing.
  double radius = 0.0;
  friend bool operator==(const HighlightedElement&, const HighlightedElement&) = default;
};

/// How many places an element has.
constexpr std::size_t anchor_count(PrimitiveKind kind) {
  switch (kind) {
    case PrimitiveKind::point:
    case PrimitiveKind::circle:
    case PrimitiveKind::disk: return 1;
    case PrimitiveKind::segment:
    case PrimitiveKind::line: return 2;
    case PrimitiveKind::triangle:
    case PrimitiveKind::arc:
    case PrimitiveKind::ray: return 3;
  }
  return 0;
}

/// How many places an annotation of a kind has; of a highlight, its elements have them.
constexpr std::size_t anchor_count(AnnotationKind kind) {
  switch (kind) {
    case AnnotationKind::text:
    case AnnotationKind::leader: return 1;
    case AnnotationKind::arrow:
    case AnnotationKind::distance: return 2;
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
/// Of shifts, in logical pixels along each axis.
inline constexpr double kMostShift = 10'000.0;
inline constexpr std::size_t kMostAnnotationBytes = 4000;
inline constexpr std::size_t kMostAnnotations = 1000;
/// Of one highlight.
inline constexpr std::size_t kMostHighlighted = 4000;
/// Of scales of balls, and of multiples of a distance.
inline constexpr double kMostScale = 1e9;
inline constexpr double kMostAlong = 1e12;

struct Annotation {
  AnnotationKind kind = AnnotationKind::text;
  std::string text{};              ///< in a small part of LaTeX; a dimension without text shows what it measures
  std::vector<Anchor> anchors{};   ///< `anchor_count` of the annotation
  Vec2 shift{};                    ///< of the words from their usual place, logical pixels, y down
  double letters = kUsualLetters;  ///< size of the letters, logical pixels
  /// None: dark on a light canvas, light on a dark one; of a highlight, its words. Its elements have then the colours
  /// of their roles.
  std::optional<Rgb> color{};
  std::vector<HighlightedElement> elements{};  ///< of a highlight
  friend bool operator==(const Annotation&, const Annotation&) = default;
};

using Annotations = std::vector<Annotation>;

/// How many places it has.
std::size_t anchor_count(const Annotation& annotation);

/// Takes elements with a place that is gone out of a highlight. True: nothing of it is left. Of other kinds nothing is
/// taken away.
bool lose_elements(Annotation& annotation, const std::function<bool(const Anchor&)>& is_gone);

/// How many samples and balls have a number, alive or not.
struct NumberedThings {
  std::size_t samples = 0;
  std::size_t balls = 0;
};
/// Why no document can hold it; empty: it can.
std::string fault_of(const Annotation& annotation, const NumberedThings& things);
/// The same of all.
std::string fault_of(const Annotations& annotations, const NumberedThings& things);
/// How many elements they highlight.
std::size_t highlighted_elements(const Annotations& annotations);

/// Whether they differ in places and shifts at most.
bool same_but_for_places(const Annotations& a, const Annotations& b);

}  // namespace mes
