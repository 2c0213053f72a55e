// SPDX-License-Identifier: GPL-3.0-or-later
// Curves that touch, as arcs between nodes: what several curves have in common is one arc. Private to core/curves.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "core/base/job_control.h"
#include "core/curves/curve.h"

namespace mes {

/// Neighbouring parcels have their common side in both outlines, and the corner of one often lies within a side of the
/// other (a T-junction). Sampled one by one, such sides would get samples beside each other. In a network each is there
/// once, and curves are walks along arcs.
///
/// What it guarantees:
///  1. Nodes are the ends of arcs: where more or fewer than two arcs meet, or an open curve ends.
///  2. Each curve is the walk along its arcs, in its order and direction. Left out are curves that repeat another one in
///     the same direction (of open curves, in either), for they would say the same again.
///  3. A vertex lies on a piece, and the curve goes through it, if its distance is at most what rounding can have moved it
///     and the ends of the piece by (`CurveSet::resolution`), and at most 1/128 of the length of the pieces there. It is
///     1/4096 for pieces along an axis and for two vertices, as these coincide after rounding if they did before.
///  4. Curves that touch no other are arcs of their own, as they are given.
struct CurveNetwork {
  struct Step {
    std::uint32_t arc = 0;
    bool is_backwards = false;
    friend auto operator<=>(const Step&, const Step&) = default;
  };
  struct Walk {
    std::vector<Step> steps{};
    bool is_closed = false;
  };
  static constexpr std::uint32_t kNoNode = 0xffffffffU;

  std::vector<PlaneCurve> arcs{};
  std::vector<std::array<std::uint32_t, 2>>
      nodes{};                  ///< of each arc, first and last; none for a closed arc without a
                                ///< node, one at the start of a closed arc
  std::vector<double> whole{};  ///< the length of the shortest curve that goes along the arc
  std::vector<Walk> walks{};    ///< in the order of the curves
};

/// Nothing where no curve touches another, which takes a look at their boxes, and at the vertices where boxes overlap:
/// O(n log n) for n pieces. That a curve touches itself counts only if `within_curves`. Throws `Cancelled` if there is a
/// job.
std::optional<CurveNetwork> network_of(const std::vector<PlaneCurve>& curves, double resolution,
                                       JobControl* job = nullptr, bool within_curves = false);

/// The arcs of a walk, one after the other.
PlaneCurve curve_of(const CurveNetwork& network, const CurveNetwork::Walk& walk);

}  // namespace mes
