// SPDX-License-Identifier: GPL-3.0-or-later
// What a filter leaves of the axis as a list of branches, each with its measures.
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
  };
  End from{};
  End to{};
  std::vector<EdgeSlot> edges;  ///< from `from` to `to`; empty for an isolated point of the axis
  double length = 0.0;
  double radius_least = 0.0;  ///< of the balls along it
  double radius_mean = 0.0;   ///< over its length
  double radius_largest = 0.0;
  double lambda = 0.0;  ///< the largest along it
  double angle = 0.0;   ///< the largest object angle along it, in degrees, whatever the mode of the filter
};

/// What it guarantees: each kept edge is in exactly one branch, and inner nodes of a branch have two kept edges. The list
/// depends on the samples and the filter alone, to the last bit: longest first, by place where equally long; a branch
/// begins at its lexicographically smaller end, a closed one at its smallest node, towards the smaller of the two next
/// to it. The lengths add up to the length of what is kept.
///
/// Cost: O(kept edges), and the sorting. All of it is up to date.
std::vector<AxisBranch> branches_of(const AxisFilter& filter, const InnerBalls& balls, const LambdaAxis& lambda,
                                    const AngleAxis& angle);

}  // namespace mes
