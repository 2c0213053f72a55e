// SPDX-License-Identifier: GPL-3.0-or-later
// Feature sizes of lists of samples, each of which may be the one before and some more.
#pragma once

#include <memory>
#include <span>
#include <vector>

#include "core/base/error.h"
#include "core/base/job_control.h"
#include "core/base/vec2.h"

namespace mes {

/// What curves are measured with (core/curves/feature_field.h).
///
/// Smallest use:
///     SampleSizes sizes(job);
///     auto field = FeatureField::of(curves, request, [&](auto positions) { return sizes.of(positions); }, &job);
class SampleSizes {
 public:
  explicit SampleSizes(JobControl& job);
  ~SampleSizes();
  /// Distances of the samples to their axis (FeatureSize); infinite where there is none. A few more samples than in the
  /// call before cost what they change. Error: a coordinate out of range. Throws `Cancelled`.
  Expected<std::vector<double>> of(std::span<const Vec2> positions);

 private:
  class Measured;

  JobControl& job_;
  std::unique_ptr<Measured> measured_;
  std::vector<Vec2> positions_;
};

}  // namespace mes
