// SPDX-License-Identifier: GPL-3.0-or-later
// The one-step medial axis: inner Voronoi vertices and the Voronoi edges between them, as a graph.
#pragma once

#include "core/base/change_set.h"
#include "core/graph/structure.h"
#include "core/structures/axis/inner_balls.h"

namespace mes {

/// Guarantees:
///  1. An edge of the axis is a Voronoi edge whose two Voronoi vertices are inside, unless its samples share a border:
///     each region has an axis of its own. Edges of length exactly zero join faces of one node and are not edges of the
///     graph.
///  2. A node is a distinct inner ball. Its degree counts the axis edges of positive length at it: 1 is a leaf, 3 and
///     more a branch point, 0 an isolated point such as the axis of a disk.
///
/// Rows: edges are Delaunay edge rows, nodes the face rows of `InnerBalls::ball`. Cost: O(n) rebuild, local updates;
/// components, cycles and length are counted when statistics are asked for, O(n).
/// Source: the demo paper; for dense samples of smooth curves this is the medial axis of the union of the inner
/// balls.
class MedialAxis final : public Structure {
 public:
  MedialAxis(Delaunay& delaunay, OneStepCrust& crust, Labels& labels, InnerBalls& balls);

  /// True if the dual of the Delaunay edge joins two inside faces of one region (its length may be zero).
  bool is_axis_edge(EdgeSlot edge) const {
    const EdgeRow& row = delaunay_.edge(edge);
    return row.f[0] != kNoSlot &&
           (labels_.is_inside(row.f[0]) & labels_.is_inside(row.f[1]) & !crust_.is_shared(edge));
  }
  bool is_zero_length(EdgeSlot edge) const { return crust_.is_cocircular(edge); }
  /// True if the face stands for a node of the axis.
  bool is_node(FaceSlot face) const { return balls_.is_ball(face) && balls_.ball(face) == face; }
  /// Number of axis edges of positive length at a node. O(faces of the node): one unless samples are cocircular.
  int node_degree(FaceSlot face) const;

  const ChangeSet<EdgeSlot>& edge_changes() const { return labels_.edge_changes(); }

  // The axis has no rows of its own: it is a view of labels and balls, so there is nothing to update.
  void rebuild(JobControl&) override {}
  bool update(JobControl&) override { return true; }
  void clear_changes() override {}
  std::size_t touched() const override { return edge_changes().size(); }
  StatList statistics() const override;
  std::vector<TableColumns> table_columns() const override;
  void explain(ElementKind kind, RowNumber row, Explanation& out) const override;

 private:
  int axis_edges_at(FaceSlot face) const;

  Delaunay& delaunay_;
  OneStepCrust& crust_;
  Labels& labels_;
  InnerBalls& balls_;
};

}  // namespace mes
