// SPDX-License-Identifier: GPL-3.0-or-later
// Finds samples by local feature size, by repeatedly measuring samples and choosing others. Private to core/curves.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "core/base/error.h"
#include "core/base/jobs/job_control.h"
#include "core/curves/internal/spacing_field.h"
#include "core/curves/internal/stretches.h"
#include "core/curves/sampling.h"

namespace mes {

/// Limits for measuring curves of some total length.
struct FeatureLimits {
  SpacingLimits first{};   ///< for the first look around (`spacings_of`)
  SpacingLimits places{};  ///< `share` is the epsilon
};
FeatureLimits feature_limits(const SamplingRequest& request, double length, double epsilon);

/// A point of a curve, with the measurements of the samples of the last round.
struct MeasuredPlace {
  double at = 0.0;  ///< arc length from the beginning of its stretch
  Vec2 position{};
  double size = 0.0;     ///< distance to the axis of these samples
  double epsilon = 0.0;  ///< the larger of both adjacent intervals: half its length over the smaller size at its ends
};
/// For each curve and each of its stretches, from its beginning to its end.
using MeasuredPlaces = std::vector<std::vector<std::vector<MeasuredPlace>>>;

/// Chooses samples whose distances satisfy one of two limits. Either half the distance of neighbours is at most
/// `limits.share` times the smaller feature size of both (nearly everywhere: one and a half times `fine`), or their
/// distance along the curve is `limits.finest`. `fine` is half of `limits.share`. Along stretches whose pieces meet at
/// small angles, as in a polygon that stands for a circle, only `limits.share` applies: finer samples would reveal the
/// angles, not the circle.
///
/// Starts with samples from `first` that are as dense as `fine` asks for. Their spacing never exceeds the bound from
/// the bends of the curve, which bound feature sizes from above, nor the growth that a feature size can have from
/// there. If that is not dense enough, the measured sizes determine where samples with `limits.share` should be; this
/// is repeated until nearly all intervals have it. Then each interval is halved, or divided for `fine`. Intervals that
/// are still too long are divided, which terminates and only needs measurements of new samples. Error: an error of
/// `sizes`; `bad_input` for more samples than `most`. Throws `Cancelled` if there is a job.
Expected<MeasuredPlaces> places_by_feature_size(std::span<const MeasuredCurve> curves,
                                                std::vector<std::vector<StretchSpacing>> first,
                                                const SpacingLimits& limits, double fine, std::size_t most,
                                                const FeatureSizes& sizes, JobControl* job);

}  // namespace mes
