// SPDX-License-Identifier: GPL-3.0-or-later
// The union of the inner balls when `AxisCertificate` holds: everything follows from which balls touch which sample.
// No arithmetic at all.
#pragma once

#include <vector>

#include "core/base/change_set.h"
#include "core/structures/axis/medial_axis.h"
#include "core/structures/balls/internal/sector.h"
#include "core/structures/balls/internal/union_tables.h"
#include "core/structures/certificate/axis_certificate.h"

namespace mes {

struct UnionChanges {
  ChangeSet balls;
  ChangeSet dual_edges;  ///< rows of `axis` too
  ChangeSet dual_faces;
  ChangeSet v_points;  ///< rows of `v_origins` too
  ChangeSet arcs;

  void clear() {
    for (ChangeSet* set : {&balls, &dual_edges, &dual_faces, &v_points, &arcs}) set->clear();
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
  /// From the samples alone, whose differences are exact however far away they lie. O(faces).
  UnionMeasures measures() const;

 private:
  void grow(UnionTables& t) const;
  void count_balls(Slot site);
  void remake_ball(UnionTables& t, Slot face) const;
  void remake_chain(UnionTables& t, Slot edge);
  void remake_site(UnionTables& t, Slot site);
  void remake_arc(UnionTables& t, Slot edge) const;
  Slot new_edge(UnionTables& t, Slot a, Slot b, DualClass kind);
  void free_edge(UnionTables& t, Slot row);
  void note_edge(const UnionTables& t, Slot row) {
    if (is_recording_) edge_recorder_.note(row, row < t.dual_edges.size() && t.dual_edges[row].is_alive());
  }
  void note_face(const UnionTables& t, Slot row) {
    if (is_recording_) face_recorder_.note(row, row < t.dual_faces.size() && t.dual_faces[row].is_alive());
  }

  const Delaunay& delaunay_;
  const OneStepCrust& crust_;
  const Labels& labels_;
  const InnerBalls& balls_;
  const MedialAxis& axis_;
  const AxisCertificate& certificate_;

  std::vector<std::uint32_t> balls_at_;  // distinct inner balls, by site
  std::vector<Slot> chain_row_;          // dual edge of two balls with a common Voronoi edge, by Delaunay edge
  std::vector<Slot> first_edge_;         // of the other dual edges of a site: first row, then `next_edge_`
  std::vector<Slot> next_edge_;
  std::vector<Slot> first_face_;
  std::vector<Slot> next_face_;
  std::vector<Slot> free_edges_;
  std::vector<Slot> free_faces_;

  bool is_recording_ = false;
  ChangeRecorder ball_recorder_, edge_recorder_, face_recorder_, v_recorder_, arc_recorder_;
  SlotMarks site_marks_, edge_marks_;
  std::vector<Slot> sites_, edges_;
  std::vector<SectorBall> sector_;
};

}  // namespace mes
