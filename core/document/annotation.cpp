// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/document/annotation.h"

#include <fmt/core.h>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <tuple>
#include <utility>

#include "core/base/geometry/coordinate_range.h"

namespace mes {
namespace {

constexpr std::array<std::string_view, kAnnotationKinds> kIds{"text",  "leader", "arrow",     "distance",
                                                              "angle", "radius", "highlight", "center-line"};

// Not negated, so that NaN is a fault.
bool is_within(double x, double low, double high) {
  return low <= x && x <= high;
}

std::string anchor_fault(const Anchor& anchor, const NumberedThings& things) {
  for (const double x : {anchor.at.x, anchor.at.y})
    if (const auto fault = range_fault_of(x)) return "a place of an annotation: " + describe(*fault, x);
  if (anchor.samples.size() > 3 || anchor.samples.size() == 2)
    return "a place of an annotation follows neither one sample nor three";
  if (anchor.balls.size() > 4 || (!anchor.balls.empty() && !anchor.samples.empty()))
    return "a place of an annotation follows more than four balls, or samples and balls";
  if (!(0.0 < anchor.scale && anchor.scale <= kMostScale) || !is_within(anchor.along, -kMostAlong, kMostAlong))
    return "a place of an annotation follows balls by a number that is out of range";
  if ((anchor.balls.empty() && anchor.scale != 1.0) ||
      (anchor.balls.size() != 2 && anchor.balls.size() != 4 && anchor.along != 0.0))
    return "a place of an annotation has a number for balls that it does not follow";
  if (std::ranges::any_of(anchor.samples, [&](std::uint32_t number) { return number >= things.samples; }))
    return "an annotation names a sample that never was";
  if (std::ranges::any_of(anchor.balls, [&](std::uint32_t number) { return number >= things.balls; }))
    return "an annotation names a ball that never was";
  return {};
}

std::string highlight_fault(const std::vector<HighlightedElement>& elements) {
  if (elements.size() > kMostHighlighted)
    return fmt::format("more than {} elements are highlighted together", kMostHighlighted);
  for (const HighlightedElement& element : elements) {
    const bool is_round = element.kind == PrimitiveKind::circle || element.kind == PrimitiveKind::disk;
    if (!is_round) {
      if (element.radius != 0.0) return fmt::format("a highlighted {} has a radius", name_of(element.kind));
      continue;
    }
    if (!(element.radius > 0.0))
      return fmt::format("the radius of a highlighted {} is not positive", name_of(element.kind));
    if (const auto fault = range_fault_of(element.radius))
      return "the radius of a highlighted circle: " + describe(*fault, element.radius);
  }
  return {};
}

}  // namespace

std::size_t anchor_count(const Annotation& annotation) {
  if (annotation.kind != AnnotationKind::highlight) return anchor_count(annotation.kind);
  std::size_t out = 0;
  for (const HighlightedElement& element : annotation.elements) out += anchor_count(element.kind);
  return out;
}

bool lose_elements(Annotation& annotation, const std::function<bool(const Anchor&)>& is_gone) {
  if (annotation.kind != AnnotationKind::highlight) return false;
  std::vector<Anchor> anchors;
  std::vector<HighlightedElement> elements;
  auto next = annotation.anchors.begin();
  for (const HighlightedElement& element : annotation.elements) {
    const auto end = next + static_cast<std::ptrdiff_t>(anchor_count(element.kind));
    if (std::none_of(next, end, is_gone)) {
      elements.push_back(element);
      anchors.insert(anchors.end(), next, end);
    }
    next = end;
  }
  annotation.anchors = std::move(anchors);
  annotation.elements = std::move(elements);
  return annotation.elements.empty();
}

std::string_view id_of(AnnotationKind kind) {
  return kIds[static_cast<std::size_t>(kind)];
}

std::optional<AnnotationKind> annotation_kind_of(std::string_view id) {
  const auto found = std::ranges::find(kIds, id);
  if (found == kIds.end()) return std::nullopt;
  return static_cast<AnnotationKind>(found - kIds.begin());
}

std::string fault_of(const Annotation& annotation, const NumberedThings& things) {
  if (annotation.elements.empty() == (annotation.kind == AnnotationKind::highlight))
    return annotation.elements.empty() ? "a highlight has no elements"
                                       : "an annotation that is not a highlight has elements";
  if (auto fault = highlight_fault(annotation.elements); !fault.empty()) return fault;
  if (annotation.anchors.size() != anchor_count(annotation))
    return fmt::format("an annotation of the kind {} has {} places instead of {}", id_of(annotation.kind),
                       annotation.anchors.size(), anchor_count(annotation));
  if (annotation.text.size() > kMostAnnotationBytes)
    return fmt::format("the text of an annotation is longer than {} bytes", kMostAnnotationBytes);
  if (!is_within(annotation.letters, kLeastLetters, kMostLetters))
    return fmt::format("the letters of an annotation are not from {} to {} pixels high", kLeastLetters, kMostLetters);
  for (const double x : {annotation.shift.x, annotation.shift.y})
    if (!is_within(x, -kMostShift, kMostShift)) return "the text of an annotation is too far from its place";
  for (const Anchor& anchor : annotation.anchors)
    if (auto fault = anchor_fault(anchor, things); !fault.empty()) return fault;
  return {};
}

std::string fault_of(const Annotations& annotations, const NumberedThings& things) {
  if (annotations.size() > kMostAnnotations) return fmt::format("more than {} annotations", kMostAnnotations);
  for (const Annotation& annotation : annotations)
    if (auto fault = fault_of(annotation, things); !fault.empty()) return fault;
  return {};
}

std::size_t highlighted_elements(const Annotations& annotations) {
  std::size_t out = 0;
  for (const Annotation& annotation : annotations) out += annotation.elements.size();
  return out;
}

std::vector<std::pair<Vec2, Vec2>> center_line_ends(const Annotations& annotations) {
  std::vector<std::pair<Vec2, Vec2>> out;
  for (const Annotation& annotation : annotations)
    if (annotation.kind == AnnotationKind::center_line)
      out.emplace_back(annotation.anchors[0].at, annotation.anchors[1].at);
  return out;
}

bool same_but_for_places(const Annotations& a, const Annotations& b) {
  const auto rest = [](const Annotation& annotation) {
    return std::tuple(annotation.kind, std::string_view(annotation.text), annotation.letters, annotation.color);
  };
  return std::ranges::equal(a, b, [&](const Annotation& x, const Annotation& y) { return rest(x) == rest(y); });
}

}  // namespace mes
