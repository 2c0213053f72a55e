// SPDX-License-Identifier: GPL-3.0-or-later
// Centre lines: the main lines of what a filter and pruning leave of the axis.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "core/base/jobs/job_control.h"
#include "core/structures/filters/axis_branches.h"
#include "core/structures/filters/paths/center_line.h"

namespace mes {

struct CenterLineRequest {
  double least_salience = 0.5;  ///< of a branch (branch_pruning.h)
  std::size_t most = 1;         ///< lines of each shape
  /// Only the shortest line between the free ends of the axis that are nearest to these two points.
  std::optional<std::pair<Vec2, Vec2>> between{};
};

struct CenterLines {
  std::vector<CenterLine> lines;  ///< shape by shape, that with the longest first line first
  std::size_t points = 0;         ///< shapes whose axis is a single point and has no line
  /// Whether `between` names two different ends of one shape; without it true.
  bool are_ends_joined = true;
};

/// The lines of `AxisPaths` through the salient branches of the filter. A line between two free ends begins at the
/// lexicographically smaller one, and one between two given points at the first of them.
///
/// Guarantee: lines are made of whole branches, so each piece of their axis is a kept piece of a Voronoi edge.
///
/// Cost: O(kept edges), and that of `salient_branches` and `AxisPaths`. The filter and its inputs must be up to date. Throws `Cancelled`.
CenterLines center_lines_of(const AxisFilter& filter, const OneStepCrust& crust, std::span<const AxisBranch> branches,
                            const CenterLineRequest& request, JobControl& job);

/// Smooths all lines. A line that begins or ends on another one still does, at a point of both.
void smooth(CenterLines& set, const SmoothingTolerance& tolerance);

/// Extends the free ends of the lines straight on to the curve. The direction is that from the point of the line one
/// radius before the end, so that single bends of the axis do not turn it. An end stays where its ray meets no curve
/// within `most` radii, as where outlines cross.
///
/// Guarantee: an extension crosses no wall between samples, so it stays on its side of the curve.
///
/// Cost: O(n log n) for the walls, then O(log n) for each end where the ray is short.
void extend_to_curve(CenterLines& set, const Delaunay& delaunay, const OneStepCrust& crust, double most = 4.0);

}  // namespace mes
