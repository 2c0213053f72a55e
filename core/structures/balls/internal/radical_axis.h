// SPDX-License-Identifier: GPL-3.0-or-later
// The line through both crossings of two circles. It stays where it is while the squared radii of both grow by one
// number. Behind functions that need no CGAL header.
#pragma once

#include <array>
#include <span>
#include <vector>

#include "core/base/job_control.h"
#include "core/base/vec2.h"
#include "core/structures/balls/internal/union_runs.h"

namespace mes {

/// Numbers are those of the frame. What it guarantees:
///  1. Centres that coincide up to rounding have the direction and the feet of the balls as they are: a crossing that
///     follows from these is off by `tolerance` at most, 2^-36 of the smaller radius or of the way to the foot.
///  2. Exchanging the two balls changes signs and no digit.
struct RadicalAxis {
  Vec2 direction{};              ///< from the first centre to the second, of length 1
  std::array<double, 2> foot{};  ///< how far the axis is from each centre, towards the other one
  double power = 0.0;            ///< of both balls where the axis crosses the line of the centres
  double power_error = 0.0;      ///< how far `power` may be from that
  double tolerance = 0.0;
};

using BallPair = std::array<InputSlot, 2>;

/// Of balls about different centres, exact for these as they are by their `origin`. Intervals, and rationals where they say
/// too little: 0.2 us or 30 us each.
std::vector<RadicalAxis> radical_axes(const PipelineInput& input, std::span<const BallPair> pairs, JobControl& job);

/// Half the distance of the crossings once squared radii have grown by the square of `growth`, a length of the document;
/// 0 where the circles do not meet. Some ns, and some us where the circles all but touch.
double half_chord(const PipelineInput& input, const BallPair& pair, const RadicalAxis& axis, double growth);

}  // namespace mes
