// SPDX-License-Identifier: GPL-3.0-or-later
// Maps polygons from Clipper back to the curves whose sides they consist of. Private to core/curves.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "core/curves/curve.h"
#include "core/curves/internal/flat_curves.h"

namespace mes {

/// Part of a piece that a polygon follows; backwards if `begin` is above `end`.
struct TracedRun {
  const FlatCurves* of = nullptr;  ///< null: a straight side that lies on no curve
  std::uint32_t piece = 0;
  double begin = 0.0;
  double end = 0.0;
  double step = 0.0;  ///< parameter length of the longer of the sides at its ends
  Vec2 to{};          ///< end point
  bool is_whole() const { return of != nullptr && ((begin == 0.0 && end == 1.0) || (begin == 1.0 && end == 0.0)); }
  bool is_backwards() const { return begin > end; }
};

struct TracedPath {
  Vec2 start{};
  std::vector<TracedRun> runs{};
};

/// Maps paths back to curves of the subject and of the region; to those of the subject where both coincide.
class SideTracer {
 public:
  SideTracer(const FlatCurves& subject, const FlatCurves* region) : subject_(subject), region_(region) {}

  /// Traces a polygon. The result begins where the polygon leaves a curve, or a piece of one.
  TracedPath closed(const GridPath& path) const;
  /// Traces a line. Its ends are crossings with the region within `reach` grid steps, or ends of its curve.
  TracedPath open(const GridPath& path, double reach) const;

 private:
  struct Corner {
    ClipperPoint place;
    std::vector<SideAt> subject;
    std::vector<SideAt> region;
  };
  Corner corner_at(ClipperPoint place) const;
  TracedRun run_between(const Corner& from, const Corner& to, const TracedRun* before) const;
  std::vector<TracedRun> runs_along(const std::vector<Corner>& corners, bool is_closed) const;
  void meet(TracedRun& one, TracedRun& next) const;
  Vec2 end_at_region(TracedRun& run, bool at_its_end, ClipperPoint place, double reach) const;

  const FlatCurves& subject_;
  const FlatCurves* region_;
};

/// The index of the curve of the subject that a path follows completely; nothing for other paths.
std::optional<std::uint32_t> whole_curve(const TracedPath& path, const FlatCurves& subject);

/// The curve that consists of the runs; closed if the path ends at its start and `closes` is set.
PlaneCurve curve_of(const TracedPath& path, bool closes);

}  // namespace mes
