// SPDX-License-Identifier: GPL-3.0-or-later
// Takes new samples of curves by any rule. The quantities of the rule by local feature size are measured here, with the
// program's own crust, axis and certificate.
//
// Smallest use:
//     JobControl job;
//     auto taken = take_samples(curves, {.rule = SamplingRule::feature_size, .count = 400, .epsilon = 0.25}, job);
//     if (taken) document.apply(*resample(document, taken->data));
#pragma once

#include <cstddef>
#include <memory>
#include <string>
#include <vector>

#include "core/base/error.h"
#include "core/base/jobs/job_control.h"
#include "core/curves/corners.h"
#include "core/curves/feature_field.h"
#include "core/curves/sampling.h"
#include "core/document/curve_source.h"
#include "core/document/sample_data.h"
#include "core/engine/sampling_verdict.h"

namespace mes {

/// Samples that were taken, and their verdict.
struct TakenSamples {
  SampleData data{};
  /// For the rule `feature_size`: how the samples stand for the curves (core/curves/feature_field.h). Its epsilon is at
  /// most the requested one.
  CurveStanding standing{};
  /// For the rule `feature_size`: the verdict on these samples of these curves, as in the window.
  SamplingVerdict verdict{};
  bool is_proved() const { return verdict.light == TheoremLight::green; }
  /// Middles of crust edges between samples that are not neighbours along the curves. Sharp corners and crossings have
  /// a few of them: the samples there have an odd number of edges, which the light shows.
  std::vector<Vec2> extra_edges{};
  /// Reasons if the light is not green: corners where the proof fails nearby, each once, and failures away from
  /// corners.
  std::vector<CurveCorner> corners{};
  std::vector<Vec2> other_places{};
};

/// Samples the curves. For the rule `feature_size`: if the theorem is not proved for the requested epsilon, smaller
/// ones are tried, down to a quarter of it; if none helps, the first result stays, and its corners tell why. The proof
/// concerns the curves: if the crust has many edges between samples that are not neighbours along them, the certificate
/// is not asked. Cost: that of `FeatureField::of`, and a crust of the samples for each of at most four epsilons. Throws
/// `Cancelled`. Error: as `sample` and `taken_from`; `bad_input`, with a position, for curves so near to each other
/// throughout that even the densest samples allowed are too far apart for the crust to be the curves.
Expected<TakenSamples> take_samples(const std::shared_ptr<const CurveSet>& curves, const SamplingRequest& request,
                                    JobControl& job);

/// Smooth curves through the samples as the one-step crust connects them; samples on no curve become points. Throws
/// `Cancelled`, `GeometryError`.
CurveSet curves_through(const std::vector<Vec2>& positions, JobControl& job);

/// The verdict in its words, and the reason if it is not proved, as a sentence without a full stop; empty for other
/// rules.
std::string remark_of(const TakenSamples& taken, const SamplingRequest& request);

}  // namespace mes
