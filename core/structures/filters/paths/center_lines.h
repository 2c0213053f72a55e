// SPDX-License-Identifier: GPL-3.0-or-later
// Centre lines: the main lines of an axis after branches of little salience are pruned.
#pragma once

#include <cstddef>
#include <span>
#include <utility>
#include <vector>

#include "core/base/geometry/vec2.h"
#include "core/base/jobs/job_control.h"
#include "core/structures/filters/paths/axis_network.h"
#include "core/structures/filters/paths/center_line.h"

namespace mes {

struct CenterLineRequest {
  double least_salience = 0.5;  ///< of a branch (branch_pruning.h)
  std::size_t most = 1;         ///< lines of each shape
  /// If not empty, only the shortest lines between the free ends of the axis that are nearest to the points of a pair.
  std::vector<std::pair<Vec2, Vec2>> between{};
};

struct CenterLines {
  std::vector<CenterLine> lines;  ///< shape by shape, that with the longest first line first
  std::size_t points = 0;         ///< shapes whose axis is a single point, but for rounding, and has no line
  std::size_t unjoined = 0;       ///< pairs of `between` that are not two different ends of one shape
};

/// The lines of `AxisPaths` through the salient branches of the network. A line between two free ends begins at the
/// lexicographically smaller one, and one between two given points at the first of them.
///
/// Guarantee: lines are made of whole branches.
///
/// Cost: O(pieces of the branches), and that of `salient_branches` and `AxisPaths`. Throws `Cancelled`.
CenterLines center_lines_of(const AxisNetwork& network, const CenterLineRequest& request, JobControl& job);

/// Smooths all lines. A line that begins or ends on another one still does, at a point of both.
void smooth(CenterLines& set, const SmoothingTolerance& tolerance);

/// A piece of the boundary.
struct Wall {
  Vec2 a{}, b{};
};
/// Extends the free ends of the lines straight on to the nearest wall. The direction is that from the point of the line
/// one radius before the end, so that single bends of the axis do not turn it. An end stays where its ray meets no wall
/// within `most` radii, as where outlines cross.
///
/// Cost: O(n log n) for n walls, then O(log n) for each end where the ray is short.
void extend(CenterLines& set, std::span<const Wall> walls, double most);

}  // namespace mes
