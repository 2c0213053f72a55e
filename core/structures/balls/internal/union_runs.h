// SPDX-License-Identifier: GPL-3.0-or-later
// The union pipeline in each number type, behind functions that need no CGAL header.
#pragma once

#include <span>

#include "core/base/geometry/disk.h"
#include "core/base/jobs/job_control.h"
#include "core/structures/balls/ball_family.h"
#include "core/structures/balls/internal/local_frame.h"
#include "core/structures/balls/internal/union_tables.h"
#include "core/structures/triangulation/input_slots.h"

namespace mes {

/// A ball as input of the pipeline, in the coordinates of a `LocalFrame`.
struct PipelineBall {
  // Fields that all stages read come first.
  FamilySlot row;  ///< row in its family
  BallOrigin origin = BallOrigin::disk;
  Disk disk{};                               ///< before scaling; may be rounded
  std::span<const TouchedSample> samples{};  ///< all on the circle
  double scale = 1.0;                        ///< the radius is multiplied by this, exactly
  Disk drawn{};                              ///< scaled, rounded, in the coordinates of the document
  /// Corners of a circumdisk, counter-clockwise from the lexicographically first, so that nothing depends on the
  /// triangle's history; `corner[0]` is the one sample of `through_sample`.
  Vec2 corner[3] = {};

  /// Radius of the scaled ball, rounded.
  double radius() const { return disk.radius * scale; }
  const TouchedSample* find(SiteSlot site) const {
    for (const TouchedSample& sample : samples)
      if (sample.site == site) return &sample;
    return nullptr;
  }
};

/// A sample that both balls touch, if there is one.
inline const TouchedSample* common_sample(const PipelineBall& a, const PipelineBall& b) {
  for (const TouchedSample& sample : a.samples)
    if (b.find(sample.site) != nullptr) return &sample;
  return nullptr;
}
inline const TouchedSample* common_sample(const PipelineBall& a, const PipelineBall& b, const PipelineBall& c) {
  for (const TouchedSample& sample : a.samples)
    if (b.find(sample.site) != nullptr && c.find(sample.site) != nullptr) return &sample;
  return nullptr;
}

/// Input of the pipeline. Radii are positive. The results are in the coordinates of the document.
struct PipelineInput {
  TableView<InputSlot, PipelineBall> balls;
  std::size_t rows = 0;  ///< rows of the family's table
  LocalFrame frame{};
};

/// State of the arc of a circle before a v-point, counter-clockwise.
enum class CircleArc : std::uint8_t {
  covered,   ///< covered by dual triangles at the ball
  singular,  ///< covered by the ball of a singular dual edge
  free,      ///< on the boundary of the union
};
struct CirclePlace {
  VPointSlot v;
  CircleArc before = CircleArc::free;
};

/// The samples that are v-points, and their positions on the circles, if these are known beforehand.
struct KnownVPoints {
  Table<VPointSlot, Vec2> points;  ///< in the coordinates of the document
  Table<VPointSlot, SiteSlot> sites;
  Table<InputSlot, std::vector<CirclePlace>> places;
};

/// Fills in only `v_points`, `v_faces` and `v_edges`.
UnionTables run_v_diagram(const PipelineInput& input, const KnownVPoints& known, JobControl& job);

using PowerEdgeSlot = Slot<struct PowerEdgeTag>;

/// Edge of the regular triangulation and its dual, an edge of the power diagram.
struct PowerEdge {
  enum class Kind : std::uint8_t { segment, ray, line };
  FamilySlot ball[2]{};
  Kind kind = Kind::segment;
  Vec2 from{};             ///< a power centre, or any point of the line
  Vec2 to{};               ///< the other power centre; for rays and lines the direction
  TriangleSlot face[2]{};  ///< triangles whose power centres are the ends; kNoSlot if there is no end
  double length = 0.0;     ///< length of a segment; not computed from its rounded ends
};
Table<PowerEdgeSlot, PowerEdge> run_power_diagram_naive(const PipelineInput& input, JobControl& job);
Table<PowerEdgeSlot, PowerEdge> run_power_diagram_doubles(const PipelineInput& input, JobControl& job);
Table<PowerEdgeSlot, PowerEdge> run_power_diagram_exact(const PipelineInput& input, JobControl& job);

UnionTables run_union_naive(const PipelineInput& input, JobControl& job);
UnionTables run_union_doubles(const PipelineInput& input, JobControl& job);
UnionTables run_union_exact(const PipelineInput& input, JobControl& job);
UnionTables run_union_roots(const PipelineInput& input, JobControl& job);
/// Computes in rationals; fills in only `dual_edges` and `dual_faces`. Needs no roots.
UnionTables run_dual_complex_exact(const PipelineInput& input, JobControl& job);

}  // namespace mes
