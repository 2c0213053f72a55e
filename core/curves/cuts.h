// SPDX-License-Identifier: GPL-3.0-or-later
// Removes cuts from outlines: parts that an outline follows twice, once in each direction.
#pragma once

#include <cstddef>
#include <functional>
#include <vector>

#include "core/base/jobs/job_control.h"
#include "core/curves/curve.h"

namespace mes {

/// A ring with a hole is often written as one outline that runs to the hole along a slit and back. A polygon across the
/// 180th meridian is cut there into two. Both sides of such a cut belong to one region.
///
/// Removes parts of a closed curve that it follows in both directions, and parts that two closed curves follow in
/// opposite directions if all points of the part are `on_cut`; also spikes of closed polylines. The remaining parts
/// are joined again, after the curves without cuts: a ring with a slit becomes two curves. `resolution` as in
/// `CurveSet`. O(n log n); O(n) if no vertex occurs twice. Throws `Cancelled` if there is a job.
///
/// Smallest use:
///     curves = without_cuts(std::move(curves), 0.0, [](Vec2 p) { return p.x == 180.0; });
std::vector<PlaneCurve> without_cuts(std::vector<PlaneCurve> curves, double resolution,
                                     const std::function<bool(Vec2)>& on_cut, JobControl* job = nullptr);

/// Removes spikes from the closed polyline that the points from `begin` on form, whether it repeats its first point
/// or not: parts at whose tip it turns back, by an angle below 2^-30, which enclose nothing. A polyline of which
/// fewer than three points would remain stays as it is. O(n).
void remove_spikes(std::vector<Vec2>& points, std::size_t begin = 0);

}  // namespace mes
