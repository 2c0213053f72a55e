// SPDX-License-Identifier: GPL-3.0-or-later
// Converts a contour of pixels to a curve. Private to core/raster.
#pragma once

#include "core/base/geometry/box2.h"
#include "core/base/jobs/job_control.h"
#include "core/curves/curve.h"
#include "core/raster/contours.h"
#include "core/raster/internal/fitting/run_fit.h"

namespace mes {

/// The stiffest curve that the edges allow (core/raster/internal/fitting/run_fit.h), in cubic pieces with continuous tangents,
/// each as long as its stiffness and its turn allow.
///
/// A corner is a point that meets three conditions: a stiffness of two or four pixels does not fit, the direction turns
/// by more than `kLeastCorner` within five pixels, and two runs that end there, fitted separately, fit the edges no
/// worse than the curve without a corner. It lies where the two runs meet, so that sides stay straight up to it. A
/// curve that leaves the picture by more than half a pixel is replaced by the softened contour. Cost and exception as
/// for `fitted`.
PlaneCurve outline_of(const PixelContour& contour, const EdgeNoise& noise, const Box2& picture,
                      const JobControl* job = nullptr);

inline constexpr double kLeastCorner = 0.55;  // radians

}  // namespace mes
