// SPDX-License-Identifier: GPL-3.0-or-later
// Areas that are filled by the nonzero rule, as curves that enclose them by the even-odd rule, too.
//
// Smallest use:
//     auto area = nonzero_area(std::move(curves));
//     if (area.is_changed) use(area.curves);
#pragma once

#include <vector>

#include "core/curves/curve.h"

namespace mes {

struct FilledArea {
  std::vector<PlaneCurve> curves{};
  bool is_changed = false;  ///< the rules differ, and `curves` are new ones, without names
  bool is_unknown = false;  ///< whether the rules differ would take too long to find out; `curves` are those given
};

/// The area that closed curves enclose by the nonzero rule. Where the even-odd rule gives the same area, the curves are
/// returned unchanged, to the last bit; otherwise the boundary of the area consists of parts of them, as in
/// core/curves/clip_region.h, and open curves follow.
///
/// Cost: O(n log n) for n pieces where none crosses another, otherwise that of Clipper. Where this would take more than
/// about a second, or a tenth of a millisecond for each piece, the area is unknown.
FilledArea nonzero_area(std::vector<PlaneCurve> curves);

}  // namespace mes
