// SPDX-License-Identifier: GPL-3.0-or-later
// Spacings by local feature size, found by measuring samples and placing others. Private to core/curves.
#pragma once

#include <span>
#include <vector>

#include "core/base/error.h"
#include "core/curves/internal/spacing_field.h"
#include "core/curves/internal/stretches.h"
#include "core/curves/sampling.h"

namespace mes {

struct FeatureSpacings {
  std::vector<std::vector<StretchSpacing>> spacings{};  ///< of each curve, of each of its stretches
  bool is_reached = false;  ///< every interval has the epsilon, or is as short as intervals may become
};

/// Begins with `first`, measures the samples that this gives, and places others by what was found, until each interval
/// is at most twice epsilon times the smaller feature size of its ends, or `limits.finest`. What was dense once stays
/// so after a few rounds, so that it comes to an end. `limits.share` is the epsilon. Error: that of `sizes`;
/// `bad_input` for more samples than `most`.
Expected<FeatureSpacings> spacings_by_feature_size(std::span<const MeasuredCurve> curves,
                                                   std::vector<std::vector<StretchSpacing>> first,
                                                   const SpacingLimits& limits, std::size_t most,
                                                   const FeatureSizes& sizes);

}  // namespace mes
