// SPDX-License-Identifier: GPL-3.0-or-later
// The union pipeline in each number type, behind functions that need no CGAL header.
#pragma once

#include <span>

#include "core/base/disk.h"
#include "core/base/job_control.h"
#include "core/structures/balls/ball_family.h"
#include "core/structures/balls/internal/local_frame.h"
#include "core/structures/balls/internal/union_tables.h"
#include "core/structures/triangulation/input_slots.h"

namespace mes {

/// A ball as the pipeline takes it, in the coordinates of a `LocalFrame`.
struct PipelineBall {
  // First what all stages look at.
  FamilySlot row;  ///< of its family
  BallOrigin origin = BallOrigin::disk;
  Disk disk{};                               ///< before scaling; may be rounded
  std::span<const TouchedSample> samples{};  ///< all on the circle
  double scale = 1.0;                        ///< what the radius is multiplied by, exactly
  Disk drawn{};                              ///< scaled, rounded, in the coordinates of the document
  /// Of a circumdisk, counter-clockwise from the first in lexicographic order, so that nothing depends on how the triangle
  /// came about; `corner[0]` is the one sample of `through_sample`.
  Vec2 corner[3] = {};

  /// Of the scaled ball, rounded.
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

/// What the pipeline starts from. Radii are positive. What it gives is in the coordinates of the document.
struct PipelineInput {
  TableView<InputSlot, PipelineBall> balls;
  std::size_t rows = 0;  ///< of the family's table
  LocalFrame frame{};
};

/// What the arc of a circle before a v-point is, counter-clockwise.
enum class CircleArc : std::uint8_t {
  covered,   ///< by dual triangles at the ball
  singular,  ///< by the ball of a singular dual edge
  free,      ///< on the boundary of the union
};
struct CirclePlace {
  VPointSlot v;
  CircleArc before = CircleArc::free;
};

/// Which samples are v-points, and how they lie on the circles, when that is known beforehand.
struct KnownVPoints {
  Table<VPointSlot, Vec2> points;  ///< in the coordinates of the document
  Table<VPointSlot, SiteSlot> sites;
  Table<InputSlot, std::vector<CirclePlace>> places;
};

/// Only `v_points`, `v_faces` and `v_edges` are filled in.
UnionTables run_v_diagram(const PipelineInput& input, const KnownVPoints& known, JobControl& job);

using PowerEdgeSlot = Slot<struct PowerEdgeTag>;

/// Edge of the regular triangulation and its dual, an edge of the power diagram.
struct PowerEdge {
  enum class Kind : std::uint8_t { segment, ray, line };
  FamilySlot ball[2]{};
  Kind kind = Kind::segment;
  Vec2 from{};             ///< a power centre, or any point of the line
  Vec2 to{};               ///< the other power centre; for rays and lines the direction
  TriangleSlot face[2]{};  ///< the triangles whose power centres the ends are; kNoSlot = no end
  double length = 0.0;     ///< of a segment; not taken from its rounded ends
};
Table<PowerEdgeSlot, PowerEdge> run_power_diagram_naive(const PipelineInput& input, JobControl& job);
Table<PowerEdgeSlot, PowerEdge> run_power_diagram_doubles(const PipelineInput& input, JobControl& job);
Table<PowerEdgeSlot, PowerEdge> run_power_diagram_exact(const PipelineInput& input, JobControl& job);

UnionTables run_union_naive(const PipelineInput& input, JobControl& job);
UnionTables run_union_doubles(const PipelineInput& input, JobControl& job);
UnionTables run_union_exact(const PipelineInput& input, JobControl& job);
UnionTables run_union_roots(const PipelineInput& input, JobControl& job);
/// In rationals; only `dual_edges` and `dual_faces` are filled in. Needs no roots.
UnionTables run_dual_complex_exact(const PipelineInput& input, JobControl& job);

}  // namespace mes
