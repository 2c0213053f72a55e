// SPDX-License-Identifier: GPL-3.0-or-later
// Distances of samples along curves: smaller where curves come close to each other. Private to core/curves.
#pragma once

#include <span>
#include <vector>

#include "core/base/jobs/job_control.h"
#include "core/curves/internal/stretches.h"

namespace mes {

/// Spacings at points along a stretch, from its beginning to its end.
struct StretchSpacing {
  double length = 0.0;
  std::vector<double> at;       ///< arc lengths from the beginning; increasing, from 0 to `length`
  std::vector<double> spacing;  ///< spacing at each of these; two or more

  /// Arc lengths of samples, from 0 on and without the end. Their distances follow the spacing, reduced by one common
  /// factor so that a whole number of intervals fits.
  std::vector<double> places() const;
  /// The number of samples that `places` returns.
  double count() const;
};

struct SpacingLimits {
  double widest = 0.0;      ///< where nothing is near
  double finest = 0.0;      ///< lower limit, however close things are
  double share = 0.0;       ///< share of the distance to nearby curves
  double least_each = 0.0;  ///< minimum number of spacings along a curve
  /// If true, the finest spacing is an eighth of the widest on each curve, so that small curves are examined as closely
  /// as large ones. It also holds at nodes, and at corners that turn by more than `corner_angle`, because the axis
  /// reaches into corners only as far as their samples are dense.
  bool is_finest_by_curve = false;
  double corner_angle = 0.0;
};

/// Spacings for each curve and each of its stretches, by the distance to nearby points. These lie on another curve, or
/// on the same curve if the distance along it exceeds one and a half times the straight distance. So neither a bend
/// wider than the spacing nor a right angle is near itself. Arcs that meet at a node count as one curve there. Cost:
/// O(n log n) for n probes at half the finest spacing, each compared with some of those within `widest / share`. Throws
/// `Cancelled` if there is a job.
std::vector<std::vector<StretchSpacing>> spacings_of(std::span<const MeasuredCurve> curves,
                                                     const SpacingLimits& limits, JobControl* job = nullptr);

/// The same, with a share of the radius of curvature as the spacing. It changes by at most half of the length along the
/// curve. Cost: O(n) for n probes at half the finest spacing.
std::vector<std::vector<StretchSpacing>> spacings_by_curvature(std::span<const MeasuredCurve> curves,
                                                               const SpacingLimits& limits);

}  // namespace mes
