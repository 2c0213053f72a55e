// SPDX-License-Identifier: GPL-3.0-or-later
// The union of the inner balls when `AxisCertificate` holds: everything follows from which balls touch which sample,
// without any arithmetic.
#pragma once

#include <vector>

#include "core/base/change_set.h"
#include "core/structures/axis/medial_axis.h"
#include "core/structures/balls/internal/shortcut/sector.h"
#include "core/structures/balls/internal/union_tables.h"
#include "core/structures/certificate/axis_certificate.h"

namespace mes {

struct UnionChanges {
  ChangeSet<FamilySlot> balls;
  ChangeSet<DualEdgeSlot> dual_edges;  ///< also the rows of `axis`
  ChangeSet<DualFaceSlot> dual_faces;
  ChangeSet<VPointSlot> v_points;  ///< also the rows of `v_origins`
  ChangeSet<ArcSlot> arcs;

  void clear() {
    balls.clear();
    dual_edges.clear();
    dual_faces.clear();
    v_points.clear();
    arcs.clear();
  }
  std::size_t size() const {
    return balls.size() + dual_edges.size() + dual_faces.size() + v_points.size() + arcs.size();
  }
};

/// Rows: balls by Delaunay face (the one that stands for equal ones), v-points and origins by site, arcs by Delaunay
/// edge; dual edges and faces have rows of their own, and piece i of the axis is dual edge i.
/// `update` keeps the tables equal to what `rebuild` makes, up to the numbering of the latter; O(changes).
class SampleUnion {
 public:
  SampleUnion(const Delaunay& delaunay, const OneStepCrust& crust, const Labels& labels, const InnerBalls& balls,
              const MedialAxis& axis, const AxisCertificate& certificate)
      : delaunay_(delaunay), crust_(crust), labels_(labels), balls_(balls), axis_(axis), certificate_(certificate) {}

  void rebuild(UnionTables& tables, JobControl& job);
  void update(UnionTables& tables, UnionChanges& changes);
  /// Computed from the samples alone, whose differences are exact however far away they lie. O(faces).
  UnionMeasures measures() const;

 private:
  void grow(UnionTables& t) const;
  void count_balls(SiteSlot site);
  void remake_ball(UnionTables& t, FaceSlot face) const;
  void remake_chain(UnionTables& t, EdgeSlot edge);
  void remake_site(UnionTables& t, SiteSlot site);
  void remake_arc(UnionTables& t, EdgeSlot edge) const;
  DualEdgeSlot new_edge(UnionTables& t, FaceSlot a, FaceSlot b, DualClass kind);
  void free_edge(UnionTables& t, DualEdgeSlot row);
  void note_edge(const UnionTables& t, DualEdgeSlot row) {
    if (is_recording_) edge_recorder_.note(row, t.dual_edges.has(row) && t.dual_edges[row].is_alive());
  }
  void note_face(const UnionTables& t, DualFaceSlot row) {
    if (is_recording_) face_recorder_.note(row, t.dual_faces.has(row) && t.dual_faces[row].is_alive());
  }

  const Delaunay& delaunay_;
  const OneStepCrust& crust_;
  const Labels& labels_;
  const InnerBalls& balls_;
  const MedialAxis& axis_;
  const AxisCertificate& certificate_;

  Table<SiteSlot, std::uint32_t> balls_at_;   // number of distinct inner balls
  Table<EdgeSlot, DualEdgeSlot> chain_row_;   // dual edge of two balls with a common Voronoi edge
  Table<SiteSlot, DualEdgeSlot> first_edge_;  // first of the other dual edges of a site; `next_edge_` has the rest
  Table<DualEdgeSlot, DualEdgeSlot> next_edge_;
  Table<SiteSlot, DualFaceSlot> first_face_;
  Table<DualFaceSlot, DualFaceSlot> next_face_;
  std::vector<DualEdgeSlot> free_edges_;
  std::vector<DualFaceSlot> free_faces_;

  bool is_recording_ = false;
  ChangeRecorder<FamilySlot> ball_recorder_;
  ChangeRecorder<DualEdgeSlot> edge_recorder_;
  ChangeRecorder<DualFaceSlot> face_recorder_;
  ChangeRecorder<VPointSlot> v_recorder_;
  ChangeRecorder<ArcSlot> arc_recorder_;
  SlotMarks<SiteSlot> site_marks_;
  SlotMarks<EdgeSlot> edge_marks_;
  std::vector<SiteSlot> sites_;
  std::vector<EdgeSlot> edges_;
  std::vector<SectorBall> sector_;
};

}  // namespace mes
