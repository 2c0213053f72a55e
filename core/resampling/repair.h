// SPDX-License-Identifier: GPL-3.0-or-later
// Samples inserted where the curve has too few of them.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "core/base/job_control.h"
#include "core/document/commands.h"
#include "core/engine/theorem_light.h"

namespace mes {

class Registry;

/// A place where the curve turns at once.
struct SampledCorner {
  Vec2 place{};
  double degrees = 180.0;  ///< between its two edges
};

struct Repair {
  SampleData data;           ///< the samples as they were, then the new ones; loops if there were some
  std::size_t inserted = 0;  ///< how many are new
  /// The largest of the curve edges that do not end at a corner, end or junction; infinite where one of these is missing.
  double epsilon_before = 0.0;
  double epsilon_after = 0.0;
  TheoremLight light_before = TheoremLight::none;
  TheoremLight light_after = TheoremLight::none;
  bool is_on_curves =
      false;  ///< new samples lie on the curves that the others were taken from, and epsilons are by these
  std::size_t exempt = 0;              ///< corners and meetings of curves that the epsilons leave out
  std::size_t off_curve = 0;           ///< samples that lie on none of these
  std::string no_axis{};               ///< why there is none, and nothing is measured; empty if there is one
  std::vector<SampledCorner> corners;  ///< at which edges are too long however short they are
  std::vector<Vec2> open_ends;         ///< ends and junctions of the curve: edges there stay as they are
  std::vector<Vec2> left;              ///< middles of other edges that are too long still, or doubted by the theorem

  /// What was done and what could not be, one sentence each, without a full stop.
  std::vector<std::string> words() const;
};

/// Halves curve edges until none has half its length over the feature size of its ends (FeatureSize) above `epsilon`, and
/// the theorem's light is not yellow; or until no edge that is in the way can be halved any more. What is inserted for the
/// light alone is taken back if that stays yellow.
///
/// Where the data know the curves that the samples were taken from, and at least half of the samples lie on them, new
/// ones are put exactly on these curves, until the samples stand for them with that epsilon (core/curves/feature_field.h)
/// away from corners; and nearer to the corners and denser while the light is yellow, if that helps. Otherwise:
///
/// What it guarantees:
///  1. Samples stay where they are. New ones lie on the curve through the old ones: centripetal Catmull-Rom splines,
///     interrupted at corners and ends, so straight between two corners.
///  2. The curve is that of the loops given, or the one-step crust of the samples as they were.
///  3. An edge that the curve passes twice is halved once. Edges at a place where it meets itself are left alone; where it
///     goes back the way it came, it ends.
///  4. It ends: an edge is halved at most twenty times, and no more than 64 samples are inserted for each, or 200,000
///     together; what is left is listed.
///
/// Then feature sizes are estimates from the samples of each moment. Throws `Cancelled`. Error: a structure failed.
/// Cost: O(n) and a few local updates for each round of halving.
/// Source of the spline: Yuksel, Schaefer and Keyser, "Parameterization and applications of Catmull-Rom curves", 2011.
Expected<Repair> repair(const Registry& registry, const SampleData& data, double epsilon, JobControl& job);

}  // namespace mes
