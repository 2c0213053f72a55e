// SPDX-License-Identifier: GPL-3.0-or-later
// Contours that overlap, as the boundary of what they wind around. Private to core/glyphs.
#pragma once

#include <vector>

#include "core/curves/curve.h"

namespace mes {

/// Closed curves whose coordinates are design units of a font, as they are filled by the rule of nonzero winding: a
/// contour that meets no other and not itself, and is part of the boundary, stays as it is, to the last bit. Where
/// contours cross, touch, or lie within what is filled already, the boundary takes their place, of straight pieces that
/// are nowhere further than `tolerance` from the curves, in the order of the union.
///
/// Decisions are those of Clipper, which are exact for the corners of these pieces, rounded to a 1024th of a unit.
std::vector<PlaneCurve> united_contours(std::vector<PlaneCurve> contours, double tolerance);

}  // namespace mes
