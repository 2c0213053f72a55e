// SPDX-License-Identifier: GPL-3.0-or-later
// Inserts samples where the curve has too few of them.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "core/base/jobs/job_control.h"
#include "core/document/sample_data.h"
#include "core/engine/sampling_verdict.h"

namespace mes {

class Registry;

/// A sample at which the curve has a corner.
struct SampledCorner {
  Vec2 place{};
  double degrees = 180.0;  ///< angle between its two edges
};

struct Repair {
  SampleData data;           ///< the old samples, then the new ones; loops if the data had some
  std::size_t inserted = 0;  ///< number of new samples
  SamplingVerdict before{};  ///< as the window and every command judge the samples
  SamplingVerdict after{};
  bool is_on_curves = false;           ///< new samples lie on the curves of the old ones
  std::size_t off_curve = 0;           ///< samples on none of these curves
  std::size_t crossings = 0;           ///< pairs of sides of outlines that cross: no density satisfies epsilon there
  std::string no_axis{};               ///< why the axis is missing and nothing is measured; empty if there is an axis
  std::vector<SampledCorner> corners;  ///< corners: no density satisfies epsilon at their edges
  std::vector<Vec2> open_ends;         ///< ends and junctions of the curve; edges there are not halved
  std::vector<Vec2> left;              ///< middles of other edges that are still too long, or that fail the theorem

  /// Lists the changes and the remaining problems, one sentence each, without a full stop.
  std::vector<std::string> words() const;
};

/// Halves curve edges until half the length of each is at most `epsilon` times the feature size of its ends
/// (FeatureSize) and the theorem light is not yellow, or until no offending edge can be halved further. Samples
/// inserted only for the light are removed again if it stays yellow.
///
/// If the data know the curves of the samples, and at least half of the samples lie on them, new samples lie exactly on
/// these curves, until the samples stand for them with that epsilon (core/curves/feature_field.h) away from corners.
/// While the light is yellow, samples nearer to the corners, and denser ones, are tried too, and kept if they help.
/// Nothing is inserted into outlines that cross, since the samples would become ever denser there.
/// Otherwise:
///
/// Guarantees:
///  1. Old samples stay. New ones lie on the curve through the old ones: centripetal Catmull-Rom splines, interrupted
///     at corners and ends, and therefore straight between two corners.
///  2. The curve is that of the given loops, or else the one-step crust of the old samples.
///  3. An edge that the curve passes twice is halved once. Edges where the curve meets itself stay. Where the curve
///     returns along itself, it has an end.
///  4. The repair terminates: an edge is halved at most twenty times, and at most 64 samples are inserted for each old
///     one, and at most 200,000 in all; the result lists the remaining edges.
///  5. Between two old samples none is inserted where a thousand would still leave more than 64 edges too long, as
///     where the curve runs back along itself.
///
/// In this case feature sizes are estimated from the current samples. Throws `Cancelled`. Error: a structure failed.
/// Cost: O(n) and a few local updates for each round of halving; the theorem is checked when all edges are short.
/// Source of the spline: Yuksel, Schaefer and Keyser, "Parameterization and applications of Catmull-Rom curves", 2011.
Expected<Repair> repair(const Registry& registry, const SampleData& data, double epsilon, JobControl& job);

}  // namespace mes
