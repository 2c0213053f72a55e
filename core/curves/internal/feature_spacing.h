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

struct FeaturePlaces {
  /// Of each curve, of each of its stretches: its samples from its beginning on, which is among them, and its end not.
  std::vector<std::vector<std::vector<Vec2>>> positions{};
  bool is_reached = false;  ///< every interval has the epsilon, or is as short as intervals may become
};

/// Half the distance of neighbours is at most epsilon (`limits.share`) times the smaller feature size of both, or their
/// distance along the curve is `limits.finest`.
///
/// Begins with `first`, and nowhere with more than the bends of the curve allow, which bound feature sizes from above
/// whatever the samples show, nor with more than a feature size may grow from there. What is measured of these samples
/// says where others should be; that is done anew until nearly all intervals are as they should be. Then samples stay, and
/// intervals that are still too long are divided, so that it comes to an end: only what is new need be measured. Error: that of `sizes`; `bad_input` for more samples than
/// `most`. Throws `Cancelled` if there is a job.
Expected<FeaturePlaces> places_by_feature_size(std::span<const MeasuredCurve> curves,
                                               std::vector<std::vector<StretchSpacing>> first,
                                               const SpacingLimits& limits, std::size_t most,
                                               const FeatureSizes& sizes, JobControl* job);

}  // namespace mes
