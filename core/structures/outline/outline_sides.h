// SPDX-License-Identifier: GPL-3.0-or-later
// The outline of a document as straight sides, some of which stand for arcs.
//
// Guarantees:
//  1. Sides are different, and two of them have at most one point in common: an end of both.
//  2. The sides depend on the outline as a set: not on the order of contours, where they begin, or their directions,
//     unless two are the same: in one direction they count once, in opposite ones they are the border of both.
//  3. Straight sides are exact. A vertex that lies exactly on a side splits it, as where parcels meet in a T. Sides that
//     cross are split at the crossing, rounded to doubles, or at an end or another crossing that lies within 2^-44 of the
//     largest coordinate. This alone moves sides.
//
// Cost: O(n log n) for n sides where few boxes of sides overlap. Threads: any.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "core/base/geometry/vec2.h"
#include "core/base/jobs/job_control.h"
#include "core/curves/curve.h"

namespace mes {

struct OutlineChord;

/// Position along a smooth stretch of curves: a side has an even number, and the vertex after it the next odd number.
struct SmoothPlace {
  static constexpr std::uint32_t kNone = 0xffffffffU;
  std::uint32_t stretch = kNone;  ///< number of the stretch, kNone on a straight side or at a corner
  std::uint32_t number = 0;
  std::uint32_t count = 0;  ///< numbers of a closed stretch, after which they begin again at 0; 0: it is open

  /// True if the two lie on one stretch with fewer than two chords between them. What is equally far from both is the
  /// trace of a vertex between chords, not of the curve.
  bool is_next_to(const SmoothPlace& other) const;
  friend bool operator==(const SmoothPlace&, const SmoothPlace&) = default;
};

struct OutlineSide {
  Vec2 from{};  ///< the lexicographically smaller end
  Vec2 to{};
  bool separates = false;  ///< an odd number of closed contours runs along it
  SmoothPlace smooth{};
  std::optional<Vec2> center{};  ///< the side stands for an arc of the circle through its ends about this
  bool is_arc = false;           ///< the curve itself is that arc
  friend bool operator==(const OutlineSide&, const OutlineSide&) = default;
};

/// Collects contours, one after the other.
class OutlineSides {
 public:
  void add(Vec2 from, Vec2 to, bool is_of_closed_contour);
  /// Curved pieces become chords that leave them by at most `tolerance` and turn by at most 1/16, with the circle that
  /// they are on, or else the one through the ends of the chord and the middle of the curve between them. A closed curve
  /// that goes around several times in the same way counts once, and so do closed curves that are the same in the same
  /// direction. Chords that cross, or are equal, although their curves need not, are halved until it is clear. Throws
  /// `Cancelled`.
  void add(std::span<const PlaneCurve> curves, double tolerance, JobControl& job);
  /// Splits sides where others end on them or cross them, merges equal ones, and sorts them by their ends. Throws
  /// `Cancelled`, `GeometryError` if rounded crossings cause new crossings again and again, and `SizeRefusal` for more than
  /// 200,000 crossings.
  std::vector<OutlineSide> take(JobControl& job);
  /// Number of crossings that `take` found.
  std::size_t crossings() const { return crossings_; }

 private:
  void add(OutlineSide side);
  void add(std::span<const Piece> pieces, std::span<const std::span<const OutlineChord>> chords, bool is_closed,
           double tolerance);

  using Cut = std::pair<std::uint32_t, Vec2>;  // a side, and a point that splits it
  enum class Cuts : std::uint8_t { on_sides, beside_sides };
  std::vector<Cut> ends_on_sides(JobControl& job) const;
  /// Nothing if no two sides cross. Adds how often curves cross.
  std::optional<std::vector<Cut>> crossings_of_sides(JobControl& job, std::size_t& crossings) const;
  void add_cuts_of_crossing(std::uint32_t i, std::uint32_t j, double tolerance, std::vector<Cut>& cuts) const;
  void split(std::vector<Cut> cuts, Cuts where);
  void merge();

  std::vector<OutlineSide> sides_;
  std::uint32_t stretches_ = 0;
  std::size_t crossings_ = 0;
};

/// How outlines run over themselves and each other, where they should bound something.
struct OutlineFaults {
  std::size_t crossings = 0;  ///< pairs of sides that cross, not at an end; counted no further than 200,001
  std::size_t overlaps = 0;   ///< pairs of collinear sides of two outlines that both lie on one side of a common part
  std::size_t repeated = 0;   ///< times that an outline runs along a side of its own again, or along a part of it
  std::size_t same = 0;       ///< outlines that repeat another one, all of it, and count once
};

/// Counts the faults of closed curves, exactly for straight sides, and of the chords within `outline_tolerance` for
/// curved ones. Throws `Cancelled`. Cost: as `OutlineSides`.
OutlineFaults faults_of_outlines(std::span<const PlaneCurve> curves, JobControl& job);

/// How far chords may leave curves of this extent: 2^-14 of its larger side.
double outline_tolerance(std::span<const PlaneCurve> curves);

}  // namespace mes
