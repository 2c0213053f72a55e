// SPDX-License-Identifier: GPL-3.0-or-later
// Places of samples by local feature size, found by measuring samples and placing others. Private to core/curves.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "core/base/error.h"
#include "core/base/job_control.h"
#include "core/curves/internal/spacing_field.h"
#include "core/curves/internal/stretches.h"
#include "core/curves/sampling.h"

namespace mes {

/// What curves of some length are measured within.
struct FeatureLimits {
  SpacingLimits first{};   ///< to look around to begin with (`spacings_of`)
  SpacingLimits places{};  ///< `share` is the epsilon
};
FeatureLimits feature_limits(const SamplingRequest& request, double length, double epsilon);

/// A place of a curve, and what the samples of the last round show there.
struct MeasuredPlace {
  double at = 0.0;  ///< length of arc from the beginning of its stretch
  Vec2 position{};
  double size = 0.0;  ///< distance to the axis of these samples
  double epsilon =
      0.0;  ///< the larger of both intervals beside it: half its length over the smaller size of its ends
};
/// Of each curve, of each of its stretches, from its beginning to its end.
using MeasuredPlaces = std::vector<std::vector<std::vector<MeasuredPlace>>>;

/// Places so near to each other that half the distance of neighbours is at most `limits.share`, and nearly everywhere at
/// most one and a half times `fine`, which is half of it, times the smaller feature size of both, or their distance along
/// the curve is `limits.finest`. Along stretches of
/// pieces that meet at small angles, as those of a polygon for a circle do, it is `limits.share` that holds: finer
/// places would show the angles, not the circle.
///
/// Begins with `first`, so near to each other as `fine` asks for, and nowhere with more than the bends of the curve allow,
/// which bound feature sizes from above whatever the samples show, nor with more than a feature size may grow from there.
/// Where that is not near enough, what is measured says where samples with `limits.share` should be; that is done anew until
/// nearly all intervals have it. Then each is halved, or divided for `fine`. What is still too long is divided, so that it
/// comes to an end: only what is new need be measured. Error: that of `sizes`; `bad_input` for more places than `most`.
/// Throws `Cancelled` if there is a job.
Expected<MeasuredPlaces> places_by_feature_size(std::span<const MeasuredCurve> curves,
                                                std::vector<std::vector<StretchSpacing>> first,
                                                const SpacingLimits& limits, double fine, std::size_t most,
                                                const FeatureSizes& sizes, JobControl* job);

}  // namespace mes
