// SPDX-License-Identifier: GPL-3.0-or-later
// The balls of a family as input of the pipelines.
#pragma once

#include <cstdint>
#include <vector>

#include "core/structures/balls/ball_family.h"
#include "core/structures/balls/internal/union_runs.h"

namespace mes {

/// Guarantees:
///  1. Neighbours in the plane are consecutive; the order does not depend on how rows are numbered.
///  2. The data that define a ball, by its `origin`, are exact in the frame. So no result depends on where the balls
///     lie or on the unit of length, except the rounding of computed values, such as `disk` of a circumdisk: that is
///     done in the frame.
struct LocalBalls {
  Table<InputSlot, PipelineBall> balls;
  std::vector<TouchedSample> samples;  ///< storage that `PipelineBall::samples` points to
  std::size_t rows = 0;
  std::size_t ignored = 0;  ///< balls beyond the range of doubles and, unless they are kept, of radius zero
  LocalFrame frame;

  PipelineInput input() const { return {balls, rows, frame}; }
};
enum class PointBalls : std::uint8_t { ignored, kept };
/// `points` are the balls of radius zero.
LocalBalls local_balls(const BallFamily& family, JobControl& job, PointBalls points = PointBalls::ignored);

}  // namespace mes
