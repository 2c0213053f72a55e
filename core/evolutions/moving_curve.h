// SPDX-License-Identifier: GPL-3.0-or-later
// Chains of samples as evolutions see them: who follows whom, who may move, who goes along.
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <utility>
#include <vector>

#include "core/base/error.h"
#include "core/base/job_control.h"
#include "core/base/vec2.h"
#include "core/document/commands.h"

namespace mes {

/// Chains name samples by their place in the state.
struct MovingCurve {
  using Chain = SampleData::Contour;
  std::vector<Chain> chains;
  bool is_known = false;       ///< from the document
  std::vector<bool> may_move;  ///< by sample; the ends of open chains may not, nor who is met more than once
  /// A sample and the one at the same place that stands for it in the chains: where that goes, this goes.
  std::vector<std::pair<std::uint32_t, std::uint32_t>> followers;
};

/// Loops that were given with the samples.
MovingCurve known_curve(std::vector<MovingCurve::Chain> chains, std::size_t samples);

/// The chains of the one-step crust, in an order that depends on the samples alone. Throws `Cancelled`, and
/// `GeometryError` when a structure fails. O(n log n).
MovingCurve crust_curve(const std::vector<Vec2>& positions, JobControl& job);

/// Calls `visit(before, sample, after)` for every sample of the chains that may move.
template <class Visit>
void for_each_moving(const MovingCurve& curve, Visit visit) {
  for (const MovingCurve::Chain& chain : curve.chains) {
    const std::vector<std::uint32_t>& at = chain.points;
    const std::size_t n = at.size();
    for (std::size_t i = 0; i < n; ++i)
      if (curve.may_move[at[i]]) visit(at[i == 0 ? n - 1 : i - 1], at[i], at[i + 1 == n ? 0 : i + 1]);
  }
}

/// Brings the followers to where those are that stand for them.
void gather_followers(const MovingCurve& curve, std::vector<Vec2>& positions);

}  // namespace mes
