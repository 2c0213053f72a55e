// SPDX-License-Identifier: GPL-3.0-or-later
// The union pipeline in each number type, behind functions that need no CGAL header.
#pragma once

#include <span>

#include "core/base/disk.h"
#include "core/base/job_control.h"
#include "core/structures/internal/union_tables.h"

namespace mes {

/// A ball as the pipeline takes it: the circumdisk of three samples, counter-clockwise, or a disk as it stands.
struct PipelineBall {
  Slot row = kNoSlot;  ///< of its family
  Disk disk{};         ///< rounded, if it is from samples
  bool is_from_samples = false;
  Vec2 corner[3] = {};
  Slot site[3] = {kNoSlot, kNoSlot, kNoSlot};
};

/// What the pipeline starts from. Radii are positive.
struct PipelineInput {
  std::span<const PipelineBall> balls;
  std::size_t rows = 0;  ///< of the family's table
};

/// A crossing is not rational.
struct NeedsRoots {};

UnionTables run_union_naive(const PipelineInput& input, JobControl& job);
UnionTables run_union_doubles(const PipelineInput& input, JobControl& job);
/// Throws `NeedsRoots`.
UnionTables run_union_rational(const PipelineInput& input, JobControl& job);
UnionTables run_union_mixed(const PipelineInput& input, JobControl& job);
UnionTables run_union_roots(const PipelineInput& input, JobControl& job);

}  // namespace mes
