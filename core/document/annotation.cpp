// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/document/annotation.h"

#include <fmt/core.h>
#include <algorithm>
#include <array>
#include <cmath>
#include <tuple>

#include "core/base/coordinate_range.h"

namespace mes {
namespace {

constexpr std::array<std::string_view, kAnnotationKinds> kIds{"text",     "leader", "arrow",
                                                              "distance", "angle",  "radius"};

// Not written as its opposite, so that NaN is a fault.
bool is_within(double x, double low, double high) {
  return low <= x && x <= high;
}

std::string fault_of(const Anchor& anchor, std::size_t samples) {
  for (const double x : {anchor.at.x, anchor.at.y})
    if (const auto fault = range_fault_of(x)) return "a place of an annotation: " + describe(*fault, x);
  if (anchor.samples.size() > 3 || anchor.samples.size() == 2)
    return "a place of an annotation follows neither one sample nor three";
  if (std::ranges::any_of(anchor.samples, [samples](std::uint32_t number) { return number >= samples; }))
    return "an annotation names a sample that never was";
  return {};
}

}  // namespace

std::string_view id_of(AnnotationKind kind) {
  return kIds[static_cast<std::size_t>(kind)];
}

std::optional<AnnotationKind> annotation_kind_of(std::string_view id) {
  const auto found = std::ranges::find(kIds, id);
  if (found == kIds.end()) return std::nullopt;
  return static_cast<AnnotationKind>(found - kIds.begin());
}

std::string fault_of(const Annotation& annotation, std::size_t samples) {
  if (annotation.anchors.size() != anchor_count(annotation.kind))
    return fmt::format("an annotation of the kind {} has {} places instead of {}", id_of(annotation.kind),
                       annotation.anchors.size(), anchor_count(annotation.kind));
  if (annotation.text.size() > kMostAnnotationBytes)
    return fmt::format("the text of an annotation is longer than {} bytes", kMostAnnotationBytes);
  if (!is_within(annotation.letters, kLeastLetters, kMostLetters))
    return fmt::format("the letters of an annotation are not from {} to {} pixels high", kLeastLetters, kMostLetters);
  for (const double x : {annotation.shift.x, annotation.shift.y})
    if (!is_within(x, -kMostShift, kMostShift)) return "the text of an annotation is too far from its place";
  for (const Anchor& anchor : annotation.anchors)
    if (auto fault = fault_of(anchor, samples); !fault.empty()) return fault;
  return {};
}

std::string fault_of(const Annotations& annotations, std::size_t samples) {
  if (annotations.size() > kMostAnnotations) return fmt::format("more than {} annotations", kMostAnnotations);
  for (const Annotation& annotation : annotations)
    if (auto fault = fault_of(annotation, samples); !fault.empty()) return fault;
  return {};
}

bool same_but_for_places(const Annotations& a, const Annotations& b) {
  const auto rest = [](const Annotation& annotation) {
    return std::tuple(annotation.kind, std::string_view(annotation.text), annotation.letters, annotation.color);
  };
  return std::ranges::equal(a, b, [&](const Annotation& x, const Annotation& y) { return rest(x) == rest(y); });
}

}  // namespace mes
