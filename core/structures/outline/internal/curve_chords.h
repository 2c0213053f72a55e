// SPDX-License-Identifier: GPL-3.0-or-later
// The chords of all outlines of a document, which know of each other. Private to core/structures/outline.
//
// Guarantees:
//  1. Arcs of one circle that have a part in common, in any directions, have the same chords along it.
//  2. Chords cross, or are equal, only where their curves do, to 2^-44 of the largest coordinate. Where this would take
//     more than eight times as many chords as the tolerance asks for, it stops.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "core/base/jobs/job_control.h"
#include "core/structures/outline/internal/chords.h"
#include "core/structures/outline/outline_sides.h"

namespace mes {

/// The chords of the pieces of all outlines, in the order of `for_each_outline`.
class CurveChords {
 public:
  CurveChords(std::span<const PlaneCurve> curves, double tolerance, JobControl& job);

  /// Returns the chords of the next piece.
  std::span<const OutlineChord> next();

 private:
  struct Arc;
  std::vector<OutlineSide> sides() const;
  void split_at_ends(std::vector<Arc>& arcs, JobControl& job) const;
  /// Describes parts of arcs in one way that are the same to rounding.
  static void unite_shared_parts(std::vector<Arc>& arcs, double least);
  void replace_chords_of(std::span<const Arc> arcs, double tolerance);
  /// Halves chords that cross or are equal where their curves need not, and those near the ends of others. Returns whether
  /// it found some.
  bool refine(JobControl& job);

  std::vector<OutlineChord> chords_;
  std::vector<Vec2> starts_;       // of each piece
  std::vector<std::size_t> ends_;  // number of chords before the end of each piece
  std::size_t next_ = 0;
};

}  // namespace mes
