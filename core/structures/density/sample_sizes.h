// SPDX-License-Identifier: GPL-3.0-or-later
// Feature sizes of lists of samples, where a list may extend the one before.
#pragma once

#include <memory>
#include <span>
#include <vector>

#include "core/base/error.h"
#include "core/base/geometry/vec2.h"
#include "core/base/jobs/job_control.h"

namespace mes {

/// Provides the sizes by which curves are measured (core/curves/feature_field.h).
///
/// Smallest use:
///     SampleSizes sizes(job);
///     auto field = FeatureField::of(curves, request, [&](auto positions) { return sizes.of(positions); }, &job);
class SampleSizes {
 public:
  explicit SampleSizes(JobControl& job);
  ~SampleSizes();
  /// Distances of the samples to their axis (FeatureSize); infinite if there is no axis. Adding a few samples to those
  /// of the call before costs only what they change. Error: a coordinate out of range. Throws `Cancelled`.
  Expected<std::vector<double>> of(std::span<const Vec2> positions);

 private:
  class Measured;

  JobControl& job_;
  std::unique_ptr<Measured> measured_;
  std::vector<Vec2> positions_;
};

}  // namespace mes
