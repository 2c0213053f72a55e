// SPDX-License-Identifier: GPL-3.0-or-later
// Hairs of the axis of grown balls: spurious branches at scallops of the boundary no longer than the sampling.
#pragma once

#include <cstdint>

#include "core/structures/balls/internal/union_tables.h"

namespace mes {

/// Distance of equal balls of radius 1 whose circles cross at `sampling_angle` degrees.
double distance_of_sampled(double sampling_angle);
/// The share of spacings that counts at a factor: 0 at 1, where there are no hairs, so that the axis does not jump
/// there; 1 at factors that differ from 1 by 0.02 or more.
double share_of_spacing(double factor);

/// The largest `spacing` of the balls that cross at each v-point.
Table<VPointSlot, double> spacing_of_v_points(const UnionTables& tables, const Table<FamilySlot, double>& spacing);

/// The pieces that were cut off.
struct ScaleHairs {
  std::int64_t pieces = 0;
  double length = 0.0;
};

/// Cuts hairs off the axis of the tables, from free ends inwards. A piece may go if, at each of its points,
///  * the two nearest v-points are no farther from each other than the sum of their spacings, and
///  * these are seen at less than 60 degrees;
/// or if its length is at most 1e-9 of its radius.
/// The spacing of a v-point is that of `spacing_of_v_points`.
///
/// Guarantees: only free ends are cut, so the rest is a deformation retract of the axis, with as many components and
/// cycles. A component that could go entirely keeps the piece that is seen at the largest angle. The result depends on
/// neither the order nor the numbers of the rows. Decisions are those of doubles: they are a matter of tolerance.
///
/// Cost: O(size of the tables).
ScaleHairs cut_hairs(UnionTables& tables, const Table<FamilySlot, double>& spacing);

}  // namespace mes
