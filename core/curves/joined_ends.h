// SPDX-License-Identifier: GPL-3.0-or-later
// Joins curves that were drawn in pieces.
#pragma once

#include <vector>

#include "core/curves/curve.h"

namespace mes {

/// The same curve from its end to its start.
Piece reversed(const Piece& piece);
PlaneCurve reversed(const PlaneCurve& curve);

/// Joins open curves whose ends are at most `tolerance` apart, and reverses them where necessary. A curve whose own
/// ends meet is closed, unless it is a single line or less than half a turn. An end is joined if exactly one other end
/// lies at the same position, or else if exactly one is near: where three curves meet, nothing is joined. Where 4, 6 or
/// up to 64 ends meet, pairs are joined that go on most straight, if all do so within a quarter of a turn; tangent curves
/// go on where they bend alike. The result is in the order of the first parts; closed curves do not change. Cost:
/// O(n log n) for n curves, if each end is near few others.
///
/// Smallest use:
///     const auto outline = joined_ends({left_half, right_half}, 1e-6);
std::vector<PlaneCurve> joined_ends(std::vector<PlaneCurve> curves, double tolerance);

}  // namespace mes
