// SPDX-License-Identifier: GPL-3.0-or-later
// How far apart samples may be, place by place: less where curves come near to each other. Private to core/curves.
#pragma once

#include <span>
#include <vector>

#include "core/base/job_control.h"
#include "core/curves/internal/stretches.h"

namespace mes {

/// Spacings at places along a stretch, from its beginning to its end.
struct StretchSpacing {
  double length = 0.0;
  std::vector<double> at;       ///< lengths of arc from the beginning; increasing, from 0 to `length`
  std::vector<double> spacing;  ///< there; two or more

  /// Lengths of arc at which samples lie, from 0 on and without the end: between neighbours as many places of the
  /// spacing that holds there, in each interval the same share of one.
  std::vector<double> places() const;
  /// How many those are.
  double count() const;
};

struct SpacingLimits {
  double widest = 0.0;      ///< where nothing is near
  double finest = 0.0;      ///< however near things are
  double share = 0.0;       ///< of the distance to what is near
  double least_each = 0.0;  ///< spacings along a curve, at least
  /// The finest is, on each curve, the eighth of the widest there: small curves are looked at as closely as large ones. And
  /// it is had at nodes, and at corners that turn by more than `corner_angle`, for the axis reaches into corners as far as
  /// their samples are near.
  bool is_finest_by_curve = false;
  double corner_angle = 0.0;
};

/// For each curve, for each of its stretches. Near a place is what lies on another curve, and what is farther away
/// along the same curve than one and a half times the distance, so that neither a bend wider than the spacing nor a
/// right angle is near itself; arcs that meet at a node count as one curve there. Cost: O(n log n) for n places of half
/// the finest spacing, each compared with some of those within `widest / share`. Throws `Cancelled` if there is a job.
std::vector<std::vector<StretchSpacing>> spacings_of(std::span<const MeasuredCurve> curves,
                                                     const SpacingLimits& limits, JobControl* job = nullptr);

/// The same, with a share of the radius of curvature as the spacing. It changes along a curve by at most half of what
/// is passed. Cost: O(n) places of half the finest spacing.
std::vector<std::vector<StretchSpacing>> spacings_by_curvature(std::span<const MeasuredCurve> curves,
                                                               const SpacingLimits& limits);

}  // namespace mes
