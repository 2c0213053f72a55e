// SPDX-License-Identifier: GPL-3.0-or-later
// Samples of curves.
//
// Corners, where the tangent turns by more than an angle, and the ends of open curves are samples whatever the rule;
// between them samples follow each other at equal lengths of arc, or by the rule `adaptive` at lengths that change
// slowly. A closed curve has no doubled end, and the samples of one curve are different points: where a curve comes
// back to a sample exactly, it passes it over. The result depends on curves and request alone, and on what is said of
// feature sizes where these are asked for.
//
// Smallest use:
//     auto samples = sample(curves, {.rule = SamplingRule::spacing, .spacing = 0.5});
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <string_view>
#include <vector>

#include "core/base/error.h"
#include "core/base/job_control.h"
#include "core/curves/curve.h"

namespace mes {

enum class SamplingRule : std::uint8_t {
  vertices,  ///< the ends of pieces; nothing between
  spacing,   ///< neighbours at most `spacing` apart along the curve
  count,     ///< at the least spacing that gives at most `count` samples
  adaptive,  ///< as `count` or denser, so that no more than `share` of the distance to another part of the curves lies
             ///< between neighbours; at most eight times as dense
  curvature,  ///< as `count` or denser, so that no more than `turn` of direction lies between neighbours; at most eight
              ///< times as dense
  feature_size,  ///< half the length between neighbours is at most `epsilon` times the feature size of the curves there,
                 ///< as far as intervals of a thousandth of the mean that `count` gives allow it
  refined,  ///< the ends of pieces, as `vertices`, and places between them so that neighbours are no farther apart than
            ///< the mean spacing of `count` samples, than a curve divided by `least_each`, and than `share` of the
            ///< distance to another part of the curves, and nearer towards corners; on each curve at most eight times
            ///< as dense as without the last two
};

struct SamplingRuleDescriptor {
  SamplingRule rule;
  std::string_view id;           ///< public name, kebab case
  std::string_view name;         ///< as shown
  std::string_view explanation;  ///< one sentence
};
/// One for each rule, in the order of the rules.
std::span<const SamplingRuleDescriptor> sampling_rules();

/// Samples of what is opened or made, unless another number is asked for.
inline constexpr std::size_t kUsualSamples = 400;
// Ranges of a request.
inline constexpr double kLeastTurn = 1e-3;
inline constexpr double kMostTurn = 3.2;
inline constexpr double kLeastEpsilon = 0.01;
inline constexpr double kMostEpsilon = 1.0;
inline constexpr double kMostJitter = 100.0;

struct SamplingRequest {
  SamplingRule rule = SamplingRule::vertices;
  double spacing = 0.0;        ///< of the rule of that name: positive
  std::size_t count = 0;       ///< of the rule of that name; corners, ends and `least_each` may ask for more
  std::size_t least_each = 3;  ///< samples of a closed curve, or intervals of an open one that is not straight
  double share = 0.4;          ///< of the rule `adaptive`
  double turn = 0.2;           ///< of the rule `curvature`, radians
  double epsilon = 0.25;       ///< of the rule `feature_size`
  /// In radians. Where the tangent turns by more is a corner; pieces of less than a hundredth of the spacing make none.
  double corner_angle = 0.5;
  double corner_radius = 0.0;     ///< corners are rounded so (core/curves/corners.h); 0: they stay
  double jitter = 0.0;            ///< each sample is moved by up to so many mean spacings (core/curves/jitter.h)
  std::uint64_t seed = 1;         ///< of the jitter
  std::size_t most = 10'000'000;  ///< samples, of all curves together
  friend bool operator==(const SamplingRequest&, const SamplingRequest&) = default;
};

/// What a file is sampled by when it is opened. Curves get about 400 samples, more where parts of them are near to each
/// other (`adaptive`), and at least eight each; without regard to nearness where there are more than 20,000 pieces.
/// Straight lines keep all vertices, and get samples between them where these are far apart (`refined`): no more where
/// they are dense, as along a coast, and some sixteen around a house. Beyond three million samples they would have so,
/// they have their vertices alone. Points alone are what they are.
SamplingRequest default_sampling(const CurveSet& curves);

struct SampledCurves {
  /// Samples of one curve, in its order: `count` of them from `first` on, in `positions`, or in `order` where there is
  /// one.
  struct Chain {
    bool is_closed = false;
    std::size_t first = 0;
    std::size_t count = 0;
    friend bool operator==(const Chain&, const Chain&) = default;
  };
  std::vector<Vec2> positions{};
  std::vector<Chain> chains{};  ///< in the order of the curves, but for those that are single points
  /// Where curves touch: the positions that chains go through, as several may go through one. Empty elsewhere: then
  /// chains go through the positions in their order.
  std::vector<std::uint32_t> order{};
};

/// Distances of samples to the axis of the curve that runs through all of them; infinite where there is none. The samples
/// of a call are often those of the call before, in the same order, and some more. An error of it becomes that of the
/// sampling.
using FeatureSizes = std::function<Expected<std::vector<double>>(std::span<const Vec2>)>;

/// Nothing, or why the request makes no sense.
Expected<void> check(const SamplingRequest& request);

/// Samples of all curves in their order, then the points that lie on none. Lengths of arc are right within 1e-11 of the
/// length of a piece's control polygon. Cost: O(pieces + samples) evaluations, more at cusps; any thread. Error:
/// `bad_input` for more samples than `most` (by the rules from `adaptive` to `feature_size`, for more than a million), and for coordinates that are not finite; `usage` for a request that makes
/// no sense. The rule `feature_size` measures the curves with `sizes` (feature_field.h); without it, that rule is `usage`. Throws `Cancelled` if
/// there is a job, which is looked at every few thousand places.
Expected<SampledCurves> sample(const CurveSet& curves, const SamplingRequest& request, const FeatureSizes& sizes = {},
                               JobControl* job = nullptr);

}  // namespace mes
