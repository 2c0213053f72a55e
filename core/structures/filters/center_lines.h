// SPDX-License-Identifier: GPL-3.0-or-later
// Centre lines: the main lines of what a filter and pruning leave of the axis.
#pragma once

#include <span>

#include "core/structures/filters/axis_branches.h"
#include "core/structures/filters/paths/center_lines.h"

namespace mes {

/// The centre lines of what a filter leaves of the axis, given as its branches.
///
/// Guarantee: each piece of their axis is a kept piece of a Voronoi edge.
///
/// Cost: as for a network. The filter and its inputs must be up to date. Throws `Cancelled`.
CenterLines center_lines_of(const AxisFilter& filter, const OneStepCrust& crust, std::span<const AxisBranch> branches,
                            const CenterLineRequest& request, JobControl& job);

/// Extends the free ends of the lines to the curve (`extend`).
///
/// Guarantee: an extension crosses no wall between samples, so it stays on its side of the curve.
void extend_to_curve(CenterLines& set, const Delaunay& delaunay, const OneStepCrust& crust, double most = 4.0);

}  // namespace mes
