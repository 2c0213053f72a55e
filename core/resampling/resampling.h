// SPDX-License-Identifier: GPL-3.0-or-later
// Other samples of curves, by any rule: what a rule by local feature size measures is measured here, with the program's
// own crust, axis and certificate.
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
#include "core/base/job_control.h"
#include "core/curves/corners.h"
#include "core/curves/feature_field.h"
#include "core/curves/sampling.h"
#include "core/document/commands.h"
#include "core/document/curve_source.h"
#include "core/engine/theorem_light.h"

namespace mes {

/// What is known of samples that were taken.
struct TakenSamples {
  SampleData data{};
  /// Of the rule `feature_size`: how the samples stand for the curves (core/curves/feature_field.h). Its epsilon is at most
  /// what was asked for.
  CurveStanding standing{};
  /// Of the rule `feature_size`: the theorem light for these samples of these curves, as the window has it.
  TheoremLight light = TheoremLight::none;
  bool is_proved() const { return light == TheoremLight::green; }
  /// Middles of edges of the crust between samples that are not neighbours along the curves, as at sharp corners and
  /// crossings, where there are few: the samples there have an odd number of edges, which the light shows.
  std::vector<Vec2> extra_edges{};
  /// Why it is not green: corners next to places where the proof fails, each once, and the places that are at none.
  std::vector<CurveCorner> corners{};
  std::vector<Vec2> other_places{};
};

/// Samples of the curves. Of the rule `feature_size`: where the theorem is not proved for the epsilon that is asked for,
/// smaller ones are tried, down to a quarter of it; if none helps, the first stays, and corners say why. Proved is what is
/// proved of the curves: where the crust has many edges between samples that are not neighbours along them, it is not
/// asked. Cost: that of `FeatureField::of`, and a crust of the samples for each of four epsilons at most. Throws
/// `Cancelled`. Error: as of `sample` and `taken_from`; `bad_input`, with a place, for curves so near to each other
/// throughout that samples as near as they may be are too far apart for the crust to be the curves.
Expected<TakenSamples> take_samples(const std::shared_ptr<const CurveSet>& curves, const SamplingRequest& request,
                                    JobControl& job);

/// Smooth curves through the samples as the one-step crust connects them; samples on no curve are points. Throws
/// `Cancelled`, `GeometryError`.
CurveSet curves_through(const std::vector<Vec2>& positions, JobControl& job);

/// "epsilon 0.24, proved" or why not, in a sentence without a full stop; empty for other rules.
std::string remark_of(const TakenSamples& taken, const SamplingRequest& request);

}  // namespace mes
