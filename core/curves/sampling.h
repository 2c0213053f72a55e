// SPDX-License-Identifier: GPL-3.0-or-later
// Samples of curves.
//
// Corners, where the tangent turns by more than an angle, and the ends of open curves are always samples. Between them,
// samples have equal distances along the curve, or slowly changing ones by rules such as `adaptive`. A closed curve has
// no duplicate end, and the samples of one curve are distinct: if a curve returns exactly to a sample, it is not added
// again. The result depends only on the curves and the request, and on the feature sizes if the rule uses them.
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
#include "core/base/jobs/job_control.h"
#include "core/curves/curve.h"

namespace mes {

enum class SamplingRule : std::uint8_t {
  vertices,  ///< only the ends of pieces; of closed curves of one or two pieces also points between them
  spacing,   ///< neighbours are at most `spacing` apart along the curve
  count,     ///< the least spacing that gives at most `count` samples
  adaptive,  ///< at least as dense as `count`: the distance between neighbours is at most `share` of the distance to
             ///< another part of the curves; at most eight times as dense
  curvature,  ///< at least as dense as `count`: the direction turns by at most `turn` between neighbours; at most eight
              ///< times as dense
  feature_size,  ///< half the length between neighbours is at most `epsilon` times the feature size of the curves
                 ///< there; no interval is shorter than a thousandth of the mean that `count` gives
  refined,  ///< the ends of pieces, as `vertices`, and samples between them. Neighbours are no farther apart than the
            ///< mean spacing of `count` samples, the curve's length divided by `least_each`, and `share` of the
            ///< distance to another part of the curves, and closer towards corners; on each curve at most eight times
            ///< as dense as without the last two
};

struct SamplingRuleDescriptor {
  SamplingRule rule;
  std::string_view id;           ///< public name, kebab case
  std::string_view name;         ///< name in the interface
  std::string_view explanation;  ///< one sentence
};
/// One descriptor for each rule, in the order of the rules.
std::span<const SamplingRuleDescriptor> sampling_rules();

/// Default number of samples for opened or created curves.
inline constexpr std::size_t kUsualSamples = 400;
// Ranges of a request.
inline constexpr double kLeastTurn = 1e-3;
inline constexpr double kMostTurn = 3.2;
inline constexpr double kLeastEpsilon = 0.01;
inline constexpr double kMostEpsilon = 1.0;
inline constexpr double kMostJitter = 100.0;
/// Corners would require infinitely many samples by local feature size. So no part of the curves gets more than this many
/// times the density of `SamplingRequest::count` samples spread evenly along the curves.
inline constexpr double kFinestFeature = 1000.0;

struct SamplingRequest {
  SamplingRule rule = SamplingRule::vertices;
  double spacing = 0.0;        ///< for the rule `spacing`; positive
  std::size_t count = 0;       ///< for the rule `count`; corners, ends and `least_each` may require more
  std::size_t least_each = 3;  ///< samples of a closed curve, or intervals of an open one that is not straight
  double share = 0.4;          ///< for the rule `adaptive`
  double turn = 0.2;           ///< for the rule `curvature`, in radians
  double epsilon = 0.25;       ///< for the rule `feature_size`
  /// Corners are where the tangent turns by more, in radians; pieces below a hundredth of the spacing make no corners.
  double corner_angle = 0.5;
  double corner_radius = 0.0;     ///< radius for rounding corners (core/curves/corners.h); 0: no rounding
  double jitter = 0.0;            ///< moves each sample by up to this many mean spacings (core/curves/jitter.h)
  std::uint64_t seed = 1;         ///< seed of the jitter
  std::size_t most = 10'000'000;  ///< limit on samples of all curves together
  friend bool operator==(const SamplingRequest&, const SamplingRequest&) = default;
};

/// The default request for an opened file. Curves get about 400 samples, more where parts of them are close to each
/// other (`adaptive`), and at least eight each; with more than 20,000 pieces closeness is ignored. Straight lines keep
/// all vertices, and get samples between vertices that are far apart (`refined`): none where vertices are dense, as
/// along a coast, and about sixteen around a house. If that would give more than three million samples, they keep only
/// their vertices. Files with only points keep these points.
SamplingRequest default_sampling(const CurveSet& curves);

struct SampledCurves {
  /// Samples of one curve, in order: `count` entries from `first` on, in `positions`, or in `order` if it is not empty.
  struct Chain {
    bool is_closed = false;
    std::size_t first = 0;
    std::size_t count = 0;
    friend bool operator==(const Chain&, const Chain&) = default;
  };
  std::vector<Vec2> positions{};
  std::vector<Chain> chains{};  ///< in the order of the curves; curves that are single points have none
  /// If curves touch: the indices of the positions of each chain, because several chains may share a position.
  /// Otherwise empty: chains then list positions in their order.
  std::vector<std::uint32_t> order{};
};

/// Distances of samples to the axis of the curve that runs through all of them; infinite if there is no axis. The
/// samples of a call often extend those of the previous call, in the same order. Its error becomes the error of the
/// sampling.
using FeatureSizes = std::function<Expected<std::vector<double>>(std::span<const Vec2>)>;

/// Returns an error if the request makes no sense.
Expected<void> check(const SamplingRequest& request);

/// Samples of all curves in their order, then the isolated points. Arc lengths are accurate to 1e-11 of the length of a
/// piece's control polygon. Cost: O(pieces + samples) evaluations, more at cusps; any thread. Error: `bad_input` for
/// more samples than `most` (for the rules from `adaptive` to `feature_size`, more than a million), and for coordinates
/// that are not finite; `usage` for a request that makes no sense. The rule `feature_size` measures the curves with
/// `sizes` (feature_field.h); without `sizes` it is `usage`. Throws `Cancelled` if there is a job, which is checked
/// every few thousand samples.
Expected<SampledCurves> sample(const CurveSet& curves, const SamplingRequest& request, const FeatureSizes& sizes = {},
                               JobControl* job = nullptr);

}  // namespace mes
