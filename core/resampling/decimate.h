// SPDX-License-Identifier: GPL-3.0-or-later
// Removes samples while the curve and the topology of the axis stay the same.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "core/base/jobs/job_control.h"
#include "core/document/sample_data.h"
#include "core/engine/sampling_verdict.h"

namespace mes {

class Registry;

struct Decimation {
  std::vector<std::uint32_t> removed;  ///< sample numbers, increasing
  SampleData data;                     ///< the remaining samples, with loops and balls
  SamplingVerdict before{};            ///< as the window and every command judge the samples
  SamplingVerdict after{};
  std::string no_axis{};        ///< why the axis is missing and nothing is measured; empty if there is an axis
  std::int64_t components = 0;  ///< components of the one-step axis, before and after
  std::int64_t cycles = 0;

  /// Describes the result in one sentence, without a full stop.
  std::string words() const;
};

/// Removes samples while the remaining ones are an epsilon-sample: by the estimate (FeatureSize), and also by the
/// feature size of the curves if all samples lie on the curves that they were taken from.
///
/// Guarantees:
///  1. Let two remaining samples be neighbours on the curve with removed samples between them. Half their distance is
///     at most `epsilon` times the least original feature size of the two and of the removed ones; and the epsilon of
///     their curve edge, estimated from the remaining samples, is at most `epsilon` too. Between two such
///     samples on curves, none is missing for that epsilon (`FeatureField::filled`). Pairs that were neighbours before
///     have no such guarantee.
///  2. The curve of the remaining samples visits them in the same order: each such pair is a crust edge.
///  3. The one-step axis keeps its numbers of components and cycles, and the theorem light does not get worse.
///  4. Corners, ends of the curve and samples on no curve stay.
///
/// The number of removed samples is not the largest possible. Throws `Cancelled`. Error: a structure failed.
/// Cost: O(n log n), a few times.
Expected<Decimation> decimate(const Registry& registry, const SampleData& data, double epsilon, JobControl& job);

}  // namespace mes
