// SPDX-License-Identifier: GPL-3.0-or-later
// Regions that lines enclose together, as closed curves.
#pragma once

#include <vector>

#include "core/base/job_control.h"
#include "core/curves/curve.h"

namespace mes {

/// A floor plan is often drawn as walls that end at other walls, and parcels as the lines between them: no line is closed,
/// and yet they enclose regions. Where open curves meet others so, each region that they enclose becomes a closed curve,
/// all of them instead of the curves that go around them; a line between two regions is in both. Regions are inside where
/// no closed curve is concerned, or an odd number of those given goes around them. What encloses nothing stays open.
///
/// Curves that have nothing to do with open ones stay as they are, and come first. Curves that cross each other without a
/// common vertex do not meet. `resolution` as `CurveSet` has it. O(n log n). Throws `Cancelled` if there is a job.
///
/// Smallest use:
///     curves = with_line_regions(std::move(walls), 0.001);
std::vector<PlaneCurve> with_line_regions(std::vector<PlaneCurve> curves, double resolution,
                                          JobControl* job = nullptr);

}  // namespace mes
