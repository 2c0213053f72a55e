// SPDX-License-Identifier: GPL-3.0-or-later
// The verdict on the samples of a run, as every page, bar, message and command gives it.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>

#include "core/base/geometry/sampling_epsilon.h"
#include "core/base/geometry/vec2.h"
#include "core/draw/patch.h"
#include "core/engine/theorem_light.h"

namespace mes {

/// The epsilon of more samples is measured only if a layer or a page shows it: it takes longer than all the rest, 0.3 s
/// instead of 0.2 s for 100,000 samples.
inline constexpr std::size_t kMostSamplesMeasuredUnasked = 10'000;

/// Guarantee: the same samples of the same curves, judged with the same structures, have the same verdict in the same
/// words everywhere. Nothing else in the program words an epsilon or the light.
///
/// Smallest use:
///     bench.need<FeatureSize>();
///     bench.set_want_findings(true);
///     if (bench.run(job)) say(sampling_verdict(bench.nodes()).text());
struct SamplingVerdict {
  TheoremLight light = TheoremLight::none;
  std::optional<SamplingEpsilon> epsilon{};  ///< nothing if it was not measured, or no edge counts
  Vec2 sparsest{};                           ///< where the epsilon is reached, if there is one

  /// "epsilon 0.241 (2 corners exempt); the theorem is proved for these samples".
  std::string text() const;
};

/// The verdict from the reports of a run with findings. The epsilon is there if a structure that measures it was
/// needed; samples of known curves are always measured.
SamplingVerdict sampling_verdict(std::span<const NodeReport> nodes);

}  // namespace mes
