// SPDX-License-Identifier: GPL-3.0-or-later
// Removes the single-pixel steps from contours. Private to core/raster.
#pragma once

#include <span>
#include <vector>

#include "core/base/geometry/vec2.h"

namespace mes {

/// At least eight points along the closed contour, at equal distances of about one pixel, moved by a smoothing spline
/// that removes waves of a few points: it cuts bends of a radius of two pixels by about half a pixel. O(points).
std::vector<Vec2> softened(std::span<const Vec2> contour, double scale);

}  // namespace mes
