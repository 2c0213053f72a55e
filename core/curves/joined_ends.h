// SPDX-License-Identifier: GPL-3.0-or-later
// Curves that were drawn in pieces, in one piece again.
#pragma once

#include <vector>

#include "core/curves/curve.h"

namespace mes {

/// The same curve from its end to its start.
PlaneCurve reversed(const PlaneCurve& curve);

/// Open curves whose ends are at most `tolerance` apart become one, turned around where they must be, and closed where
/// both ends meet, unless it is a single line or less than half a turn. An end is joined where it has exactly one other end at its place, or else exactly one near: where three curves meet, none are joined.
/// In the order of their first parts; closed curves stay as they are. Cost: O(n log n) for n curves, for ends that are
/// near to few others.
///
/// Smallest use:
///     const auto outline = joined_ends({left_half, right_half}, 1e-6);
std::vector<PlaneCurve> joined_ends(std::vector<PlaneCurve> curves, double tolerance);

}  // namespace mes
