// SPDX-License-Identifier: GPL-3.0-or-later
// How far apart samples may be by the bends of a curve alone, whatever lies around it. Private to core/curves.
#pragma once

#include <span>
#include <vector>

#include "core/curves/internal/spacing_field.h"
#include "core/curves/internal/stretches.h"

namespace mes {

/// For each curve, for each of its stretches: spacings of `share` times the radius of curvature, which no feature size
/// exceeds; infinite where the curve is straight. Each piece is looked at in a few parts, however short it is beside
/// the spacing of samples, so that a detail between two samples is not missed. Where two pieces meet, what the curve
/// turns there counts as a bend along the halves of both, also where a closed
/// curve without corners goes on where it began: its spacings are the same at both ends. Pieces much shorter than those around them, from rounded
/// coordinates, have no say. Cost: O(pieces).
std::vector<std::vector<StretchSpacing>> spacings_by_bends(std::span<const MeasuredCurve> curves, double share);

}  // namespace mes
