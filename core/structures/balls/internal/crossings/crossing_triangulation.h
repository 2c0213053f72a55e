// SPDX-License-Identifier: GPL-3.0-or-later
// The Delaunay triangulation of crossings of circles.
#pragma once

#include "core/base/jobs/job_control.h"
#include "core/structures/balls/internal/crossings/crossing_kernel.h"
#include "core/structures/triangulation/point_triangulation.h"

namespace mes {

/// Divide and conquer, on all cores. Also finds crossings that are equal without being known to be. The result depends
/// on the crossings alone, except for the choice among equal ones.
template <>
PointTriangulation point_triangulation<CrossingKernel>(const Table<InputSlot, CrossingPoint>& points,
                                                       JobControl& job);

}  // namespace mes
