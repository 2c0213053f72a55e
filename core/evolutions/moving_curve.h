// SPDX-License-Identifier: GPL-3.0-or-later
// Chains of samples for evolutions: order of samples, which of them may move, and which follow others.
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <utility>
#include <vector>

#include "core/base/error.h"
#include "core/base/geometry/vec2.h"
#include "core/base/jobs/job_control.h"
#include "core/document/sample_data.h"

namespace mes {

/// Chains name samples by their index in the state.
struct MovingCurve {
  using Chain = SampleData::Contour;
  std::vector<Chain> chains;
  bool is_known = false;       ///< the document has these loops
  std::vector<bool> may_move;  ///< for each sample; false for ends of open chains, and for repeated samples
  /// Pairs of a sample and the equal sample that represents it in the chains; the first moves with the second.
  std::vector<std::pair<std::uint32_t, std::uint32_t>> followers;
};

/// Loops that came with the samples.
MovingCurve known_curve(std::vector<MovingCurve::Chain> chains, std::size_t samples);

/// The chains of the one-step crust, in an order that depends only on the samples. Throws `Cancelled`, and
/// `GeometryError` if a structure fails. O(n log n).
MovingCurve crust_curve(const std::vector<Vec2>& positions, JobControl& job);

/// Calls `visit(before, sample, after)` for every movable sample of the chains.
template <class Visit>
void for_each_moving(const MovingCurve& curve, Visit visit) {
  for (const MovingCurve::Chain& chain : curve.chains) {
    const std::vector<std::uint32_t>& at = chain.points;
    const std::size_t n = at.size();
    for (std::size_t i = 0; i < n; ++i)
      if (curve.may_move[at[i]]) visit(at[i == 0 ? n - 1 : i - 1], at[i], at[i + 1 == n ? 0 : i + 1]);
  }
}

/// Moves followers to the samples that represent them.
void gather_followers(const MovingCurve& curve, std::vector<Vec2>& positions);

}  // namespace mes
