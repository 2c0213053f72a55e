// SPDX-License-Identifier: GPL-3.0-or-later
// The line through both crossings of two circles. It stays fixed while the squared radii of both grow by one number.
// These functions need no CGAL header.
#pragma once

#include <array>
#include <span>
#include <vector>

#include "core/base/geometry/vec2.h"
#include "core/base/jobs/job_control.h"
#include "core/structures/balls/internal/union_runs.h"

namespace mes {

/// Numbers are those of the frame. Guarantees:
///  1. Even for centres that coincide up to rounding, direction and feet are those of the balls as they are: a crossing
///     computed from them is off by at most `tolerance`, 2^-36 of the smaller radius or of the distance to the foot.
///  2. Exchanging the two balls changes signs and no digit.
struct RadicalAxis {
  Vec2 direction{};              ///< from the first centre to the second, of length 1
  std::array<double, 2> foot{};  ///< distance of the axis from each centre, towards the other one
  double power = 0.0;            ///< of both balls where the axis crosses the line of the centres
  double power_error = 0.0;      ///< bound of the error of `power`
  double tolerance = 0.0;
};

using BallPair = std::array<InputSlot, 2>;

/// Radical axes of balls about different centres, exact for the balls as their `origin` defines them. Computed in
/// intervals, or in rationals where these are too wide: 0.2 us or 30 us each.
std::vector<RadicalAxis> radical_axes(const PipelineInput& input, std::span<const BallPair> pairs, JobControl& job);

/// Half the distance of the crossings once squared radii have grown by the square of `growth`, a length of the
/// document; 0 if the circles do not meet. Takes some ns, or some us where the circles all but touch.
double half_chord(const PipelineInput& input, const BallPair& pair, const RadicalAxis& axis, double growth);

}  // namespace mes
