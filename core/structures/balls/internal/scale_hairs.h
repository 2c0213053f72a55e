// SPDX-License-Identifier: GPL-3.0-or-later
// Hairs of the axis of grown balls: branches that end at scallops of the boundary no longer than the sampling.
#pragma once

#include <cstdint>

#include "core/structures/balls/internal/union_tables.h"

namespace mes {

/// How far equal balls of radius 1 are apart whose circles cross at `sampling_angle` degrees.
double distance_of_sampled(double sampling_angle);
/// The share of spacings that counts at a factor: 0 at 1, where there are no hairs, so that the axis does not jump there,
/// and 1 from 0.02 away on.
double share_of_spacing(double factor);

/// The largest `spacing` of the balls that cross at each v-point.
Table<VPointSlot, double> spacing_of_v_points(const UnionTables& tables, const Table<FamilySlot, double>& spacing);

/// What was taken off.
struct ScaleHairs {
  std::int64_t pieces = 0;
  double length = 0.0;
};

/// Takes hairs off the axis of the tables, from free ends inwards. A piece may go if, at each of its points,
///  * the two nearest v-points are no farther from each other than the sum of their spacings, and
///  * these are seen at less than 60 degrees;
/// or if its length is at most 1e-9 of its radius.
/// The spacing of a v-point is that of `spacing_of_v_points`.
///
/// What it guarantees: only free ends go, so the rest is a deformation retract of the axis, with as many components and
/// cycles. A component of which all could go keeps the piece that is seen at the largest angle. What is left depends on
/// neither the order nor the numbers of the rows. Decisions are those of doubles: they are a matter of tolerance.
///
/// Cost: O(size of the tables).
ScaleHairs cut_hairs(UnionTables& tables, const Table<FamilySlot, double>& spacing);

}  // namespace mes
