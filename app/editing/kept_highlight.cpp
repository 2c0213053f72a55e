// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/editing/kept_highlight.h"

#include <algorithm>
#include <cmath>
#include <span>
#include <utility>
#include <vector>

#include "core/base/geometry/coordinate_range.h"

namespace mes {
namespace {

/// The present points that define a shape, in the order of `HighlightedElement`.
std::vector<Vec2> places_of(const ProvenanceShape& shape) {
  const auto& v = shape.values;
  const Vec2 first{v[0], v[1]};
  const Vec2 second{v[2], v[3]};
  switch (shape.kind) {
    case PrimitiveKind::point:
    case PrimitiveKind::disk:
    case PrimitiveKind::circle: return {first};
    case PrimitiveKind::segment: return {first, second};
    case PrimitiveKind::triangle:
    case PrimitiveKind::parabola: return {first, second, {v[4], v[5]}};
    case PrimitiveKind::arc: return {first, {v[3], v[4]}, {v[5], v[6]}};
    case PrimitiveKind::ray: return {first, first + perpendicular(second), first - perpendicular(second)};
    case PrimitiveKind::line: return {first + perpendicular(second), first - perpendicular(second)};
  }
  return {};
}

/// True if it follows elements, all of which are alive.
bool is_followed(const Followed& followed, const Document& document) {
  if (followed.samples[0] == kNoSlot && followed.balls[0] == kNoSlot) return false;
  return std::ranges::all_of(followed.samples,
                             [&](SampleSlot slot) { return slot == kNoSlot || document.is_alive(slot); }) &&
         std::ranges::all_of(followed.balls,
                             [&](BallSlot slot) { return slot == kNoSlot || document.is_ball_alive(slot); });
}

Anchor following(const Followed& followed, Vec2 at, const Document& document) {
  Anchor out{.at = at};
  for (const SampleSlot slot : followed.samples)
    if (slot != kNoSlot) out.samples.push_back(document.id(slot).value - document.first_id().value);
  for (const BallSlot slot : followed.balls)
    if (slot != kNoSlot) out.balls.push_back(document.ball_id(slot).value - document.first_ball_id().value);
  if (!out.balls.empty()) out.scale = followed.scale;
  if (out.balls.size() == 2 || out.balls.size() == 4) out.along = followed.along;
  return out;
}

/// The radius as a multiple of the unit for radii about this centre.
double relative_radius(double radius, const Anchor& center, const Document& document) {
  const double factor = radius / document.radius_unit(center);
  constexpr double kRounding = 1e-9;
  return std::abs(factor - 1.0) < kRounding ? 1.0 : factor;
}

}  // namespace

KeptHighlight highlight_of(const Provenance& answer, const Document& document, std::optional<std::size_t> line) {
  KeptHighlight out{.annotation = {.kind = AnnotationKind::highlight, .shift = {14.0, -14.0}}};
  Annotation& kept = out.annotation;
  const auto keep = [&](const ProvenanceShape& shape, ProvenanceRole role) {
    const std::vector<Vec2> places = places_of(shape);
    const std::span follows(shape.follows.data(), places.size());
    const bool moves =
        std::ranges::all_of(follows, [&](const Followed& followed) { return is_followed(followed, document); });
    HighlightedElement element{.kind = shape.kind, .role = role};
    if (shape.kind == PrimitiveKind::circle || shape.kind == PrimitiveKind::disk)
      element.radius = moves ? relative_radius(shape.values[2], following(follows[0], places[0], document), document)
                             : shape.values[2];
    Annotation one{.kind = AnnotationKind::highlight, .elements = {element}};
    for (std::size_t i = 0; i < places.size(); ++i)
      one.anchors.push_back(moves ? following(follows[i], places[i], document) : Anchor{.at = places[i]});
    if (kept.elements.size() == kMostHighlighted || !fault_of(one, document.numbered_things()).empty()) {
      ++out.left_out;
      return;
    }
    kept.elements.push_back(element);
    kept.anchors.insert(kept.anchors.end(), one.anchors.begin(), one.anchors.end());
  };
  for (std::size_t i = 0; i < answer.lines.size(); ++i) {
    if (line && *line != i) continue;
    for (const ProvenanceShape& shape : answer.lines[i].shapes) keep(shape, answer.lines[i].role);
  }
  return out;
}

}  // namespace mes
