// SPDX-License-Identifier: GPL-3.0-or-later
// From polygons that Clipper made back to the curves whose sides they consist of. Private to core/curves.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "core/curves/curve.h"
#include "core/curves/internal/flat_curves.h"

namespace mes {

/// Part of a piece that a polygon goes along; backwards where `begin` is above `end`.
struct TracedRun {
  const FlatCurves* of = nullptr;  ///< none: a straight side that lies on no curve
  std::uint32_t piece = 0;
  double begin = 0.0;
  double end = 0.0;
  double step = 0.0;  ///< of the parameter along the longer of the sides at its ends
  Vec2 to{};          ///< where it ends
  bool is_whole() const { return of != nullptr && ((begin == 0.0 && end == 1.0) || (begin == 1.0 && end == 0.0)); }
  bool is_backwards() const { return begin > end; }
};

struct TracedPath {
  Vec2 start{};
  std::vector<TracedRun> runs{};
};

/// Takes paths back to curves of the subject and of the region, of the subject where both run along.
class SideTracer {
 public:
  SideTracer(const FlatCurves& subject, const FlatCurves* region) : subject_(subject), region_(region) {}

  /// Of a polygon, which begins where a curve, or a piece of one, is left.
  TracedPath closed(const GridPath& path) const;
  /// Of a line, whose ends are crossings with the region, within `reach` steps, or ends of its curve.
  TracedPath open(const GridPath& path, double reach) const;

 private:
  struct Corner {
    GridPoint place;
    std::vector<SideAt> subject;
    std::vector<SideAt> region;
  };
  Corner corner_at(GridPoint place) const;
  TracedRun run_between(const Corner& from, const Corner& to, const TracedRun* before) const;
  std::vector<TracedRun> runs_along(const std::vector<Corner>& corners, bool is_closed) const;
  void meet(TracedRun& one, TracedRun& next) const;
  Vec2 end_at_region(TracedRun& run, bool at_its_end, GridPoint place, double reach) const;

  const FlatCurves& subject_;
  const FlatCurves* region_;
};

/// The curve that the runs are; closed where the path ends at its start and `closes`.
PlaneCurve curve_of(const TracedPath& path, bool closes);

}  // namespace mes
