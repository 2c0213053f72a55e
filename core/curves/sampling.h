// SPDX-License-Identifier: GPL-3.0-or-later
// Samples of curves.
//
// Corners, where the tangent turns by more than an angle, and the ends of open curves are samples whatever the rule;
// between them samples follow each other at equal lengths of arc, or by the rule `adaptive` at lengths that change
// slowly. A closed curve has no doubled end, and the samples of one curve are different points: where a curve comes
// back to a sample exactly, it passes it over. The result depends on curves and request alone.
//
// Smallest use:
//     auto samples = sample(curves, {.rule = SamplingRule::spacing, .spacing = 0.5});
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "core/base/error.h"
#include "core/curves/curve.h"

namespace mes {

enum class SamplingRule : std::uint8_t {
  vertices,  ///< the ends of pieces; nothing between
  spacing,   ///< neighbours at most `spacing` apart along the curve
  count,     ///< at the least spacing that gives at most `count` samples
  adaptive,  ///< as `count` or denser, so that no more than `share` of the distance to another part of the curves lies
             ///< between neighbours; at most eight times as dense
};

struct SamplingRequest {
  SamplingRule rule = SamplingRule::vertices;
  double spacing = 0.0;        ///< of the rule of that name: positive
  std::size_t count = 0;       ///< of the rule of that name; corners, ends and `least_each` may ask for more
  std::size_t least_each = 3;  ///< samples of a closed curve, or intervals of an open one that is not straight
  double share = 0.4;          ///< of the rule `adaptive`
  /// In radians. Where the tangent turns by more is a corner; pieces of less than a hundredth of the spacing make none.
  double corner_angle = 0.5;
  std::size_t most = 10'000'000;  ///< samples, of all curves together
};

/// What a file is sampled by when it is opened. A drawing of straight lines with at least 400 vertices has been sampled
/// already, and keeps its vertices. Anything else gets about 400 samples, more where parts of it are near to each other
/// (`adaptive`), and at least eight on each curve; without regard to nearness where there are more than 20,000 pieces.
SamplingRequest default_sampling(const CurveSet& curves);

struct SampledCurves {
  /// Samples of one curve, in its order: `count` of them from `first` on.
  struct Chain {
    bool is_closed = false;
    std::size_t first = 0;
    std::size_t count = 0;
    friend bool operator==(const Chain&, const Chain&) = default;
  };
  std::vector<Vec2> positions{};
  std::vector<Chain> chains{};  ///< in the order of the curves, but for those that are single points
};

/// Samples of all curves in their order, then the points that lie on none. Lengths of arc are right within 1e-11 of the
/// length of a piece's control polygon. Cost: O(pieces + samples) evaluations, more at cusps; any thread. Error:
/// `bad_input` for more samples than `most`, and for coordinates that are not finite; `usage` for a spacing that is not
/// positive.
Expected<SampledCurves> sample(const CurveSet& curves, const SamplingRequest& request);

}  // namespace mes
