// SPDX-License-Identifier: GPL-3.0-or-later
// The meaning of a style, for everything that draws it: the scene on a screen, and a figure on paper.
//
// Lengths are in logical pixels of 1/96 inch. Cost: a few operations each. Threads: any.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <span>

#include "core/draw/layer_style.h"
#include "core/draw/primitives.h"
#include "render/instances/colormap.h"
#include "render/scene.h"

namespace mes::render {

/// The kinds of a layer, bottom first. Triangles come first: the coverages of a group are summed before another kind
/// covers them.
inline constexpr std::array<PrimitiveKind, kPrimitiveKinds> kDrawOrder{
    PrimitiveKind::triangle, PrimitiveKind::disk,   PrimitiveKind::line, PrimitiveKind::ray,  PrimitiveKind::segment,
    PrimitiveKind::parabola, PrimitiveKind::circle, PrimitiveKind::arc,  PrimitiveKind::point};

/// True for kinds that are drawn along a line, and dashed if the style says so.
constexpr bool is_stroked(PrimitiveKind kind) {
  return kind != PrimitiveKind::point && kind != PrimitiveKind::disk && kind != PrimitiveKind::triangle;
}

/// The width of strokes.
inline double line_width_of(const LayerStyle& style) {
  constexpr double kLeast = 0.1;
  constexpr double kMost = 64.0;
  return std::isfinite(style.line_width_px) ? std::clamp(style.line_width_px, kLeast, kMost) : kLeast;
}

/// The diameter of points.
inline double point_size_of(const LayerStyle& style) {
  constexpr double kLeast = 0.1;
  constexpr double kMost = 256.0;
  return std::isfinite(style.point_size_px) ? std::clamp(style.point_size_px, kLeast, kMost) : kLeast;
}

/// The share of a layer's colour over the layers below; an opacity that is not finite counts as 1.
inline double opacity_of(const LayerStyle& style) {
  return std::isfinite(style.opacity) ? std::clamp(style.opacity, 0.0, 1.0) : 1.0;
}

/// Dashes are centred on multiples of the period along a stroke, from its first end, or from the rightmost point of a
/// circle.
struct DashPattern {
  double dash = 0.0;
  double period = 0.0;
};

/// For strokes up to two pixels; wider strokes have longer dashes.
inline DashPattern dash_of(const LayerStyle& style) {
  constexpr double kDash = 5.0;
  constexpr double kGap = 4.0;
  const double width = std::max(1.0, style.line_width_px / 2.0);
  return {kDash * width, (kDash + kGap) * width};
}

/// The colour map of a layer whose finite scalars span `shown`.
inline ShownMap chosen_map(std::span<const ColorMap> maps, const LayerStyle& style, const ScalarRange& shown) {
  if (style.color_map.empty()) return {};
  const auto found = std::ranges::find(maps, style.color_map, &ColorMap::name);
  if (found == maps.end()) return {};
  return {&*found, style.range_locked ? ScalarRange{style.range_low, style.range_high} : shown};
}

}  // namespace mes::render
