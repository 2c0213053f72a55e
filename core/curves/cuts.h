// SPDX-License-Identifier: GPL-3.0-or-later
// Outlines that go along a cut twice, once in each direction, without the cut.
#pragma once

#include <functional>
#include <vector>

#include "core/base/job_control.h"
#include "core/curves/curve.h"

namespace mes {

/// A ring with a hole is often written as one outline that goes to the hole along a slit and back; and a polygon across
/// the 180th meridian is cut there into two. What lies on both sides of such a cut is one region.
///
/// Parts of a closed curve that it goes along in both directions are left out, and so are parts of two closed curves in
/// opposite directions all of whose points are `on_cut`. The rest is put together again, after the curves without cuts: a ring with a
/// slit becomes two. `resolution` as `CurveSet` has it. O(n log n), O(n) where no
/// vertex comes twice. Throws `Cancelled` if there is a job.
///
/// Smallest use:
///     curves = without_cuts(std::move(curves), 0.0, [](Vec2 p) { return p.x == 180.0; });
std::vector<PlaneCurve> without_cuts(std::vector<PlaneCurve> curves, double resolution,
                                     const std::function<bool(Vec2)>& on_cut, JobControl* job = nullptr);

}  // namespace mes
