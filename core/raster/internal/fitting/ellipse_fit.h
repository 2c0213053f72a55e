// SPDX-License-Identifier: GPL-3.0-or-later
// Fits an ellipse to pixel edges. Private to core/raster.
#pragma once

#include <optional>
#include <span>

#include "core/base/geometry/vec2.h"
#include "core/raster/internal/fitting/run_fit.h"

namespace mes {

/// An ellipse by its half axes, at right angles; `v` lies to the left of `u`. The half axes differ by at least a
/// thousandth of a pixel, invisible in any picture: on a nearly exact circle any sample could become an end of the
/// axis.
struct Ellipse {
  Vec2 center{};
  Vec2 u{};
  Vec2 v{};
};

/// Fits by least squares to edges in their order along a closed contour. Returns nothing if the residuals are more than
/// noise (core/raster/internal/fitting/residual_windows.h), which a few Gauss-Newton steps show. O(edges log edges) for an
/// ellipse, mostly O(edges) otherwise.
std::optional<Ellipse> ellipse_of(std::span<const Edge> edges, const EdgeNoise& noise);

}  // namespace mes
