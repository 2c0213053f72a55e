// SPDX-License-Identifier: GPL-3.0-or-later
// The basic shapes of SVG as curves (SVG 2, chapter 10). Private to core/io.
#pragma once

#include <optional>

#include "core/curves/curve.h"

namespace mes {

/// Radii are clamped to half the sides; nothing for a rectangle without extent.
std::optional<PlaneCurve> svg_rect(Vec2 corner, Vec2 size, Vec2 radii);
/// Nothing for a radius that is not positive.
std::optional<PlaneCurve> svg_ellipse(Vec2 center, Vec2 radii);

}  // namespace mes
