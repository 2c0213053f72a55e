// SPDX-License-Identifier: GPL-3.0-or-later
// Replaces overlapping contours by the boundary of their union. Private to core/glyphs.
#pragma once

#include <vector>

#include "core/base/jobs/job_control.h"
#include "core/curves/curve.h"

namespace mes {

/// Unites closed curves in design units of a font, which are filled by the nonzero winding rule. A contour on the
/// boundary that meets neither another one nor itself stays unchanged, to the last bit. Where contours cross, touch, or
/// lie within a filled area, straight pieces of the boundary replace them; these are within `tolerance` of the curves,
/// and follow the unchanged contours in the list.
///
/// Clipper decides, exactly for the corners of these pieces rounded to a 1024th of a unit. Contours whose bounding
/// boxes meet are united in one call, others in separate calls, so that the outline of a letter does not depend on
/// letters that it does not touch. Throws `Cancelled` if there is a job, which is checked between these calls.
std::vector<PlaneCurve> united_contours(std::vector<PlaneCurve> contours, double tolerance,
                                        JobControl* job = nullptr);

}  // namespace mes
