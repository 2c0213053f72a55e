// SPDX-License-Identifier: GPL-3.0-or-later
// Curves that touch, as a network of arcs between nodes; curves share their common arcs. Private to core/curves.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "core/base/jobs/job_control.h"
#include "core/curves/curve.h"

namespace mes {

/// Outlines of neighbouring parcels both contain their common side, and the corner of one often lies within a side of
/// the other (a T-junction). If curves were sampled one by one, such sides would get two sets of samples. In a network
/// each side exists once, and curves are walks along arcs.
///
/// Guarantees:
///  1. Nodes are the ends of arcs: points where more or fewer than two arcs meet, or where an open curve ends.
///  2. Each curve is the walk along its arcs, in its order and direction. Curves that repeat another one in the same
///     direction (for open curves, in either) are dropped, because they add nothing.
///  3. A vertex lies on a piece, and the curve passes through it, if its distance is at most the error that rounding
///     can cause (`CurveSet::resolution`), and at most 1/128 of the length of the pieces there. The share is 1/4096 for
///     pieces along an axis and for two vertices, because these coincide after rounding if they did before.
///  4. Curves that touch no other are arcs of their own, unchanged.
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
      nodes{};                  ///< first and last node of each arc; a closed arc has none, or one at its start
  std::vector<double> whole{};  ///< length of the shortest curve that uses the arc
  std::vector<Walk> walks{};    ///< in the order of the curves
};

/// Returns nothing if no curve touches another. To find out, it compares boxes, and vertices where boxes overlap: O(n
/// log n) for n pieces. A curve that touches itself counts only if `within_curves`. Throws `Cancelled` if there is a
/// job.
std::optional<CurveNetwork> network_of(const std::vector<PlaneCurve>& curves, double resolution,
                                       JobControl* job = nullptr, bool within_curves = false);

/// The curve of a walk: its arcs, one after the other.
PlaneCurve curve_of(const CurveNetwork& network, const CurveNetwork::Walk& walk);

}  // namespace mes
