// SPDX-License-Identifier: GPL-3.0-or-later
// Largest distance of samples that the bends of a curve alone allow, whatever lies around it. Private to core/curves.
#pragma once

#include <span>
#include <vector>

#include "core/curves/internal/spacing_field.h"
#include "core/curves/internal/stretches.h"

namespace mes {

/// For each curve and each of its stretches: spacings of `share` times the radius of curvature, which no feature size
/// exceeds; infinite where the curve is straight. Each piece is examined in a few parts, even if it is much shorter
/// than the spacing, so that no detail between two samples is missed. The angle where two pieces meet counts as a bend
/// over the adjacent halves of both. This includes the start of a closed curve without corners: its spacings are the
/// same at both ends. Pieces much shorter than those around them come from rounded coordinates and are ignored. Cost:
/// O(pieces).
std::vector<std::vector<StretchSpacing>> spacings_by_bends(std::span<const MeasuredCurve> curves, double share);

}  // namespace mes
