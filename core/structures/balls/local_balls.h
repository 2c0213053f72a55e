// SPDX-License-Identifier: GPL-3.0-or-later
// The balls of a family as the pipelines take them.
#pragma once

#include <cstdint>
#include <vector>

#include "core/structures/balls/ball_family.h"
#include "core/structures/balls/internal/union_runs.h"

namespace mes {

/// What it guarantees:
///  1. Neighbours in the plane come one after the other; the order does not depend on how rows are numbered.
///  2. What a ball is made of, by its `origin`, is exact in the frame. So of all that follows nothing depends on
///     where the balls lie or on the unit of length, but the rounding of what is computed, `disk` of a circumdisk
///     for one: that is done in the frame.
struct LocalBalls {
  Table<InputSlot, PipelineBall> balls;
  std::vector<TouchedSample> samples;  ///< what `PipelineBall::samples` points to
  std::size_t rows = 0;
  std::size_t ignored = 0;  ///< beyond doubles, or, as long as they are not asked for, of radius zero
  LocalFrame frame;

  PipelineInput input() const { return {balls, rows, frame}; }
};
enum class PointBalls : std::uint8_t { ignored, kept };
/// `points` are the balls of radius zero.
LocalBalls local_balls(const BallFamily& family, JobControl& job, PointBalls points = PointBalls::ignored);

}  // namespace mes
