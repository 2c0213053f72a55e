// SPDX-License-Identifier: GPL-3.0-or-later
// Contours that overlap, as the boundary of what they wind around. Private to core/glyphs.
#pragma once

#include <vector>

#include "core/base/job_control.h"
#include "core/curves/curve.h"

namespace mes {

/// Closed curves whose coordinates are design units of a font, as they are filled by the rule of nonzero winding: a
/// contour that meets no other and not itself, and is part of the boundary, stays as it is, to the last bit. Where
/// contours cross, touch, or lie within what is filled already, the boundary takes their place, of straight pieces that
/// are nowhere further than `tolerance` from the curves, after those that stay.
///
/// Decisions are those of Clipper, which are exact for the corners of these pieces, rounded to a 1024th of a unit. Contours
/// whose bounding boxes meet are united in one call, others in calls of their own: so what a letter becomes does not depend
/// on those that it is apart from. Throws `Cancelled` if there is a job, which is looked at between these calls.
std::vector<PlaneCurve> united_contours(std::vector<PlaneCurve> contours, double tolerance,
                                        JobControl* job = nullptr);

}  // namespace mes
