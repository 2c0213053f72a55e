// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/structures/balls/internal/union_runs.h"

namespace mes {

/// True if two circles cross and the radii at a crossing enclose less than 45 degrees. Exact for balls as their origin
/// defines them: T = w_1 + w_2 - d^2 > 0 and T^2 > 2 w_1 w_2. Source: Amenta, Choi and Kolluri 2001.
bool overlap_deeply(const PipelineBall& a, const PipelineBall& b);

/// Cosine of that angle, in doubles; beyond [-1, 1] where the circles do not cross.
double cosine_at_crossing(const Disk& a, const Disk& b);

}  // namespace mes
