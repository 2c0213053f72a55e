// SPDX-License-Identifier: GPL-3.0-or-later
// Inner Voronoi balls: the circumdisks of inside triangles, with equal ones identified.
#pragma once

#include <vector>

#include "core/base/change_set.h"
#include "core/graph/structure.h"
#include "core/structures/crust/labels.h"
#include "core/structures/crust/voronoi_vertices.h"

namespace mes {

/// Guarantees:
///  1. A face is a ball exactly when it is finite and inside.
///  2. Two faces have the same `ball` exactly when their circumcircles are equal as real circles. Such faces always
///     have the same label.
///
/// Rows are those of the Delaunay faces; `ball(face)` is one face of the group. Cost: O(faces); updates O(changed
/// faces).
class InnerBalls final : public Structure {
 public:
  InnerBalls(Delaunay& delaunay, VoronoiVertices& vertices, Labels& labels);

  bool is_ball(FaceSlot face) const { return labels_.is_inside(face) && delaunay_.is_finite_face(face); }
  /// The face that stands for all faces with this circumcircle.
  FaceSlot ball(FaceSlot face) const { return vertices_.vertex(face); }
  /// Faces with the same circumcircle, for a face for which there are several; otherwise null.
  const std::vector<FaceSlot>* group(FaceSlot face) const { return vertices_.group(face); }

  const VoronoiVertices& vertices() const { return vertices_; }

  /// Faces that became, remained or ceased to be balls, or whose group changed.
  const ChangeSet<FaceSlot>& changes() const { return changes_; }

  void rebuild(JobControl& job) override;
  bool update(JobControl& job) override;
  void clear_changes() override { changes_.clear(); }
  std::size_t touched() const override { return changes_.size(); }
  StatList statistics() const override;
  std::vector<TableColumns> table_columns() const override;
  void explain(ElementKind kind, RowNumber row, Explanation& out) const override;

 private:
  Delaunay& delaunay_;
  VoronoiVertices& vertices_;
  Labels& labels_;
  ChangeRecorder<FaceSlot> recorder_;
  ChangeSet<FaceSlot> changes_;
};

}  // namespace mes
