// SPDX-License-Identifier: GPL-3.0-or-later
// Samples that can go without the curve and the topology of the axis changing.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "core/base/job_control.h"
#include "core/document/commands.h"
#include "core/engine/theorem_light.h"

namespace mes {

class Registry;

struct Decimation {
  std::vector<std::uint32_t> removed;  ///< numbers of samples, rising
  SampleData data;                     ///< what is left, with the loops and balls
  double epsilon_before = 0.0;         ///< the largest of all curve edges
  double epsilon_after = 0.0;
  TheoremLight light_before = TheoremLight::none;
  TheoremLight light_after = TheoremLight::none;
  std::string no_axis{};        ///< why there is none, and nothing is measured; empty if there is one
  std::int64_t components = 0;  ///< of the one-step axis, before and after
  std::int64_t cycles = 0;

  /// One sentence, without a full stop.
  std::string words() const;
};

/// Takes samples away as long as the rest is an epsilon-sample by the estimate (FeatureSize).
///
/// What it guarantees:
///  1. Of samples that follow each other on the curve of the rest, half the distance is at most `epsilon` times the least
///     size that they, and all samples taken away between them, had at first; and by the estimate from the rest the
///     epsilon of that curve edge is at most `epsilon`, too. This is not said of samples that followed each other before.
///  2. The curve of the rest goes through it in the same order: each such pair is a crust edge.
///  3. The one-step axis has as many components and cycles as before, and the theorem light is not worse.
///  4. Corners, ends of the curve and samples on no curve stay.
///
/// How many go is not the largest possible number. Throws `Cancelled`. Error: a structure failed.
/// Cost: O(n log n), a few times.
Expected<Decimation> decimate(const Registry& registry, const SampleData& data, double epsilon, JobControl& job);

}  // namespace mes
