// SPDX-License-Identifier: GPL-3.0-or-later
// The axis of the outline and the distances from it as columns.
#include "core/graph/table_maker.h"
#include "core/structures/outline/axis_deviation.h"
#include "core/structures/outline/outline_axis.h"

namespace mes {

std::vector<TableColumns> OutlineAxis::table_columns() const {
  const auto always = [](auto) { return true; };
  TableMaker<OutlineFeatureSlot> features("features", "Vertices and sides of the outline", graph_.features.size(),
                                          always);
  features.column("from", "The vertex, or one end of the side", graph_.features, &OutlineFeature::from);
  features.column("to", "The vertex, or the other end of the side", graph_.features, &OutlineFeature::to);
  features.computed("is_vertex", "A vertex, or a point where two sides cross",
                    [this](OutlineFeatureSlot row) { return graph_.features[row].is_point(); });

  features.computed("center", "Centre of the circle that a curved side is an arc of; no number for straight ones",
                    [this](OutlineFeatureSlot row) {
                      return graph_.features[row].center.value_or(Vec2{kNoValue, kNoValue});
                    });

  TableMaker<OutlineNodeSlot> nodes("nodes", "Ends of edges", graph_.nodes.size(), always);
  nodes.column("center", "Point of the axis", graph_.nodes, &OutlineNode::center);
  nodes.column("radius", "Distance from the outline; 0 at a corner", graph_.nodes, &OutlineNode::radius);

  TableMaker<OutlineEdgeSlot> edges("edges", "Edges of the axis, straight or curved", graph_.edges.size(), always);
  edges.set_kind(ElementKind::axis_piece);
  edges.reference("nodes", "Both ends", graph_.edges, &OutlineEdge::nodes, table_name(id(), "nodes"));
  edges.reference("features", "Nearest vertices or sides of the outline", graph_.edges, &OutlineEdge::features,
                  table_name(id(), "features"));
  edges.column("region", "Number of the region, from 0", graph_.edges, &OutlineEdge::region);
  edges.computed("is_parabola", "The edge is an arc of a parabola",
                 [this](OutlineEdgeSlot row) { return is_parabola(row); });
  edges.computed("control", "Control point of the edge as a quadratic Bézier curve; no number for straight edges",
                 [this](OutlineEdgeSlot row) {
                   return control(row).value_or(Vec2{kNoValue, kNoValue});
                 });

  TableMaker<OutlinePieceSlot> pieces("pieces", "Straight pieces of the edges, for measuring", pieces_.size(),
                                      always);
  pieces.column("from", "One end", pieces_, &OutlinePiece::from);
  pieces.column("to", "The other end", pieces_, &OutlinePiece::to);
  pieces.column("radius_from", "Distance of the one end from the outline", pieces_, &OutlinePiece::radius_from);
  pieces.column("radius_to", "Distance of the other end from the outline", pieces_, &OutlinePiece::radius_to);
  pieces.reference("edge", "Edge that the piece belongs to", pieces_, &OutlinePiece::edge, table_name(id(), "edges"));
  return taken(features, nodes, edges, pieces);
}

std::vector<TableColumns> AxisDeviation::table_columns() const {
  TableMaker<PieceSlot> pieces("pieces", "Pieces of both axes with their distance from the other one", pieces_.size(),
                               [](PieceSlot) { return true; });
  pieces.column("from", "One end", pieces_, &Piece::from);
  pieces.column("to", "The other end", pieces_, &Piece::to);
  pieces.column("distance", "Largest distance of a point of the piece from the other axis", pieces_,
                &Piece::distance);
  pieces.computed("is_of_outline", "The piece belongs to the axis of the outline",
                  [this](PieceSlot row) { return pieces_[row].is_of_outline; });
  return taken(pieces);
}

}  // namespace mes
