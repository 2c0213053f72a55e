// SPDX-License-Identifier: GPL-3.0-or-later
// Centre lines of the exact axis of an outline, which needs no samples.
#pragma once

#include "core/structures/filters/paths/center_lines.h"
#include "core/structures/outline/outline_axis.h"

namespace mes {

/// Guarantees: banks are the sides and vertices of the outline that are nearest, so feet and widths are exact up to
/// rounding. Arcs of parabolas are chains of chords (`OutlineAxis::pieces`). The lines depend on the outline as a set.
///
/// Cost: O(n log n) for n pieces, and that of a network. Throws `Cancelled`.
CenterLines center_lines_of(const OutlineAxis& axis, const CenterLineRequest& request, JobControl& job);

/// Extends the free ends of the lines to the outline (`extend`). Ends at corners are there already.
void extend_to_outline(CenterLines& set, const OutlineAxis& axis, double most = 4.0);

}  // namespace mes
