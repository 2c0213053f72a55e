// SPDX-License-Identifier: GPL-3.0-or-later
// The part of the axis that a filter leaves, as a list of branches with their measures.
#pragma once

#include <cstdint>
#include <vector>

#include "core/structures/filters/angle_axis.h"
#include "core/structures/filters/lambda_axis.h"

namespace mes {

enum class BranchEndKind : std::uint8_t {
  leaf,      ///< a node at which the branch ends alone
  junction,  ///< a node with three or more edges
  cut,       ///< the filter cuts an edge there
  none,      ///< the branch is closed, or a point
};

struct AxisBranch {
  struct End {
    Vec2 place{};
    BranchEndKind kind = BranchEndKind::none;
    FaceSlot node = kNoSlot;  ///< of the axis, for a leaf or a junction
  };
  End from{};
  End to{};
  std::vector<EdgeSlot> edges;  ///< from `from` to `to`; empty for an isolated point of the axis
  double length = 0.0;
  double radius_least = 0.0;  ///< for the balls along it
  double radius_mean = 0.0;   ///< averaged over its length
  double radius_largest = 0.0;
  double lambda = 0.0;  ///< largest along it
  double angle = 0.0;   ///< largest object angle along it, in degrees, whatever the mode of the filter
};

/// Guarantees: each kept edge is in exactly one branch, and inner nodes of a branch have two kept edges. The list
/// depends on the samples and the filter alone, to the last bit: longest first, by position where equally long. A
/// branch begins at its lexicographically smaller end; a closed one at its smallest node, towards the smaller of the
/// two next to it. The lengths add up to the length of the kept part.
///
/// With `least` above 0, branches that are at most this part of their largest radius long are contracted to points, and
/// the list is that of the rest: samples of a circle, rounded to doubles, have as many centres as triangles. Branches
/// that the filter cuts are not contracted.
///
/// Cost: O(kept edges), plus the sorting. The filter and its inputs must be up to date.
std::vector<AxisBranch> branches_of(const AxisFilter& filter, const InnerBalls& balls, const LambdaAxis& lambda,
                                    const AngleAxis& angle, double least = 0.0);

/// A value of `least` for lists that people read: far above the rounding of coordinates, far below what is drawn.
inline constexpr double kLeastBranch = 1e-6;

}  // namespace mes
