// SPDX-License-Identifier: GPL-3.0-or-later
// The ellipse that edges of pixels lie on, if they do. Private to core/raster.
#pragma once

#include <optional>
#include <span>

#include "core/base/vec2.h"
#include "core/raster/internal/run_fit.h"

namespace mes {

/// Half of its axes, at right angles; `v` lies to the left of `u`. They differ by a thousandth of a pixel at least, which no
/// picture tells from a circle: of a circle up to rounding each sample could be an end of the axis.
struct Ellipse {
  Vec2 center{};
  Vec2 u{};
  Vec2 v{};
};

/// By least squares, from edges in their order along a closed contour. Nothing where what is left of them is more than
/// noise (core/raster/internal/residual_windows.h), which a few steps of Gauss and Newton show. O(edges log edges) where it
/// is one, mostly O(edges) elsewhere.
std::optional<Ellipse> ellipse_of(std::span<const Edge> edges, const EdgeNoise& noise);

}  // namespace mes
