// SPDX-License-Identifier: GPL-3.0-or-later
// The vertices of the Voronoi diagram: finite Delaunay faces, with those of one circumcircle identified.
#pragma once

#include <array>
#include <vector>

#include "core/base/change_set.h"
#include "core/base/table.h"
#include "core/graph/structure.h"
#include "core/structures/crust/one_step_crust.h"

namespace mes {

/// Guarantees:
///  1. Two finite faces have the same `vertex` exactly when their circumcircles are equal as real circles (cocircular
///     sites); the decision is exact.
///  2. `vertex(face)` is one face of the group: the first by centre and radius in doubles, then by corners.
///
/// Rows are those of the Delaunay faces. Cost: O(faces); updates O(changed faces + sizes of changed groups), the first
/// update with a group O(faces).
class VoronoiVertices final : public Structure {
 public:
  VoronoiVertices(Delaunay& delaunay, OneStepCrust& crust);

  /// The face that stands for all faces with this circumcircle.
  FaceSlot vertex(FaceSlot face) const {
    const GroupSlot group = group_of(face);
    return group == kNoSlot ? face : groups_[group].front();
  }
  bool is_vertex(FaceSlot face) const { return delaunay_.is_finite_face(face) && vertex(face) == face; }
  /// Faces with the same circumcircle, if there are several; otherwise null.
  const std::vector<FaceSlot>* group(FaceSlot face) const {
    const GroupSlot group = group_of(face);
    return group == kNoSlot ? nullptr : &groups_[group];
  }
  /// True if the last changes are just those of the triangulation: no group appeared, changed or vanished.
  bool follows_faces() const { return follows_faces_; }
  /// The sites on the circle, each once, appended to `out`.
  void append_sites(FaceSlot face, std::vector<SiteSlot>& out) const;

  /// Faces that were added, changed or removed, and those whose group changed.
  const ChangeSet<FaceSlot>& changes() const { return changes_; }

  void rebuild(JobControl& job) override;
  bool update(JobControl& job) override;
  void clear_changes() override { changes_.clear(); }
  std::size_t touched() const override { return changes_.size(); }
  StatList statistics() const override;
  std::vector<TableColumns> table_columns() const override;
  void explain(ElementKind kind, RowNumber row, Explanation& out) const override;

 private:
  using GroupSlot = Slot<struct GroupTag>;
  GroupSlot group_of(FaceSlot face) const { return group_of_.has(face) ? group_of_[face] : GroupSlot(); }
  std::size_t group_count() const { return groups_.size() - free_groups_.size(); }
  bool has_cocircular_edge(FaceSlot face) const;
  std::array<Vec2, 3> sorted_corners(FaceSlot face) const;
  void gather_group(FaceSlot face);

  Delaunay& delaunay_;
  OneStepCrust& crust_;
  // Groups of two or more faces. Until there is one, all tables are empty; faces of later rows are in none.
  Table<FaceSlot, GroupSlot> group_of_;
  Table<GroupSlot, std::vector<FaceSlot>> groups_;
  std::vector<GroupSlot> free_groups_;
  bool follows_faces_ = true;
  ChangeRecorder<FaceSlot> recorder_;
  ChangeSet<FaceSlot> changes_;
  std::vector<FaceSlot> work_;
};

}  // namespace mes
