// SPDX-License-Identifier: GPL-3.0-or-later
// Smoothing of contours of pixels. Private to core/raster.
#pragma once

#include <span>
#include <vector>

#include "core/base/job_control.h"
#include "core/base/vec2.h"

namespace mes {

struct SmoothingLimits {
  double displacement = 0.5;  ///< how far a point may move, in pixels
  double widest = 8.0;        ///< length, in pixels along the contour, below which what waves is taken out
};

/// Points at equal distances of about one pixel along the closed contour, each moved by at most `displacement`: as much
/// as makes the contour smooth at the widest scale that a neighbourhood of the point allows. Scales are halved, down to
/// one pixel. What bends with a radius of twice the scale stays where it is within 0.02 of the scale. Cost: O(points).
/// Throws `Cancelled` if there is a job, which is looked at once a scale.
std::vector<Vec2> smoothed(std::span<const Vec2> contour, const SmoothingLimits& limits,
                           const JobControl* job = nullptr);

}  // namespace mes
