// SPDX-License-Identifier: GPL-3.0-or-later
// Turns regions that lines enclose together into closed curves.
#pragma once

#include <vector>

#include "core/base/jobs/job_control.h"
#include "core/curves/curve.h"

namespace mes {

/// A floor plan often consists of walls that end at other walls, and a parcel map of the lines between parcels: no line
/// is closed, and yet they enclose regions. Where open curves meet others in this way, each enclosed region becomes a
/// closed curve. These replace the given curves; a line between two regions is part of both. A region is inside if no
/// closed curve is involved, or if an odd number of the given closed curves surround it. Curves that enclose nothing
/// stay open.
///
/// Curves unrelated to open ones do not change, and come first. Curves that cross without a common vertex do not meet.
/// `resolution` as in `CurveSet`. O(n log n). Throws `Cancelled` if there is a job.
///
/// Smallest use:
///     curves = with_line_regions(std::move(walls), 0.001);
std::vector<PlaneCurve> with_line_regions(std::vector<PlaneCurve> curves, double resolution,
                                          JobControl* job = nullptr);

}  // namespace mes
