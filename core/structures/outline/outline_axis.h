// SPDX-License-Identifier: GPL-3.0-or-later
// The exact medial axis of the outline, as if it had infinitely many samples.
//
// The outline consists of the curves that the samples were taken from, or else of the contours of the document with
// straight sides between neighbours. Its medial axis is the set of points with two or more nearest points on it. Here
// are the parts inside: in regions that an odd number of closed contours surrounds. A region is connected and has no
// side in it, so parcels with common borders have an axis each.
//
// Guarantees:
//  1. Edges lie where the axis of the straight sides has edges: this is decided exactly, also for sides that cross,
//     touch, or have common parts. Positions are rounded (internal/segment_voronoi.h).
//  2. An edge between a straight side and a vertex is an arc of a parabola. `control` is the exact control point of the
//     arc as a quadratic Bézier curve, up to rounding. Other edges between straight sides and vertices are straight.
//  3. Curved pieces are replaced by arcs of circles, and their chords, at most `outline_tolerance` away, decide which
//     edges there are. Edges between neighbouring chords, which lead to vertices that the curve does not have, are left
//     out. Nodes beside arcs of circles are right up to rounding; beside other curves they are within the tolerance,
//     mostly within a hundredth of it. An axis that ends in the middle of a smooth curve ends at its centre of
//     curvature, and that of a disk is a node without edges.
//  4. An edge beside a curve has tangents at its ends as the bisector has them; between, it leaves the bisector by at
//     most 1/1024 of the radius there.
//  5. The axis depends on the outline as a set, not on samples between vertices or on the order of contours.
//
// Cost: O(n log n) for n sides, some 50 us a side, on all cores where the outline has independent parts
// (internal/outline_parts.h), such as the houses of a town. A change of the outline computes the parts again that it
// changes, and visits all sides: an edit in a town of 60,000 sides takes 0.14 s.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "core/graph/structure.h"
#include "core/structures/inputs/contours.h"
#include "core/structures/inputs/curve_source_input.h"
#include "core/structures/inputs/samples.h"
#include "core/structures/outline/outline_graph.h"

namespace mes {

using OutlinePieceSlot = Slot<struct OutlinePieceTag>;

/// A straight piece of an edge, for measuring. It leaves an arc by at most 1/1024 of the radius there.
struct OutlinePiece {
  Vec2 from{}, to{};
  double radius_from = 0.0, radius_to = 0.0;
  OutlineEdgeSlot edge{};
};

class OutlineAxis final : public Structure {
 public:
  OutlineAxis(CurveSourceInput& source, Samples& samples, Contours& contours);

  const OutlineGraph& graph() const { return graph_; }
  /// Edge by edge, from its first node to its second.
  const Table<OutlinePieceSlot, OutlinePiece>& pieces() const { return pieces_; }
  /// Control point of an edge that is an arc of a parabola, or is nearly one beside a curve; nothing for straight edges.
  std::optional<Vec2> control(OutlineEdgeSlot edge) const;
  const ChangeSet<OutlineEdgeSlot>& changes() const { return no_changes<OutlineEdgeSlot>(); }

  void rebuild(JobControl& job) override;
  bool update(JobControl& job) override;
  void clear_changes() override {}
  std::size_t touched() const override { return 0; }
  StatList statistics() const override;
  std::vector<TableColumns> table_columns() const override;
  void explain(ElementKind kind, RowNumber row, Explanation& out) const override;

 private:
  struct Parabola;
  /// An independent part of the outline, and the part of the graph that belongs to it.
  struct Part {
    std::vector<OutlineSide> sides;
    OutlineGraphPart begin{};
    OutlineGraphPart end{};
  };
  std::optional<Parabola> parabola(OutlineEdgeSlot edge) const;
  bool is_parabola(OutlineEdgeSlot edge) const;
  std::optional<Vec2> control_beside_curve(OutlineEdgeSlot edge) const;
  void add_pieces(OutlineEdgeSlot edge);

  CurveSourceInput& source_;
  Samples& samples_;
  Contours& contours_;
  OutlineGraph graph_;
  std::vector<Part> parts_;  // sorted by their first sides
  Table<OutlinePieceSlot, OutlinePiece> pieces_;
  double tolerance_ = 0.0;  // of chords of curved pieces; 0: all sides are straight
};

}  // namespace mes
