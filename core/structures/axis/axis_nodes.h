// SPDX-License-Identifier: GPL-3.0-or-later
// Tracks which nodes of the medial axis changed.
#pragma once

#include "core/base/change_set.h"
#include "core/graph/structure.h"
#include "core/structures/axis/medial_axis.h"

namespace mes {

/// The degree of a node depends on the labels of the faces around it, so the change set holds the neighbours of changed
/// nodes as well. Separate from `MedialAxis` because only layers of nodes need it. Rows are Delaunay face rows.
class AxisNodes final : public Structure {
 public:
  AxisNodes(Delaunay& delaunay, InnerBalls& balls, MedialAxis& axis);

  /// Faces that may have become a node, ceased to be one, or changed degree.
  const ChangeSet<FaceSlot>& changes() const { return changes_; }

  void rebuild(JobControl& job) override;
  bool update(JobControl& job) override;
  void clear_changes() override { changes_.clear(); }
  std::size_t touched() const override { return changes_.size(); }
  StatList statistics() const override;
  std::vector<TableColumns> table_columns() const override;

 private:
  Delaunay& delaunay_;
  InnerBalls& balls_;
  MedialAxis& axis_;
  ChangeRecorder<FaceSlot> recorder_;
  ChangeSet<FaceSlot> changes_;
};

}  // namespace mes
