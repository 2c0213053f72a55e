// SPDX-License-Identifier: GPL-3.0-or-later
// Contours of pixels without their steps of single pixels. Private to core/raster.
#pragma once

#include <span>
#include <vector>

#include "core/base/vec2.h"

namespace mes {

/// Points at equal distances of about one pixel along the closed contour, at least eight, moved by a smoothing spline that
/// takes out what waves within a few of them: it cuts bends of a radius of two pixels by about half a pixel. O(points).
std::vector<Vec2> softened(std::span<const Vec2> contour, double scale);

}  // namespace mes
